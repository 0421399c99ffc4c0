// Generates the other files of a package from the grammars of the programs when it is built: man pages, and
// completion for shells; the guide's pages of commands, scene keys, scenes and a session's columns; and the guide as
// static pages. It is not installed.
#include <array>
#include <iostream>

#include "app/cli/command.h"
#include "app/describe/command_page.h"
#include "app/describe/completion.h"
#include "app/describe/man_page.h"
#include "app/guide/make.h"
#include "app/options/window_options.h"
#include "app/sweeper/command.h"
#include "core/record/columns_text.h"

namespace underact::describe {
namespace {

Command ofProgram(const std::string& name) {
  const cli::Streams streams{std::cin, std::cout, std::cerr};
  cli::Exit exit = cli::Exit::Success;
  if (name == "underact-cli") return options::describe(cli::makeGrammar(streams, exit));
  if (name == "underact-sweep") return options::describe(sweep::makeGrammar(streams, nullptr, exit));
  if (name != "underact") return {};
  options::WindowOptions options;
  return options::describe(options::windowGrammar(options));
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
  std::cerr << "underact-describe man|bash|zsh|fish underact|underact-cli|underact-sweep\n"
               "underact-describe commands\n"
               "underact-describe scene-schema SCHEMA\n"
               "underact-describe scene-keys SCHEMA\n"
               "underact-describe scene-list FOLDER\n"
               "underact-describe session-columns\n"
               "underact-describe columns-json\n"
               "underact-describe guide FOLDER OUT\n";
  return 2;
}

int print(const std::string& text) {
  std::cout << text << std::flush;
  return std::cout ? 0 : 4;
}

int run(const std::vector<std::string>& words) {
  if (words.size() == 1 && words[0] == "commands") {
    std::cout << commandPage({ofProgram("underact"), ofProgram("underact-cli"), ofProgram("underact-sweep")})
              << std::flush;
    return std::cout ? 0 : 4;
  }
  if (words.size() == 1 && words[0] == "session-columns") return print(record::columnsPage());
  if (words.size() == 1 && words[0] == "columns-json") return print(record::columnsJson() + "\n");
  if (words.size() == 2 && words[0] == "scene-schema") return guide::printSceneSchema(words[1], std::cout, std::cerr);
  if (words.size() == 2 && words[0] == "scene-keys") return guide::printSceneKeys(words[1], std::cout, std::cerr);
  if (words.size() == 2 && words[0] == "scene-list") return guide::printSceneList(words[1], std::cout, std::cerr);
  if (words.size() == 3 && words[0] == "guide") return guide::makeSite(words[1], words[2], std::cerr);
  return run(words.size() == 2 ? words[0] : "", words.size() == 2 ? words[1] : "");
}

}  // namespace
}  // namespace underact::describe

int main(int argc, char** argv) {
  return underact::describe::run({argv + 1, argv + argc});
}
