#include "app/describe/command_page.h"

#include <sstream>

#include "app/guide/markdown.h"

namespace underact::describe {
namespace {

using guide::cellText;
using guide::inCode;
using guide::listedInCode;
using guide::plainText;
using guide::sentence;

/// "`--rate N`", or the name of a positional argument.
std::string tagInCode(const Option& option) {
  std::string made;
  for (const std::string& name : option.names) made += (made.empty() ? "" : ", ") + name;
  if (!option.word.empty()) made += (made.empty() ? "" : " ") + option.word + (option.many ? " ..." : "");
  return inCode(made);
}

std::string meaning(const Option& option) {
  std::string made = cellText(sentence(option.what));
  if (!option.choices.empty()) made += " One of " + listedInCode(option.choices) + ".";
  if (!option.range.empty()) made += " From " + option.range + ".";
  return made;
}

void writeOptions(const Command& command, std::ostream& out) {
  std::ostringstream rows;
  for (const Option& option : command.options) {
    if (option.names == std::vector<std::string>{"-h", "--help"}) continue;
    rows << "| " << tagInCode(option) << " | " << meaning(option) << " | "
         << (option.required        ? "required"
             : option.usual.empty() ? ""
                                    : inCode(option.usual))
         << " |\n";
  }
  if (rows.str().empty()) return;
  out << "| option | meaning | default |\n|---|---|---|\n" << rows.str() << '\n';
}

void writeSection(const Command& command, const std::string& before, std::ostream& out) {
  const std::string name = before.empty() ? command.name : before + " " + command.name;
  out << (before.empty() ? "## " : "### ") << name << "\n\n";
  if (!command.what.empty()) out << plainText(sentence(command.what)) << "\n\n";
  writeOptions(command, out);
  if (!command.footer.empty()) out << guide::asBlock(command.footer) << '\n';
  for (const Command& below : command.commands) writeSection(below, name, out);
}

}  // namespace

std::string commandPage(const std::vector<Command>& programs) {
  std::ostringstream out;
  out << "# Command reference\n\n"
         "Every command and option, as `--help` prints them. This page is generated from the programs themselves. "
         "[Command line](command_line.md) explains their input and output.\n\n";
  for (const Command& program : programs) writeSection(program, {}, out);
  std::string text = out.str();
  text.pop_back();  // the empty line at the end
  return text;
}

}  // namespace underact::describe
