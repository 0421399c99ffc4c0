#include <sstream>

#include "app/describe/completion.h"
#include "app/describe/shell_words.h"

namespace underact::describe {
namespace {

/// Text inside a specification of _arguments, where brackets and colons have a meaning.
std::string plain(const std::string& text) {
  std::string made;
  for (const char letter : text) {
    if (letter == '[' || letter == ']' || letter == ':' || letter == '\\') made += '\\';
    made += letter;
  }
  return made;
}

/// ":FILE:_files", or ":WAY:(auto fifo)".
std::string value(const Option& option) {
  if (option.word.empty()) return {};
  std::string made = ":" + plain(option.word) + ":";
  if (option.choices.empty()) return made + "_files";
  made += "(";
  for (const std::string& choice : option.choices) made += (made.back() == '(' ? "" : " ") + choice;
  return made + ")";
}

void writeFunction(const Command& command, const std::string& name, std::ostream& out) {
  out << name << "() {\n  local curcontext=$curcontext state line ret=1\n  _arguments -C";
  for (const Option& option : command.options) {
    for (const std::string& one : option.names)
      out << " \\\n    "
          << inApostrophes((option.many ? "*" : "") + one + "[" + plain(option.what) + "]" + value(option));
    if (option.names.empty()) out << " \\\n    " << inApostrophes((option.many ? "*" : "") + value(option));
  }
  if (command.commands.empty()) {
    out << " && ret=0\n  return ret\n}\n";
    return;
  }
  out << " \\\n    '1: :->command' '*:: :->rest' && ret=0\n  case $state in\n  command)\n    local -a all=(\n";
  for (const Command& below : command.commands)
    out << "      " << inApostrophes(plain(below.name) + ":" + below.what) << '\n';
  out << "    )\n    _describe command all && ret=0;;\n  rest)\n    case $words[1] in\n";
  for (const Command& below : command.commands)
    out << "    " << below.name << ") " << name << '_' << functionName(below.name).substr(1) << " && ret=0;;\n";
  out << "    esac;;\n  esac\n  return ret\n}\n";
}

}  // namespace

std::string zshCompletion(const Command& program) {
  std::ostringstream out;
  out << "#compdef " << program.name << '\n';
  const std::string name = functionName(program.name);
  visitAll(program, [&](const Command& command, const std::string& path) {
    std::string below = name;
    for (const char letter : path) below += letter == ' ' || letter == '-' ? '_' : letter;
    writeFunction(command, below, out);
  });
  out << name << " \"$@\"\n";
  return out.str();
}

}  // namespace underact::describe
