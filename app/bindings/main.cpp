#include <pybind11/pybind11.h>

#include "app/bindings/made.h"
#include "app/bindings/parts.h"
#include "underact/version.h"

#if defined(__GLIBC__)
/// glibc's own is data of another library, which our objects do not look for (cmake/python_module.cmake). Of the
/// standard library in this module: whether it may count references without atomic operations. Python has threads.
extern "C" {
char __libc_single_threaded = 0;  // NOLINT: glibc's name
}
#endif

PYBIND11_MODULE(_core, core) {
  underact::bindings::refuseBase();
  core.doc() = "The program's own mathematics; underact.arm and the modules beside it are what it is for.";
  core.attr("__version__") = underact::kVersion;
  underact::bindings::addArm(core);
  underact::bindings::addScene(core);
  underact::bindings::addSim(core);
}
