#include "core/sweep/options.h"

#include <gtest/gtest.h>

namespace underact::sweep {
namespace {

const std::vector<Option> kRows{{"scene", "Scene files", {}, true},
                                {"draws", "How many", {"10"}},
                                {"rate_hz", "Ticks a second", {"1000"}, true},
                                {"mass_kg", "Of the hand", {"0.05:0.2"}}};

Options optionsOf(Options::Values given) {
  given.try_emplace("scene", std::vector<std::string>{"a.json"});
  return Options::from(kRows, given).value();
}

std::string sentencesOf(const Problems& problems) {
  std::string all;
  for (const Problem& problem : problems) all += problem.sentence + "\n";
  return all;
}

TEST(Options, TakeWhatIsSaidAndElseWhatIsUsual) {
  Options options = optionsOf({{"rate_hz", {"500", "2000"}}});
  EXPECT_EQ(options.integers("rate_hz", 100, 10'000), (std::vector<std::int64_t>{500, 2000}));
  EXPECT_EQ(options.integer("draws", 1, 100), 10);
  EXPECT_EQ(options.text("scene"), "a.json");
  EXPECT_TRUE(options.problems().empty());
}

TEST(Options, TellOfEveryOneThatIsUnknownMissingOrSaidTwice) {
  const Result<Options> options = Options::from(kRows, {{"draw", {"1"}}, {"draws", {"1", "2"}}});
  ASSERT_FALSE(options);
  EXPECT_EQ(sentencesOf(options.problems()),
            "--scene: A value is missing. Scene files.\n"
            "--draws: It takes one value, but has several here.\n"
            "--draw: There is no such option. Did you mean --draws?\n");
}

TEST(Options, TakeWholeNumbersWithinTheirBoundsAlone) {
  for (const char* text : {"1", "100"}) {
    Options options = optionsOf({{"draws", {text}}});
    options.integer("draws", 1, 100);
    EXPECT_TRUE(options.problems().empty()) << text;
  }
  for (const char* text : {"0", "101", "1.5", "1 ", "", "ten", "99999999999999999999"}) {
    Options options = optionsOf({{"draws", {text}}});
    const std::int64_t value = options.integer("draws", 1, 100);
    EXPECT_EQ(options.problems().size(), 1U) << text;
    EXPECT_TRUE(value >= 1 && value <= 100) << text << " gave " << value;
  }
}

TEST(Options, TakeFiniteNumbersWithinTheirBoundsAlone) {
  Options good = optionsOf({{"draws", {"0.5"}}});
  EXPECT_EQ(good.number("draws", 0.5, 1.0), 0.5);
  EXPECT_TRUE(good.problems().empty());
  for (const char* text : {"0.49", "1.01", "nan", "inf", "1e999", "0.5x"}) {
    Options options = optionsOf({{"draws", {text}}});
    options.number("draws", 0.5, 1.0);
    EXPECT_EQ(options.problems().size(), 1U) << text;
  }
}

TEST(Options, DrawEvenlyFromARange) {
  Options options = optionsOf({});
  const Range range = options.range("mass_kg", 0.0, 1.0);
  EXPECT_EQ(range.at(0.0), 0.05);
  EXPECT_DOUBLE_EQ(range.at(0.5), 0.125);
  Options fixed = optionsOf({{"mass_kg", {"0.1"}}});
  EXPECT_EQ(fixed.range("mass_kg", 0.0, 1.0).at(0.7), 0.1);  // to the bit, whatever is drawn
  for (const char* text : {"0.2:0.1", "0.1:", ":0.1", "0.1:0.2:0.3", "-0.1:0.2", "0.1:1.1", "a:b"}) {
    Options bad = optionsOf({{"mass_kg", {text}}});
    bad.range("mass_kg", 0.0, 1.0);
    EXPECT_EQ(bad.problems().size(), 1U) << text;
  }
}

TEST(Options, HaveOneTextWhateverWasLeftUnsaid) {
  EXPECT_EQ(optionsOf({{"draws", {"10"}}}).canonical(), optionsOf({}).canonical());
  EXPECT_EQ(optionsOf({{"scene", {"a \"b\""}}}).canonical(),
            R"({"draws": ["10"], "mass_kg": ["0.05:0.2"], "rate_hz": ["1000"], "scene": ["a \"b\""]})");
}

}  // namespace
}  // namespace underact::sweep
