#include "core/registration/check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "core/registration/sheet.h"
#include "tests/core/registration/touches.h"
#include "tests/support/property.h"

namespace underact::registration {
namespace {

using Kind = Warning::Kind;

std::vector<Warning> warnings(const std::vector<Touch>& touches) {
  return warningsOf(touches, fitTouches(touches).value());
}

const Warning* find(const std::vector<Warning>& all, Kind kind) {
  const auto found = std::find_if(all.begin(), all.end(), [kind](const Warning& one) { return one.kind == kind; });
  return found == all.end() ? nullptr : &*found;
}

TEST(Warnings, AGoodRegistrationHasNone) {
  test::Random random({11});
  for (std::size_t count = kFewestMarks; count <= kMaxMarks; ++count) {
    for (const double turn_rad : {0.0, 1.0, 3.0, -1.6}) {
      const auto all = warnings(touched(sheetPoints(count), standing(turn_rad), 0.5e-3, random));
      EXPECT_TRUE(all.empty()) << all.front().sentence;
    }
  }
}

TEST(Warnings, TwoMarksInExchangeAreNamed) {
  test::Random random({12});
  for (std::size_t count = kFewestMarks; count <= 5; ++count) {
    for (std::size_t one = 0; one < count; ++one) {
      for (std::size_t other = 0; other < one; ++other) {
        std::vector<Touch> touches = touched(sheetPoints(count), standing(0.5), 0.3e-3, random);
        std::swap(touches[one].p_WM, touches[other].p_WM);
        const auto all = warnings(touches);
        const Warning* order = find(all, Kind::Order);
        ASSERT_NE(order, nullptr) << count << ": " << one << ", " << other;
        EXPECT_EQ(order->marks, (std::vector<std::size_t>{other, one}));
        EXPECT_NE(order->sentence.find(std::to_string(other + 1) + " and " + std::to_string(one + 1)),
                  std::string::npos);
        EXPECT_EQ(find(all, Kind::Residual), nullptr);  // touching the worst again would not help
      }
    }
  }
}

TEST(Warnings, AnyOrderIsSeenForWhatItIs) {
  test::Random random({13});
  for (int draw = 0; draw < test::sweep(60, 1'000); ++draw) {
    const std::vector<Touch> right = touched(sheetPoints(6), standing(random.between(-3, 3)), 0.3e-3, random);
    std::vector<std::size_t> order(right.size());
    std::iota(order.begin(), order.end(), 0U);
    for (std::size_t at = order.size(); at > 1; --at) std::swap(order[at - 1], order[random.below(at)]);
    std::vector<Touch> touches = right;
    for (std::size_t at = 0; at < order.size(); ++at) touches[at].p_WM = right[order[at]].p_WM;
    ASSERT_EQ(likelyOrder(touches, fitTouches(touches).value()), order) << draw;
  }
}

// Three marks with two sides alike: exchanged, they fit as well as before, upside down.
TEST(Warnings, MarksInAMirrorsOrderAreToldByTheArmThatHangs) {
  std::vector<Touch> touches = touched({{0, 0, 0}, {0.1, 0, 0}, {0, 0, -0.1}}, standing(0.2));
  std::swap(touches[1].p_WM, touches[2].p_WM);
  const Fit fit = fitTouches(touches).value();
  EXPECT_LT(fit.rms_m, 1e-12);
  EXPECT_FALSE(isUpright(fit));
  const auto all = warnings(touches);
  ASSERT_NE(find(all, Kind::Order), nullptr);
  EXPECT_EQ(find(all, Kind::Order)->marks, (std::vector<std::size_t>{1, 2}));
}

// Of a rectangle, mirrored orders fit as well as the right one; the one that is proposed lets the arm stand.
TEST(Warnings, TheOrderThatIsProposedLetsTheArmStand) {
  const std::vector<Vec3> rectangle{{0, 0, 0}, {0.12, 0, 0}, {0.12, 0, -0.08}, {0, 0, -0.08}};
  test::Random random({15});
  for (std::size_t one = 0; one < 4; ++one) {
    for (std::size_t other = 0; other < one; ++other) {
      const std::vector<Touch> right = touched(rectangle, standing(0.2), 0.2e-3, random);
      std::vector<Touch> touches = right;
      std::swap(touches[one].p_WM, touches[other].p_WM);
      const std::vector<std::size_t> order = likelyOrder(touches, fitTouches(touches).value());
      for (std::size_t at = 0; at < 4; ++at) touches[at].p_DM = rectangle[order[at]];
      const Fit fit = fitTouches(touches).value();
      EXPECT_TRUE(isUpright(fit));
      EXPECT_LT(fit.rms_m, 1e-3);
    }
  }
}

TEST(Warnings, AnArmThatReallyHangsIsOnlyAskedAbout) {
  Pose X_DW = Pose::Identity();
  X_DW.linear() = Eigen::AngleAxisd(3.0, Vec3::UnitZ()).toRotationMatrix();
  const auto all = warnings(touched(sheetPoints(4), X_DW));
  EXPECT_EQ(find(all, Kind::Order), nullptr);
  ASSERT_NE(find(all, Kind::UpsideDown), nullptr);
}

TEST(Warnings, TheMarkThatIsWorstIsNamed) {
  test::Random random({14});
  for (std::size_t wrong = 0; wrong < 5; ++wrong) {
    std::vector<Touch> touches = touched(sheetPoints(5), standing(0.5), 0.3e-3, random);
    touches[wrong].p_WM += Vec3(0.007, 0.009, -0.007);
    const Fit fit = fitTouches(touches).value();
    EXPECT_EQ(worstPoint(touches, fit), wrong);
    const auto all = warningsOf(touches, fit);
    ASSERT_NE(find(all, Kind::Residual), nullptr);
    EXPECT_NE(find(all, Kind::Residual)->sentence.find("Reference point " + std::to_string(wrong + 1) + " fits worst"),
              std::string::npos);
  }
}

TEST(Warnings, MarksNearlyOnALineAndNearToEachOtherAreTold) {
  const auto line = warnings(touched({{0, 0, 0}, {0.06, 0, 0.012}, {0.12, 0, 0}}, standing(0.0)));
  EXPECT_NE(find(line, Kind::NearLine), nullptr);
  EXPECT_EQ(find(line, Kind::NearMarks), nullptr);
  const auto near = warnings(touched({{0, 0, 0}, {0.015, 0, 0}, {0.12, 0, 0}, {0.06, 0, 0.1}}, standing(0.0)));
  EXPECT_EQ(find(near, Kind::NearLine), nullptr);
  ASSERT_NE(find(near, Kind::NearMarks), nullptr);
  EXPECT_NE(find(near, Kind::NearMarks)->sentence.find("1 and 2 are only 15.0 mm"), std::string::npos);
}

TEST(Warnings, ATipThatMovedIsTold) {
  std::vector<Touch> touches = touched(sheetPoints(), standing(0.0));
  touches[1].spread_m = 0.8e-3;
  const auto all = warnings(touches);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all.front().kind, Kind::Moved);
  EXPECT_NE(all.front().sentence.find("reference point 2"), std::string::npos);
}

}  // namespace
}  // namespace underact::registration
