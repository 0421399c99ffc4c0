#include "core/registration/registration_file.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/registration/registration_store.h"
#include "core/registration/sheet.h"
#include "tests/core/registration/touches.h"
#include "tests/support/mutate.h"
#include "tests/support/property.h"
#include "tests/support/scratch_folder.h"

namespace underact::registration {
namespace {

Registration sample(std::uint64_t seed, const std::string& arm = "wooden:0042") {
  test::Random random({seed});
  Registration registration{arm, "2026-11-22", "underact 0.1.0", {}, {}};
  registration.touches =
      touched(sheetPoints(3 + seed % 6), standing(random.between(-3, 3), random.inBox(0.2)), 1e-3, random);
  for (Touch& touch : registration.touches) touch.spread_m = random.between(0.0, 1e-3);
  registration.fit = fitTouches(registration.touches).value();
  return registration;
}

const std::string kMarks =
    R"([{"p_DM_mm": [0, 0, 0], "p_WM_mm": [0, 0, 0]}, {"p_DM_mm": [100, 0, 0], "p_WM_mm": [100, 0, 0]},
        {"p_DM_mm": [0, 0, -80], "p_WM_mm": [0, 0, -80], "spread_mm": 0.2}])";

std::string fileText(const std::string& marks, const std::string& more = "") {
  return R"({"underact_registration": 1, "arm": "simulated", "date": "2026-11-22", "marks": )" + marks + more + "}";
}

void expectProblem(const std::string& text, const std::string& key, const std::string& words) {
  const Result<Registration> read = readRegistration(text, "r.json");
  ASSERT_FALSE(read) << text;
  bool found = false;
  for (const Problem& problem : read.problems()) {
    found |= problem.place.key == key && problem.sentence.find(words) != std::string::npos;
    EXPECT_GT(problem.place.line, 0) << describe(problem);
  }
  EXPECT_TRUE(found) << describe(read.problems().front());
}

TEST(RegistrationFile, ReadsBackToTheSameNumbers) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Registration registration = sample(seed);
    const std::string text = registrationText(registration);
    const Result<Registration> read = readRegistration(text, "r.json");
    ASSERT_TRUE(read) << describe(read.problems().front());
    EXPECT_EQ(read.value().arm, registration.arm);
    EXPECT_EQ(read.value().date, registration.date);
    EXPECT_EQ(read.value().program, registration.program);
    ASSERT_EQ(read.value().touches.size(), registration.touches.size());
    for (std::size_t at = 0; at < registration.touches.size(); ++at) {
      // A metre that no millimetre comes back to exists: an ulp off then.
      EXPECT_LT((read.value().touches[at].p_WM - registration.touches[at].p_WM).norm(), 1e-16);
      EXPECT_EQ(read.value().touches[at].p_DM, registration.touches[at].p_DM);
    }
    EXPECT_LT((read.value().fit.X_DW.matrix() - registration.fit.X_DW.matrix()).norm(), 1e-14);
    EXPECT_EQ(registrationText(read.value()).substr(0, text.find("X_DW")), text.substr(0, text.find("X_DW")));
  }
}

TEST(RegistrationFile, ByHandItNeedsNeitherPoseNorProgram) {
  const Result<Registration> read = readRegistration(fileText(kMarks), "r.json");
  ASSERT_TRUE(read) << describe(read.problems().front());
  EXPECT_LT((read.value().fit.X_DW.matrix() - Eigen::Matrix4d::Identity()).norm(), 1e-14);
  EXPECT_EQ(read.value().touches[2].spread_m, 0.2e-3);
}

TEST(RegistrationFile, NamesEachErrorWithItsPlace) {
  expectProblem("[]", "", "an object");
  expectProblem(R"({"underact_registration": 2, "arm": "a", "date": "d", "marks": )" + kMarks + "}",
                "underact_registration", "version 1");
  expectProblem(fileText("[]"), "marks", "3 to 8");
  expectProblem(fileText("7"), "marks", "list");
  expectProblem(fileText(kMarks, R"(, "residual": 1)"), "residual", "");
  expectProblem(fileText(R"([{"p_DM_mm": [0, 0, 0]}, 4, {"p_DM_mm": [1, 2], "p_WM_mm": [0, 0, 0]}])"), "marks[1]",
                "object");
  expectProblem(fileText(R"([{"p_DM_mm": [0, 0, 0], "p_WM_mm": [0, 0, 0]}, {"p_DM_mm": [9, 0, 0], "p_WM_mm": [9, 0, 0]},
    {"p_DM_mm": [90, 0, 0], "p_WM_mm": [90, 0, 0], "spread_mm": -1}])"),
                "marks[2].spread_mm", "from 0 to 1000 mm");
  expectProblem(fileText(R"([{"p_DM_mm": [0, 0, 0], "p_WM_mm": [0, 0, 0]}, {"p_DM_mm": [9, 0, 0], "p_WM_mm": [9, 0, 0]},
    {"p_DM_mm": [90, 0, 0], "p_WM_mm": [90, 0, 0]}])"),
                "marks", "one line");
  expectProblem(fileText(kMarks, R"(, "X_DW": [[1,0,0,5],[0,1,0,0],[0,0,1,0],[0,0,0,1]])"), "X_DW",
                "the reference points give");
  expectProblem(fileText(kMarks, R"(, "X_DW": [[1,0,0,0],[0,1,0,0],[0,0,1]])"), "X_DW", "four rows");
}

