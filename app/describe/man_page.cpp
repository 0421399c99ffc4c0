#include "app/describe/man_page.h"

#include <underact/version.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>

#include "app/guide/markdown.h"

namespace underact::describe {
namespace {

using guide::sentence;

/// Escapes what troff would interpret: a dash is a hyphen, a backslash its escape, and a line's first dot a request.
std::string escaped(const std::string& text) {
  std::string made;
  bool starts_line = true;
  for (const char letter : text) {
    if (starts_line && (letter == '.' || letter == '\'')) made += "\\&";
    if (letter == '\\')
      made += "\\e";
    else if (letter == '-')
      made += "\\-";
    else
      made += letter;
    starts_line = letter == '\n';
  }
  return made;
}

std::string bold(const std::string& text) {
  return "\\fB" + escaped(text) + "\\fR";
}
std::string slanted(const std::string& text) {
  return "\\fI" + escaped(text) + "\\fR";
}

/// "--rate N", or the name of a positional argument.
std::string tagInBold(const Option& option) {
  std::string made;
  for (const std::string& name : option.names) made += (made.empty() ? "" : ", ") + bold(name);
  if (!option.word.empty()) made += (made.empty() ? "" : " ") + slanted(option.word) + (option.many ? " ..." : "");
  return made;
}

void writeOption(const Option& option, std::ostream& out) {
  out << ".TP\n" << tagInBold(option) << '\n' << escaped(sentence(option.what));
  if (!option.choices.empty()) {
    std::string all;
    for (const std::string& choice : option.choices) all += (all.empty() ? "" : ", ") + bold(choice);
    out << "\nOne of: " << all << '.';
  }
  if (!option.range.empty()) out << "\nFrom " << escaped(option.range) << '.';
  if (!option.default_value.empty()) out << "\nDefault: " << bold(option.default_value) << '.';
  if (option.required) out << "\nRequired.";
  out << '\n';
}

void writeLines(const std::string& text, std::ostream& out) {
  if (!text.empty()) out << ".PP\n.nf\n" << escaped(text) << "\n.fi\n";
}

/// A command, and its subcommands: "lab trade".
void writeSubsection(const Command& command, const std::string& before, std::ostream& out) {
  const std::string name = before.empty() ? command.name : before + " " + command.name;
  out << ".SS " << escaped(name) << '\n' << escaped(sentence(command.what)) << '\n';
  for (const Option& option : command.options) {
    if (option.names != std::vector<std::string>{"-h", "--help"}) writeOption(option, out);
  }
  writeLines(command.footer, out);
  for (const Command& below : command.commands) writeSubsection(below, name, out);
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

/// The first sentence without its full stop, for the line NAME.
std::string brief(const std::string& what) {
  return what.substr(0, std::min(what.find(':'), what.find('.')));
}

}  // namespace

std::string manPage(const Command& program) {
  std::ostringstream out;
  out << ".TH " << upper(escaped(program.name)) << " 1 \"\" \"Underact " << kVersion << "\" \"Underact\"\n";
  out << ".SH NAME\n" << escaped(program.name) << " \\- " << escaped(brief(program.what)) << '\n';
  out << ".SH SYNOPSIS\n.B " << escaped(program.name) << "\n[" << slanted("OPTION") << "]...";
  if (!program.commands.empty()) out << ' ' << slanted("COMMAND") << " [" << slanted("ARGUMENT") << "]...";
  for (const Option& option : program.options) {
    if (option.names.empty()) out << " [" << slanted(option.word) << ']';
  }
  out << "\n.SH DESCRIPTION\n" << escaped(sentence(program.what)) << '\n';
  if (!program.footer.empty()) out << ".PP\n" << escaped(program.footer) << '\n';
  out << ".SH OPTIONS\n";
  for (const Option& option : program.options) writeOption(option, out);
  if (!program.commands.empty()) out << ".SH COMMANDS\n";
  for (const Command& command : program.commands) writeSubsection(command, "", out);
  out << ".SH EXIT STATUS\n";
  struct Row {
    int status;
    const char* what;
  };
  for (const Row& row :
       std::array{Row{0, "Success."}, Row{1, "Invalid input: a scene, numbers, a session."}, Row{2, "Wrong usage."},
                  Row{3, "A fault of the arm or the servo."}, Row{4, "A file could not be read or written."}})
    out << ".TP\n" << bold(std::to_string(row.status)) << '\n' << row.what << '\n';
  out << ".SH SEE ALSO\n";
  std::string others;
  for (const char* other : {"underact", "underact-cli", "underact-sweep"}) {
    if (other != program.name) others += (others.empty() ? ".BR " : " ,\n.BR ") + escaped(other) + " (1)";
  }
  out << others << '\n';
  return out.str();
}

}  // namespace underact::describe
