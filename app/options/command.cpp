#include "app/options/command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <utility>

namespace underact::options {
namespace {

enum class Chosen : std::uint8_t {};

}  // namespace

Option Option::required() const {
  option_->required();
  return *this;
}

Option Option::expected(int min, int max) const {
  option_->expected(min, max);
  return *this;
}

Option Option::oneEachTime() const {
  option_->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  return *this;
}

Option Option::withCommas() const {
  option_->delimiter(',');
  return *this;
}

Option Option::needs(Option other) const {
  option_->needs(other.option_);
  return *this;
}

Option Option::excludes(Option other) const {
  option_->excludes(other.option_);
  return *this;
}

Option Option::range(int min, int max) const {
  option_->check(CLI::Range(min, max));
  return *this;
}

Option Option::range(double min, double max) const {
  option_->check(CLI::Range(min, max));
  return *this;
}

Option Option::nonNegative() const {
  option_->check(CLI::NonNegativeNumber);
  return *this;
}

Option Option::positive() const {
  option_->check(CLI::PositiveNumber);
  return *this;
}

Option Option::oneOf(std::vector<std::string> words) const {
  option_->check(CLI::IsMember(std::move(words)));
  return *this;
}

Option Option::check(std::function<std::string(const std::string& value)> wrong) const {
  option_->check(std::move(wrong));
  return *this;
}

Option Option::word(const std::string& word) const {
  option_->type_name(word);
  return *this;
}

Option Option::group(const std::string& title) const {
  option_->group(title);
  return *this;
}

Option Option::defaultText(const std::string& text) const {
  option_->default_str(text);
  return *this;
}

Option Option::showDefault() const {
  option_->capture_default_str();
  return *this;
}

Option Option::whenGiven(std::function<void()> then) const {
  option_->each([then = std::move(then)](const std::string&) { then(); });
  return *this;
}

bool Option::isGiven() const {
  return option_->count() > 0;
}

Command Command::add(const std::string& name, const std::string& what) const {
  return Command(*app_->add_subcommand(name, what));
}

void Command::mustChoose() const {
  app_->require_subcommand(1);
}

void Command::footer(const std::string& text) const {
  app_->footer(text);
}

void Command::whenChosen(std::function<void()> do_it) const {
  app_->callback(std::move(do_it));
}

Option Command::option(const std::string& names, std::string& value, const std::string& what) const {
  return Option(*app_->add_option(names, value, what));
}

Option Command::option(const std::string& names, double& value, const std::string& what) const {
  return Option(*app_->add_option(names, value, what));
}

Option Command::option(const std::string& names, int& value, const std::string& what) const {
  return Option(*app_->add_option(names, value, what));
}

Option Command::option(const std::string& names, std::uint64_t& value, const std::string& what) const {
  return Option(*app_->add_option(names, value, what));
}

Option Command::option(const std::string& names, std::optional<int>& value, const std::string& what) const {
  return Option(*app_->add_option(names, value, what));
}

Option Command::option(const std::string& names, std::optional<double>& value, const std::string& what) const {
  return Option(*app_->add_option(names, value, what));
}

Option Command::option(const std::string& names, std::vector<double>& values, const std::string& what) const {
  return Option(*app_->add_option(names, values, what));
}

Option Command::option(const std::string& names, std::vector<std::string>& values, const std::string& what) const {
  return Option(*app_->add_option(names, values, what));
}

Option Command::option(const std::string& names, std::function<void(const std::string&)> take,
                       const std::string& what) const {
  return Option(*app_->add_option_function<std::string>(names, take, what));
}

Option Command::option(const std::string& names, std::function<void(const std::vector<std::string>&)> take,
                       const std::string& what) const {
  return Option(*app_->add_option_function<std::vector<std::string>>(names, take, what));
}

Option Command::choice(const std::string& names, const std::vector<std::string>& words,
                       std::optional<std::size_t>& value, const std::string& what) const {
  std::vector<std::pair<std::string, Chosen>> places;
  for (const std::string& word : words) places.emplace_back(word, static_cast<Chosen>(places.size()));
  const auto take = [&value](const Chosen& chosen) { value = static_cast<std::size_t>(chosen); };
  return Option(*app_->add_option_function<Chosen>(names, take, what)
                     ->transform(CLI::CheckedTransformer(places).description(CLI::detail::generate_set(words))));
}

Option Command::flag(const std::string& names, bool& value, const std::string& what) const {
  return Option(*app_->add_flag(names, value, what));
}

Program::Program(const std::string& name, const std::string& what) : Program(std::make_unique<CLI::App>(what, name)) {}

Program::Program(std::unique_ptr<CLI::App> app) : Command(*app), owned_(std::move(app)) {
  app_->failure_message(CLI::FailureMessage::simple);
}

Program::Program(Program&&) noexcept = default;

Program::~Program() = default;

std::string Program::name() const {
  return app_->get_name();
}

void Program::version(const std::string& text) const {
  app_->set_version_flag("--version", text, "Print the version and exit");
}

Parsed Program::parse(std::vector<std::string> arguments, std::ostream& out, std::ostream& err) const {
  std::reverse(arguments.begin(), arguments.end());  // as CLI11 wants them
  try {
    app_->parse(std::move(arguments));
  } catch (const CLI::ParseError& error) {
    // Help and version also come this way, with 0.
    return app_->exit(error, out, err) == 0 ? Parsed::Told : Parsed::Wrong;
  }
  return Parsed::Done;
}

void refuse(const std::string& sentence) {
  throw CLI::ValidationError(sentence);
}

std::optional<double> numberOf(const std::string& text) {
  double number = 0.0;
  if (!CLI::detail::lexical_cast(text, number)) return {};
  return number;
}

}  // namespace underact::options