/// One text made of others by a seed: bytes, tokens, cuts and spans that come again.
std::string mutated(test::Random& random, const std::vector<std::string>& texts) {
  static const std::vector<const char*> kTokens{"1e999", "-1e308",    "null", "{",  "}",    "[", "]",
                                                "\"",    ",",         ":",    "0",  "true", "-", "\\",
                                                "\xC3",  "\"marks\"", "1e-7", "[[", "NaN"};
  std::string text = texts[random.below(texts.size())];
  return test::mutated(random, std::move(text), kTokens);
}

TEST(RegistrationFile, AnyBytesAreRefusedInWordsOrAreAFinitePose) {
  test::Random random({20260105});
  const std::vector<std::string> texts{registrationText(sample(1)), registrationText(sample(5)), fileText(kMarks)};
  int accepted = 0;
  const int count = test::sweep(10'000, 500'000);
  for (int draw = 0; draw < count; ++draw) {
    const std::string text = mutated(random, texts);
    const Result<Registration> read = readRegistration(text, "fuzz.json");
    if (!read) {
      ASSERT_FALSE(read.problems().empty());
      for (const Problem& problem : read.problems()) {
        ASSERT_GT(problem.sentence.size(), 10U) << text;
        ASSERT_EQ(problem.sentence.find('\n'), std::string::npos) << text;
      }
      continue;
    }
    ++accepted;
    ASSERT_TRUE(read.value().fit.X_DW.matrix().allFinite()) << text;
    ASSERT_NEAR(read.value().fit.X_DW.linear().determinant(), 1.0, 1e-9) << text;
    ASSERT_TRUE(readRegistration(registrationText(read.value()), "again.json")) << text;
  }
  EXPECT_GT(accepted, count / 100);  // a mutator that only makes rubbish would prove nothing
  EXPECT_LT(accepted, count);
}

TEST(Store, KeepsOneRegistrationAnArm) {
  const test::ScratchFolder scratch;
  const std::string folder = scratch.path() + "/not/yet/there";
  EXPECT_FALSE(loadRegistration("wooden:0042", folder).value());
  ASSERT_TRUE(saveRegistration(sample(1), folder).empty());
  ASSERT_TRUE(saveRegistration(sample(2, "wooden:/dev/hidraw3"), folder).empty());
  ASSERT_TRUE(saveRegistration(sample(3), folder).empty());  // in place of the first
  const auto first = loadRegistration("wooden:0042", folder);
  ASSERT_TRUE(first && first.value());
  EXPECT_EQ(first.value()->touches.size(), sample(3).touches.size());
  ASSERT_TRUE(loadRegistration("wooden:/dev/hidraw3", folder).value());
  EXPECT_TRUE(removeRegistration("wooden:0042", folder).empty());
  EXPECT_TRUE(removeRegistration("wooden:0042", folder).empty());  // it is gone already
  EXPECT_FALSE(loadRegistration("wooden:0042", folder).value());
  EXPECT_TRUE(loadRegistration("wooden:/dev/hidraw3", folder).value());
}

TEST(Store, NamesOfFilesHoldNothingThatLeadsElsewhere) {
  EXPECT_EQ(std::filesystem::path(registrationPath("wooden:../../a", "/x")).filename(),
            "wooden%3A%2E%2E%2F%2E%2E%2Fa.json");
  EXPECT_EQ(std::filesystem::path(registrationPath("..", "/x")).parent_path(), "/x");
}

TEST(Store, AFileOfAnotherArmAndOneThatIsDamagedAreSaid) {
  const test::ScratchFolder scratch;
  ASSERT_TRUE(saveRegistration(sample(1), scratch.path()).empty());
  std::filesystem::copy(registrationPath("wooden:0042", scratch.path()),
                        registrationPath("wooden:0043", scratch.path()));
  EXPECT_NE(
      loadRegistration("wooden:0043", scratch.path()).problems().front().sentence.find("another arm, \"wooden:0042\""),
      std::string::npos);
  std::filesystem::resize_file(registrationPath("wooden:0042", scratch.path()), 60);
  EXPECT_FALSE(loadRegistration("wooden:0042", scratch.path()));
}

TEST(Store, ReportsWhatItCannotWrite) {
  EXPECT_FALSE(saveRegistration(sample(1), "/proc/nowhere").empty());
}

}  // namespace
}  // namespace underact::registration
