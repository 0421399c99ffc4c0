#include <iomanip>
#include <sstream>

#include "app/describe/completion.h"
#include "app/describe/shell_words.h"

namespace underact::describe {
namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : " ") + word;
  return all;
}

/// What an option's value can be: one of a few words, or, with an empty reply, a file.
void writeValues(const Command& command, const std::string& path, std::ostream& out) {
  for (const Option& option : command.options) {
    if (option.word.empty()) continue;
    for (const std::string& name : option.names) {
      out << "    " << inApostrophes(path + " " + name) << ") ";
      if (!option.choices.empty())
        out << "COMPREPLY=($(compgen -W " << inApostrophes(joined(option.choices)) << " -- \"$cur\")); ";
      out << "return;;\n";
    }
  }
}

void writeWords(const Command& command, const std::string& path, std::ostream& out) {
  std::string options, commands;
  for (const Option& option : command.options) {
    if (!option.names.empty()) options += (options.empty() ? "" : " ") + joined(option.names);
  }
  for (const Command& below : command.commands) commands += (commands.empty() ? "" : " ") + below.name;
  out << "    " << inApostrophes(path) << ") options=" << std::quoted(options) << " commands=" << std::quoted(commands)
      << ";;\n";
}

}  // namespace

std::string bashCompletion(const Command& program) {
  std::ostringstream values, words, paths;
  visitAll(program, [&](const Command& command, const std::string& path) {
    writeValues(command, path, values);
    writeWords(command, path, words);
    if (!path.empty()) paths << (paths.tellp() == 0 ? "" : "|") << inApostrophes(path);
  });
  const std::string known = paths.str().empty() ? "''" : paths.str();
  const std::string name = functionName(program.name);
  std::ostringstream out;
  out << "# bash completion for " << program.name << "\n"
      << name << "() {\n"
      << "  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD - 1]} path= options= commands= i\n"
      << "  COMPREPLY=()\n"
      << "  for ((i = 1; i < COMP_CWORD; i++)); do\n"
      << "    case \"$path ${COMP_WORDS[i]}\" in " << known << ") path=\"$path ${COMP_WORDS[i]}\";; esac\n"
      << "  done\n"
      << "  case \"$path $prev\" in\n"
      << values.str() << "  esac\n"
      << "  case $path in\n"
      << words.str() << "  esac\n"
      << "  if [[ $cur == -* ]]; then\n"
      << "    COMPREPLY=($(compgen -W \"$options\" -- \"$cur\"))\n"
      << "  elif [[ -n $commands ]]; then\n"
      << "    COMPREPLY=($(compgen -W \"$commands\" -- \"$cur\"))\n"
      << "  fi\n"
      << "}\n"
      << "complete -o default -F " << name << ' ' << program.name << '\n';
  return out.str();
}

}  // namespace underact::describe
