// Makes what a package carries besides the programs, from their own grammars, when it is built: man pages, and
// completion for shells. It is not installed.
#include <array>
#include <iostream>

#include "app/cli/command.h"
#include "app/describe/completion.h"
#include "app/describe/man_page.h"
#include "app/options/window_options.h"
#include "app/sweeper/command.h"

namespace underact::describe {
namespace {

Command ofProgram(const std::string& name) {
  const cli::Streams streams{std::cin, std::cout, std::cerr};
  cli::Exit exit = cli::Exit::Well;
  if (name == "underact-cli") return describe(*cli::makeGrammar(streams, exit));
  if (name == "underact-sweep") return describe(*sweep::makeGrammar(streams, nullptr, exit));
  if (name != "underact") return {};
  CLI::App program;
  options::WindowOptions options;
  options::addWindowOptions(program, options);
  return describe(program);
}

int run(const std::string& what, const std::string& name) {
  struct Row {
    const char* what;
    std::string (*make)(const Command&);
  };
  const Command program = ofProgram(name);
  for (const Row& row : std::array{Row{"man", manPage}, Row{"bash", bashCompletion}, Row{"zsh", zshCompletion},
                                   Row{"fish", fishCompletion}}) {
    if (what != row.what || program.name.empty()) continue;
    std::cout << row.make(program) << std::flush;
    return std::cout ? 0 : 4;
  }
  std::cerr << "underact-describe man|bash|zsh|fish underact|underact-cli|underact-sweep\n";
  return 2;
}

}  // namespace
}  // namespace underact::describe

int main(int argc, char** argv) {
  return underact::describe::run(argc == 3 ? argv[1] : "", argc == 3 ? argv[2] : "");
}
