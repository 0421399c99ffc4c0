#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <vector>

// The parser of command lines is dear to compile, and its templates are made anew in every file that has its header:
// here is what our grammars ask of it, and command.cpp alone has it.
namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace underact::options {

struct DescribedCommand;

/// An option of a command, or what stands without a name. Copies are the same option; each call gives it back.
class Option {
 public:
  Option required() const;
  /// Words after it, at least and at most; most below 0: any number.
  Option expected(int least, int most) const;
  Option oneEachTime() const;  // of a list: one value each time that it is said
  Option withCommas() const;   // of a list: commas may stand between the values
  Option needs(Option other) const;
  Option excludes(Option other) const;

  Option range(int least, int most) const;
  Option range(double least, double most) const;
  Option nonNegative() const;
  Option positive() const;
  Option oneOf(std::vector<std::string> words) const;
  /// wrong: of a value, what is wrong with it; empty: nothing.
  Option check(std::function<std::string(const std::string& value)> wrong) const;

  Option word(const std::string& word) const;    // that help has in place of a value
  Option group(const std::string& title) const;  // in help
  Option usual(const std::string& text) const;   // what help says that it is by itself
  Option showUsual() const;                      // that is what stands there now
  Option whenSaid(std::function<void()> then) const;
  bool isSaid() const;

 private:
  friend class Command;
  explicit Option(CLI::Option& option) : option_(&option) {}
  CLI::Option* option_;
};

/// A command of a grammar, or the whole of it. Copies are the same command. Where values are put outlives the parsing.
class Command {
 public:
  /// A command below this one.
  Command add(const std::string& name, const std::string& what) const;
  void mustChoose() const;  // one of the commands below; said before they are added
  void footer(const std::string& text) const;
  /// do_it: called once all is parsed.
  void whenChosen(std::function<void()> do_it) const;

  /// names: "--rate", or, of what goes by its place, "file".
  Option option(const std::string& names, std::string& value, const std::string& what) const;
  Option option(const std::string& names, double& value, const std::string& what) const;
  Option option(const std::string& names, int& value, const std::string& what) const;
  Option option(const std::string& names, std::uint64_t& value, const std::string& what) const;
  Option option(const std::string& names, std::optional<int>& value, const std::string& what) const;
  Option option(const std::string& names, std::optional<double>& value, const std::string& what) const;
  Option option(const std::string& names, std::vector<double>& values, const std::string& what) const;
  Option option(const std::string& names, std::vector<std::string>& values, const std::string& what) const;
  /// take: called with what was said.
  Option option(const std::string& names, std::function<void(const std::string&)> take, const std::string& what) const;
  Option option(const std::string& names, std::function<void(const std::vector<std::string>&)> take,
                const std::string& what) const;
  /// value: the place among words of the one that was said.
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
  /// arguments: without the program's name. Done: the commands that were chosen have done their work. Told: help or the
  /// version, on out. Wrong: what is, on err.
  Parsed parse(std::vector<std::string> arguments, std::ostream& out, std::ostream& err) const;

 private:
  explicit Program(std::unique_ptr<CLI::App> app);
  std::unique_ptr<CLI::App> owned_;
};

/// For what a command is called to do, where the options that were said do not go together: parse() gives Wrong, and
/// says this.
[[noreturn]] void refuse(const std::string& sentence);

/// A number as options read it; none: it is none.
std::optional<double> numberOf(const std::string& text);

}  // namespace underact::options
