#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <vector>

// The parser of command lines is slow to compile, and its templates are instantiated in every file that includes it:
// this is what our grammars need of it, and only command.cpp includes it.
namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace underact::options {

struct DescribedCommand;

/// An option of a command, or a positional argument. Copies are the same option; each call returns it.
class Option {
 public:
  Option required() const;
  /// Number of values, at least and at most; most below 0: any number.
  Option expected(int min, int max) const;
  Option oneEachTime() const;  // of a list: one value each time that it is given
  Option withCommas() const;   // of a list: the values may be separated by commas
  Option needs(Option other) const;
  Option excludes(Option other) const;

  Option range(int min, int max) const;
  Option range(double min, double max) const;
  Option nonNegative() const;
  Option positive() const;
  Option oneOf(std::vector<std::string> words) const;
  /// wrong: what is wrong with a value; empty: nothing.
  Option check(std::function<std::string(const std::string& value)> wrong) const;

  Option word(const std::string& word) const;         // the placeholder of the value in help
  Option group(const std::string& title) const;       // in help
  Option defaultText(const std::string& text) const;  // the default as help shows it
  Option showDefault() const;                         // the default is the present value
  Option whenGiven(std::function<void()> then) const;
  bool isGiven() const;

 private:
  friend class Command;
  explicit Option(CLI::Option& option) : option_(&option) {}
  CLI::Option* option_;
};

/// A command of a grammar, or the whole grammar. Copies are the same command. The values have to outlive the parsing.
class Command {
 public:
  /// A subcommand of this one.
  Command add(const std::string& name, const std::string& what) const;
  void mustChoose() const;  // one of the subcommands; call it before they are added
  void footer(const std::string& text) const;
  /// do_it: called once all is parsed.
  void whenChosen(std::function<void()> do_it) const;

  /// names: "--rate", or "file" for a positional argument.
  Option option(const std::string& names, std::string& value, const std::string& what) const;
  Option option(const std::string& names, double& value, const std::string& what) const;
  Option option(const std::string& names, int& value, const std::string& what) const;
  Option option(const std::string& names, std::uint64_t& value, const std::string& what) const;
  Option option(const std::string& names, std::optional<int>& value, const std::string& what) const;
  Option option(const std::string& names, std::optional<double>& value, const std::string& what) const;
  Option option(const std::string& names, std::vector<double>& values, const std::string& what) const;
  Option option(const std::string& names, std::vector<std::string>& values, const std::string& what) const;
  /// take: called with the given value.
  Option option(const std::string& names, std::function<void(const std::string&)> take, const std::string& what) const;
  Option option(const std::string& names, std::function<void(const std::vector<std::string>&)> take,
                const std::string& what) const;
  /// value: the index among words of the given one.
  Option choice(const std::string& names, const std::vector<std::string>& words, std::optional<std::size_t>& value,
                const std::string& what) const;
  Option flag(const std::string& names, bool& value, const std::string& what) const;

  friend DescribedCommand describe(Command command);

 protected:
  explicit Command(CLI::App& app) : app_(&app) {}
  CLI::App* app_;
};

enum class Parsed { Done, Told, Wrong };

/// The grammar of a program, with --help.
class Program : public Command {
 public:
  Program(const std::string& name, const std::string& what);
  Program(Program&&) noexcept;
  ~Program();

  std::string name() const;
  void version(const std::string& text) const;  // --version
  /// arguments: without the program's name. Done: the chosen commands have done their work. Told: help or the version
  /// was printed on out. Wrong: the error was printed on err.
  Parsed parse(std::vector<std::string> arguments, std::ostream& out, std::ostream& err) const;

 private:
  explicit Program(std::unique_ptr<CLI::App> app);
  std::unique_ptr<CLI::App> owned_;
};

/// For use in a command, if the given options cannot be combined: parse() returns Wrong and prints this.
[[noreturn]] void refuse(const std::string& sentence);

/// A number as options read it; none: the text is not a number.
std::optional<double> numberOf(const std::string& text);

}  // namespace underact::options
