#include "core/base/result.h"

#include <gtest/gtest.h>

#include <memory>

#include "core/base/fault.h"

namespace underact {
namespace {

TEST(Result, IsAValueOrItsProblems) {
  const Result<int> good(3);
  ASSERT_TRUE(good);
  EXPECT_EQ(good.value(), 3);
  const Result<int> bad(Problems{{"One.", {}}, {"Two.", {}}});
  ASSERT_FALSE(bad);
  EXPECT_EQ(bad.problems().size(), 2U);
}

TEST(Result, HandsOnWhatCannotBeCopied) {
  Result<std::unique_ptr<int>> result(std::make_unique<int>(7));
  const std::unique_ptr<int> taken = std::move(result).value();
  EXPECT_EQ(*taken, 7);
}

TEST(Problem, ReadsAsCompilersPrintThem) {
  EXPECT_EQ(describe(Problem{"No.", {"f.json", 2, 5, "a.b"}}), "f.json:2:5: error: a.b: No.");
  EXPECT_EQ(describe(Problem{"No.", {"f.json", 0, 0, {}}}), "f.json: error: No.");
  EXPECT_EQ(describe(Problem{"No.", {"f.json", 0, 0, "a"}}), "f.json: error: a: No.");
  EXPECT_EQ(describe(Problem{"No.", {}}), "error: No.");
}

TEST(Fault, ItsNumbersStandWhereTheSentenceSays) {
  EXPECT_EQ(whatHappened({FaultKind::TooFast, 12.34, 5.0}),
            "The arm's position jumped at 12.3 m/s; a hand reaches at most 5 m/s.");
  EXPECT_EQ(whatHappened({FaultKind::StoodStill, 0.126, 0.1}), "The servo stalled for 0.13 s.");
  for (int kind = 1; kind < kFaultKinds; ++kind)
    EXPECT_EQ(whatHappened({static_cast<FaultKind>(kind), 2.0, 1.0}).find('%'), std::string::npos) << kind;
}

TEST(Fault, EachKindHasAWordAndASentence) {
  EXPECT_STREQ(name(FaultKind::None), "none");
  EXPECT_STREQ(name(FaultKind::NoSample), "no_sample");
  EXPECT_STREQ(name(FaultKind::StaleSample), "stale_sample");
  EXPECT_STREQ(name(FaultKind::NotFinite), "not_finite");
  EXPECT_EQ(describe(Fault{}), "");
  for (const FaultKind kind : {FaultKind::NoSample, FaultKind::StaleSample, FaultKind::NotFinite}) {
    EXPECT_NE(describe(Fault{kind, 0.0, 0.0}).find("Force is off."), std::string::npos);
  }
}

}  // namespace
}  // namespace underact
