#include "app/cli/python.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <ostream>

#include "core/system/file.h"
#include "core/system/process.h"
#include "core/system/resource_paths.h"

namespace underact::cli {
namespace {

/// Starts the package of the folder that is the first word. Python looks for modules in the folder one stands in ('',
/// of -c and -m), where a session may lie beside a stranger's h5py.py; -P, which leaves that out, comes with 3.11, and
/// -I would leave out what a person installed with pip --user. The package itself comes from its folder alone, which is
/// not made a place for others: Debian's dist-packages would hide that person's. Matplotlib takes its settings, which
/// can start a TeX, from a file in that folder, too.
constexpr const char* kLauncher = R"(import sys
sys.path[:] = [place for place in sys.path if place.startswith('/')]
import importlib.machinery, importlib.util, os, runpy
if os.path.exists('matplotlibrc'):
    here = os.open('.', os.O_RDONLY)
    os.chdir('/')
    try: import matplotlib
    except ImportError: pass
    os.fchdir(here)
    os.close(here)
spec = importlib.machinery.PathFinder.find_spec('underact', [sys.argv.pop(1)])
sys.argv[0] = '-m'
sys.modules['underact'] = package = importlib.util.module_from_spec(spec)
if spec.loader: spec.loader.exec_module(package)
runpy.run_module('underact', run_name='__main__', alter_sys=True))";

/// Debian's, if it exists: it has Debian's libraries.
std::string interpreter() {
  const char* const chosen = std::getenv("UNDERACT_PYTHON");
  if (chosen != nullptr && *chosen != '\0') return chosen;
  return system::mayExecute("/usr/bin/python3") ? "/usr/bin/python3" : "python3";
}

}  // namespace

Exit runPython(const std::vector<std::string>& arguments, const Streams& streams) {
  const Result<std::string> package = system::findResource(system::Resource::Python);
  if (!package) {
    streams.err << package.problems().front().sentence << '\n';  // alone: a window shows the last line
    return Exit::File;
  }
  streams.out.flush();
  std::vector<std::string> words{interpreter(), "-c", kLauncher, package.value()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const std::optional<system::End> ended = system::runHere(words, "PYTHONPATH");  // modules of other programs
  if (ended) return ended->by_signal ? Exit::File : static_cast<Exit>(ended->code);
  streams.err << "Python could not be started (" << words.front() << "): " << std::strerror(errno)
              << ". Install python3, python3-h5py and python3-matplotlib, or set UNDERACT_PYTHON.\n";
  return Exit::File;
}

}  // namespace underact::cli
