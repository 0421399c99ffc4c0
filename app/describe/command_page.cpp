#include "app/describe/command_page.h"

#include <algorithm>
#include <map>
#include <sstream>

#include "app/guide/markdown.h"
#include "app/page/html.h"

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

/// What was printed, and the section that has it first.
using Places = std::map<std::string, std::string>;
constexpr std::size_t kWorthALink = 2;  // rows: one alone is printed again

std::string linkTo(const std::string& section) {
  return "[`" + section + "`](#" + page::anchorOf(section) + ")";
}

std::string rowOf(const Option& option) {
  return "| " + tagInCode(option) + " | " + meaning(option) + " | " +
         (option.required                ? "required"
          : option.default_value.empty() ? ""
                                         : inCode(option.default_value)) +
         " |\n";
}

/// Options that an earlier section describes in the same words are named with a link to it.
void writeOptions(const Command& command, const std::string& name, Places& places, std::ostream& out) {
  std::map<std::string, std::vector<std::string>> earlier;
  std::vector<const Option*> options;
  for (const Option& option : command.options) {
    if (option.names == std::vector<std::string>{"-h", "--help"}) continue;
    options.push_back(&option);
    const auto place = places.find(rowOf(option));
    if (place != places.end() && !option.names.empty()) earlier[place->second].push_back(option.names.back());
  }
  std::erase_if(earlier, [](const auto& section) { return section.second.size() < kWorthALink; });
  std::string rows, links;
  for (const Option* option : options) {
    const std::string row = rowOf(*option);
    const auto [place, is_new] = places.try_emplace(row, name);
    if (is_new || option->names.empty() || !earlier.contains(place->second)) rows += row;
  }
  for (const auto& [section, names] : earlier)
    links += "As of " + linkTo(section) + ": " + listedInCode(names) + ".\n\n";
  if (!rows.empty()) out << "| option | meaning | default |\n|---|---|---|\n" << rows << '\n';
  out << links;
}

/// A list that an earlier section has, too, is a link to it.
void writeFooter(const std::string& footer, const std::string& name, Places& places, std::ostream& out) {
  std::string text, links;
  for (std::size_t at = 0; at < footer.size();) {
    const std::size_t end = std::min(footer.find("\n\n", at), footer.size());
    const std::string part = footer.substr(at, end - at);
    const std::string title = part.substr(0, part.find('\n'));
    at = end + 2;
    const auto [place, is_new] = places.try_emplace(part, name);
    if (is_new || !title.ends_with(':'))
      text += (text.empty() ? "" : "\n\n") + part;
    else
      links += title + " see " + linkTo(place->second) + ".\n\n";
  }
  if (!text.empty()) out << guide::asBlock(text) << '\n';
  out << links;
}

void writeSection(const Command& command, const std::string& before, Places& places, std::ostream& out) {
  const std::string name = before.empty() ? command.name : before + " " + command.name;
  out << (before.empty() ? "## " : "### ") << name << "\n\n";
  if (!command.what.empty()) out << plainText(sentence(command.what)) << "\n\n";
  writeOptions(command, name, places, out);
  writeFooter(command.footer, name, places, out);
  for (const Command& below : command.commands) writeSection(below, name, places, out);
}

}  // namespace

std::string commandPage(const std::vector<Command>& programs) {
  std::ostringstream out;
  out << "# Command reference\n\n"
         "Every command and option, as `--help` prints them. This page is generated from the programs themselves. "
         "[Command line](command_line.md) explains their input and output.\n\n";
  Places places;
  for (const Command& program : programs) writeSection(program, {}, places, out);
  std::string text = out.str();
  text.pop_back();  // the empty line at the end
  return text;
}

}  // namespace underact::describe
