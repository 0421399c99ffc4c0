#include "app/options/described.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <sstream>

namespace underact::options {
namespace {

/// The part of CLI11's text of a type between two marks, and the text without it: "TEXT:{a,b}" has "a,b" and "TEXT:".
std::string takeBetween(std::string& text, const std::string& from, const std::string& to) {
  const std::size_t start = text.find(from);
  const std::size_t end = start == std::string::npos ? start : text.find(to, start + from.size());
  if (end == std::string::npos) return {};
  std::string part = text.substr(start + from.size(), end - start - from.size());
  text.erase(start, end + to.size() - start);
  return part;
}

/// "a,b", or, of words that stand for something, "a->1,b->2".
std::vector<std::string> choicesOf(const std::string& text) {
  std::vector<std::string> choices;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, ',');) choices.push_back(part.substr(0, part.find("->")));
  return choices;
}

std::string wordOf(const std::string& type) {
  if (type.rfind("INT", 0) == 0 || type.rfind("UINT", 0) == 0) return "N";
  if (type.rfind("FLOAT", 0) == 0) return "NUMBER";
  // A check follows a colon; in "KIND[:ADDRESS]" it is a part of the word.
  const std::size_t inside = type.find('['), end = type.find(':');
  return inside < end ? type : type.substr(0, end);
}

DescribedOption described(const CLI::Option& option) {
  DescribedOption made;
  for (const std::string& name : option.get_snames()) made.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) made.names.push_back("--" + name);
  made.what = option.get_description();
  made.required = option.get_required();
  made.many = option.get_expected_max() > 1;
  if (option.get_type_size_max() == 0) return made;  // a flag
  std::string type = option.get_type_name();
  made.choices = choicesOf(takeBetween(type, "{", "}"));
  made.range = takeBetween(type, " in [", "]");
  if (const std::size_t dash = made.range.find(" - "); dash != std::string::npos) made.range.replace(dash, 3, " to ");
  made.word = wordOf(type);
  if (made.names.empty() && made.word == "TEXT") made.word = option.get_single_name();
  std::transform(made.word.begin(), made.word.end(), made.word.begin(),
                 [](unsigned char c) { return std::toupper(c); });
  made.default_value = option.get_default_str();
  return made;
}

DescribedCommand described(const CLI::App& command) {
  DescribedCommand made{command.get_name(), command.get_description(), command.get_footer(), {}, {}};
  for (const CLI::Option* option : command.get_options()) made.options.push_back(described(*option));
  for (const CLI::App* below : command.get_subcommands([](const CLI::App*) { return true; }))
    made.commands.push_back(described(*below));
  return made;
}

}  // namespace

DescribedCommand describe(Command command) {
  return described(*command.app_);
}

}  // namespace underact::options
