#include "app/gui/lab/lab_words.h"

#include <gtest/gtest.h>

#include "app/gui/lab/choice_list.h"
#include "core/tradeoff/settings.h"

namespace underact::gui::test {

TEST(LabWords, WhatIsBeyondTheBoundOrWorseThanAnotherIsMarkedInWords) {
  const scene::Description scene = [] {
    scene::Description made;
    made.constraints.push_back({"ball", scene::Sphere{Vec3::Zero(), 50.0}, target::Side::Both, {}, {}});
    return made;
  }();
  const tradeoff::Choice& rate = tradeoff::choices().front();
  tradeoff::ChoiceResult choice_result{&rate, tradeoff::settingsOf(scene, 250), {}};
  const auto option = [](const char* name, double cost_us_per_s, double error) {
    tradeoff::Summary one{"rate", name, 5, 500.0, 900.0, cost_us_per_s, error};
    return one;
  };
  choice_result.options = {option("250 Hz", 100.0, 4.0 * rate.bound), option("2000 Hz", 800.0, 0.5 * rate.bound)};
  tradeoff::recommend(rate.bound, choice_result.options);
  std::vector<ChoiceWords> words = choiceWords(scene, tradeoff::settingsOf(scene, 250), {choice_result});
  EXPECT_TRUE(words.front().is_beyond);
  EXPECT_TRUE(words.front().mark.contains("exceeds the bound"));
  EXPECT_TRUE(words.front().mark.contains("Recommended: 2000 Hz"));
  words = choiceWords(scene, tradeoff::settingsOf(scene, 2000), {choice_result});
  EXPECT_FALSE(words.front().is_beyond);
  EXPECT_EQ(words.front().mark, "");
  EXPECT_TRUE(words.front().figures.contains("500 ns for the servo's tick"));
  const int default_hz = tradeoff::Settings{}.rate_hz;  // the default where nothing is better: no warning, but said
  choice_result.options = {option("1000 Hz", 100.0, 2.0 * rate.bound), option("250 Hz", 90.0, 4.0 * rate.bound)};
  tradeoff::recommend(rate.bound, choice_result.options);
  words = choiceWords(scene, tradeoff::settingsOf(scene, default_hz), {choice_result});
  EXPECT_FALSE(words.front().is_beyond);
  EXPECT_TRUE(words.front().mark.startsWith("The default;")) << words.front().mark.toStdString();
  words = choiceWords(scene, tradeoff::settingsOf(scene, 250), {choice_result});
  EXPECT_TRUE(words.front().is_beyond);
  words = choiceWords(scene, tradeoff::settingsOf(scene, 300), {choice_result});
  EXPECT_TRUE(words.front().figures.startsWith("not measured"));
}

TEST(LabWords, AnOptionIsWrittenAsTheNumbersBesideItAre) {
  EXPECT_EQ(optionText("trapezoidal, 200 us"), QString::fromUtf8("trapezoidal, 200 µs"));
  EXPECT_EQ(optionText("closed form"), "closed form");
  EXPECT_EQ(optionText("closed form where there is one, else 20 steps"),
            "closed form where there is one, else 20 steps");
}

TEST(LabWords, NumbersHaveThreeDigitsInTheUnitThatMakesThemShort) {
  EXPECT_EQ(timeText(0.812), "812 ns");
  EXPECT_EQ(timeText(1.2449), "1.24 µs");
  EXPECT_EQ(timeText(31'000.0), "31 ms");
  EXPECT_EQ(lengthText(0.0313), "31.3 µm");
  EXPECT_EQ(lengthText(0.5), "0.5 mm");
  EXPECT_EQ(lengthText(2e-6), "2 nm");
  EXPECT_EQ(lengthText(0.0), "0 mm");
  EXPECT_EQ(lengthText(2.1e-14), "below 0.001 nm") << "no 0.000000021 nm";
  EXPECT_EQ(errorText(55.04, "mm/s"), "55 mm/s");
  EXPECT_EQ(durationText(0.3), "a second");
  EXPECT_EQ(durationText(33.0), "35 s");
  EXPECT_EQ(durationText(200.0), "3 min");
}

}  // namespace underact::gui::test
