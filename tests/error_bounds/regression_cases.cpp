#include "tests/error_bounds/regression_cases.h"

#include <charconv>

#include "tests/error_bounds/input.h"

namespace underact::error_bounds {
namespace {

constexpr std::string_view kHeader = "key,error_ulp,input";

/// The part before the next separator; the text continues after it.
std::string_view upTo(char separator, std::string_view& text) {
  const std::size_t end = text.find(separator);
  const std::string_view part = text.substr(0, end);
  text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
  return part;
}

bool readNumber(std::string_view text, double& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size();
}

}  // namespace

std::string textOf(std::span<const RegressionCase> kept) {
  std::string text = std::string(kHeader) + '\n';
  for (const RegressionCase& one : kept) {
    text += one.key + ',' + textOf(one.error_ulp) + ',';
    for (std::size_t i = 0; i < one.input.size(); ++i) text += (i == 0 ? "" : " ") + textOf(one.input[i]);
    text += '\n';
  }
  return text;
}

Result<std::vector<RegressionCase>> readRegressionCases(std::string_view text, const std::string& file_name) {
  std::vector<RegressionCase> all;
  Problems problems;
  for (int line = 1; !text.empty(); ++line) {
    std::string_view row = upTo('\n', text);
    if (row.empty() || (line == 1 && row == kHeader)) continue;
    RegressionCase kept;
    kept.key = upTo(',', row);
    bool good = readNumber(upTo(',', row), kept.error_ulp) && !kept.key.empty();
    while (good && !row.empty()) {
      kept.input.emplace_back();
      good = readNumber(upTo(' ', row), kept.input.back());
    }
    if (!good) problems.push_back({"This is not a key, an error and numbers.", {file_name, line, 0, kept.key}});
    all.push_back(std::move(kept));
  }
  if (!problems.empty()) return problems;
  return all;
}

}  // namespace underact::error_bounds
