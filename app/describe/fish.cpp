#include <iomanip>
#include <sstream>

#include "app/describe/completion.h"
#include "app/describe/shell_words.h"

namespace underact::describe {
namespace {

void writeRules(const Command& command, const std::string& start, std::ostream& out) {
  for (const Command& below : command.commands)
    out << start << " -f -a " << below.name << " -d " << inApostrophes(below.what) << '\n';
  for (const Option& option : command.options) {
    if (option.names.empty()) continue;
    out << start;
    for (const std::string& name : option.names)
      out << (name.rfind("--", 0) == 0 ? " -l " + name.substr(2) : " -s " + name.substr(1));
    if (!option.word.empty()) out << " -r";
    if (!option.choices.empty()) {
      std::string all;
      for (const std::string& choice : option.choices) all += (all.empty() ? "" : " ") + choice;
      out << " -f -a " << std::quoted(all);
    }
    out << " -d " << inApostrophes(option.what) << '\n';
  }
}

}  // namespace

std::string fishCompletion(const Command& program) {
  const std::string at = "_" + functionName(program.name) + "_at";
  std::ostringstream paths, rules;
  visitAll(program, [&](const Command& command, const std::string& path) {
    if (!path.empty()) paths << ' ' << inApostrophes(path);
    writeRules(command, "complete -c " + program.name + " -n " + inApostrophes(at + " \"" + path + "\""), rules);
  });
  std::ostringstream out;
  out << "# fish completion for " << program.name << "\n"
      << "# True where the words that are there lead to the command of that path.\n"
      << "function " << at << "\n"
      << "  set -l path ''\n"
      << "  for word in (commandline -opc)[2..-1]\n"
      << "    if contains -- \"$path $word\"" << paths.str() << "\n"
      << "      set path \"$path $word\"\n"
      << "    end\n"
      << "  end\n"
      << "  test \"$path\" = \"$argv[1]\"\n"
      << "end\n"
      << rules.str();
  return out.str();
}

}  // namespace underact::describe
