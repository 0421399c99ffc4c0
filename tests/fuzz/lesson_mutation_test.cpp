#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "core/json/text.h"
#include "tests/core/lesson/lesson_support.h"
#include "tests/support/mutate.h"
#include "tests/support/property.h"

namespace underact::lesson {
namespace {

std::vector<std::string> theTexts() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(UNDERACT_SOURCE) + "/resources/lessons")) {
    const std::filesystem::path& path = entry.path();
    if (path.extension() == ".json" && path.stem().extension() != ".schema") files.push_back(path);
  }
  std::sort(files.begin(), files.end());
  std::vector<std::string> texts;
  for (const std::filesystem::path& path : files) {
    std::ifstream file(path, std::ios::binary);
    texts.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return texts;
}

bool isUtf8(std::string_view text) {
  for (std::size_t at = 0, length = 0; at < text.size(); at += length) {
    length = json::codePointLength(text, at);
    if (length == 0) return false;
  }
  return true;
}

std::string judgeRefusal(const Problems& problems, const std::string& text) {
  const auto lines = static_cast<int>(std::count(text.begin(), text.end(), '\n')) + 1;
  if (problems.empty()) return "Refused without a problem.";
  for (const Problem& problem : problems) {
    const std::string given = describe(problem);
    if (problem.place.line < 1 || problem.place.line > lines) return "No place of the file: " + given;
    if (problem.sentence.size() < 10 || std::string_view(".?").find(problem.sentence.back()) == std::string_view::npos)
      return "No sentence: " + given;
    if (problem.sentence.pattern().empty()) return "No other language can say: " + given;
    if (!isUtf8(given) || given.find('\n') != std::string::npos) return "Not one line: " + given;
  }
  return {};
}

/// Its checks can be asked, answered and told, whatever they are.
std::string judgeAccepted(const Lesson& lesson) {
  test::Moment moment;
  for (const Step& step : lesson.steps) {
    for (const Check& check : step.checks) {
      CheckState state;
      for (int tick = 0; tick < 3; ++tick) state = afterTick(check, std::move(state), moment.at(0.1 * tick).seen());
      state = afterAnswer(check, std::move(state), 1.0);
      if (describeCheck(check, state).empty()) return "Nothing to tell.";
    }
  }
  return {};
}

std::string judge(const std::string& text) {
  const Result<Lesson> read = readLesson(text, "fuzz.json");
  return read ? judgeAccepted(read.value()) : judgeRefusal(read.problems(), text);
}

TEST(LessonMutations, EachIsRefusedWithPlacesOrCanBeAsked) {
  static const std::array<const char*, 24> kTokens{"1e308",    "-1e999",    "null",      "[]",          "{}",   "\"\"",
                                                   ",",        ":",         "{",         "}",           "[",    "]",
                                                   "\"near\"", "\"part\"",  "\"visit\"", "\"measure\"", "9",    "-1",
                                                   "0.5",      "\"robot\"", "\"while\"", "\"q_deg\"",   "\xC3", "true"};
  underact::test::Random random(underact::test::Seed{20070703});
  const std::vector<std::string> texts = theTexts();
  const int count = underact::test::sweep(8'000, 200'000);
  int accepted = 0;
  for (int i = 0; i < count; ++i) {
    const std::string text = underact::test::mutated(random, texts[random.below(texts.size())], kTokens);
    ASSERT_EQ(judge(text), "") << "mutation " << i << ":\n" << text;
    accepted += readLesson(text, "fuzz.json") ? 1 : 0;
  }
  EXPECT_GT(accepted, count / 20);  // a mutator that only makes rubbish would prove nothing
  EXPECT_LT(accepted, count * 19 / 20);
}

TEST(LessonMutations, EveryPrefixIsRefused) {
  const std::string text = theTexts().front();
  for (std::size_t length = 0; length + 2 < text.size(); ++length) {
    const std::string cut = text.substr(0, length);
    ASSERT_FALSE(readLesson(cut, "fuzz.json")) << length;
    ASSERT_EQ(judge(cut), "") << length;
  }
}

}  // namespace
}  // namespace underact::lesson
