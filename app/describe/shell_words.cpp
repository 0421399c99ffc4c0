#include "app/describe/shell_words.h"

#include <algorithm>

namespace underact::describe {
namespace {

void visitBelow(const Command& command, const std::string& path,
                const std::function<void(const Command&, const std::string& path)>& visit) {
  visit(command, path);
  for (const Command& below : command.commands) visitBelow(below, path + " " + below.name, visit);
}

}  // namespace

std::string functionName(const std::string& program) {
  std::string name = "_" + program;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

std::string inApostrophes(const std::string& text) {
  std::string made = "'";
  for (const char letter : text) {
    // Ends the quotes, adds an apostrophe, and opens them again: understood by bash, zsh and fish.
    if (letter == '\'')
      made += "'\\''";
    else
      made += letter;
  }
  return made + "'";
}

void visitAll(const Command& program, const std::function<void(const Command&, const std::string& path)>& visit) {
  visitBelow(program, "", visit);
}

}  // namespace underact::describe
