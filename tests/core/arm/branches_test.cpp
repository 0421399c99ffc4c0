#include "core/arm/branches.h"

#include <algorithm>
#include <cstdio>
#include <string>

#include "core/arm/forward.h"
#include "core/arm/jacobian.h"
#include "tests/core/arm/golden.h"
#include "tests/core/arm/thesis.h"
#include "tests/support/property.h"

namespace underact::arm {
namespace {

double apart(const JointAngles& a_rad, const JointAngles& b_rad) {  // modulo a turn
  double furthest_rad = 0.0;
  for (std::size_t joint = 0; joint < 6; ++joint) {
    furthest_rad = std::max(furthest_rad, std::abs(std::remainder(a_rad[joint] - b_rad[joint], 2.0 * kPi)));
  }
  return furthest_rad;
}

Solutions allSolutions(const Pose& X_WT) {
  return solveAll(thesis().geometry, thesis().limits, X_WT);
}

/// m, and entries of the rotation.
double miss(const Solution& one, const Pose& X_WT) {
  return (tipPose(thesis().geometry, one.q_rad).matrix() - X_WT.matrix()).cwiseAbs().maxCoeff();
}

/// What the closed form divides by at a solution.
double conditionOfSolution(const Solution& one) {
  const SingularityDistances at = singularityDistances(thesis().geometry, one.q_rad);
  const double reach_m = thesis().geometry.upper_m + thesis().geometry.fore_m;
  return std::sin(at.wrist_rad) * std::sin(at.elbow_rad) * (at.shoulder_m / reach_m);
}

struct Expected {
  JointAngles q_rad{};
  bool family = false;
  std::string invariant;
  double value_rad = 0.0;
};

std::vector<Expected> expectedOf(const test::Value& one) {
  std::vector<Expected> all;
  for (const test::Value& solution : one.find("solutions")->items) {
    Expected expected{test::anglesOf(*solution.find("q")), false, "", 0.0};
    const test::Value* const family = solution.find("family");
    expected.family = family->kind != json::JsonKind::Null;
    if (const test::Value* const invariant = family->find("wrist_invariant")) {
      expected.invariant = invariant->find("expr")->text;
      expected.value_rad = invariant->find("value")->number;
    }
    all.push_back(expected);
  }
  return all;
}

/// Whether the solution stands for what the file lists: the same angles, or, of a wrist's family, the same sum.
bool standsFor(const Solution& one, const Expected& expected, double tolerance_rad) {
  if (expected.family != (one.family != Family::None)) return false;
  if (expected.invariant.empty()) return apart(one.q_rad, expected.q_rad) <= tolerance_rad;
  const double sign = expected.invariant == "theta4+theta6" ? 1.0 : -1.0;
  if ((sign > 0.0) != (one.family == Family::Q4PlusQ6)) return false;
  JointAngles first_three = one.q_rad, wanted = expected.q_rad;
  for (std::size_t joint = 3; joint < 6; ++joint) first_three[joint] = wanted[joint] = 0.0;
  const double sum_rad = one.q_rad[5] + sign * one.q_rad[3];
  return apart(first_three, wanted) <= tolerance_rad &&
         std::abs(std::remainder(sum_rad - expected.value_rad, 2.0 * kPi)) <= tolerance_rad;
}

}  // namespace

TEST(Branches, AreExactlyThoseOfTheGoldenFile) {
  const test::Value file = test::golden("ik.json");
  int cases = 0;
  for (const test::Value& one : file.find("cases")->items) {
    ++cases;
    const Pose X_WT = test::poseOf(*one.find("T"));
    const std::string& status = one.find("status")->text;
    const Solutions solutions = allSolutions(X_WT);
    const std::vector<Expected> expected = expectedOf(one);
    EXPECT_EQ(solutions.count, expected.size()) << "line " << one.line << ": " << status;
    EXPECT_EQ(solutions.reachable, status != "unreachable") << "line " << one.line;
    EXPECT_EQ(solutions.at_shoulder, status.find("shoulder") != std::string::npos) << "line " << one.line;
    EXPECT_EQ(solutions.at_elbow, status.find("elbow") != std::string::npos) << "line " << one.line;
    EXPECT_EQ(solutions.at_wrist, status.find("wrist") != std::string::npos) << "line " << one.line;
    for (const Expected& wanted : expected) {
      double tolerance_rad = 3e-6;  // on the boundary: the root of the rounding of the pose, as the file's notes say
      if (status == "regular") {
        tolerance_rad = 0.0;
        for (const Solution& found : solutions)
          tolerance_rad = std::max(tolerance_rad, 1e-8 / conditionOfSolution(found));
        tolerance_rad = std::min(tolerance_rad, 1e-6);  // so that no match is an accident
      }
      const bool found = std::any_of(solutions.begin(), solutions.end(),
                                     [&](const Solution& some) { return standsFor(some, wanted, tolerance_rad); });
      EXPECT_TRUE(found) << "line " << one.line << ": " << status;
    }
    for (const Solution& found : solutions) {  // on the boundary the pose itself is rounded out of reach
      EXPECT_LE(miss(found, X_WT), status == "regular" ? 4e-15 : 1e-12) << "line " << one.line << ": " << status;
    }
  }
  EXPECT_EQ(cases, 100);
}

TEST(Branches, TellWithinLimitsAsTheGoldenFileDoes) {
  const test::Value file = test::golden("ik.json");
  int inside = 0;
  for (const test::Value& one : file.find("cases")->items) {
    if (one.find("status")->text != "regular") continue;
    const Solutions solutions = allSolutions(test::poseOf(*one.find("T")));
    for (const test::Value& listed : one.find("solutions")->items) {
      const JointAngles q_rad = test::anglesOf(*listed.find("q"));
      const auto found = std::find_if(solutions.begin(), solutions.end(),
                                      [&](const Solution& some) { return apart(some.q_rad, q_rad) < 1e-4; });
      ASSERT_NE(found, solutions.end());
      EXPECT_EQ(found->within_limits, listed.find("in_nominal_ranges")->boolean) << "line " << listed.line;
      inside += found->within_limits ? 1 : 0;
    }
  }
  EXPECT_GT(inside, 30);
}

TEST(Branches, ReachTheirPoseWhereverItIs) {  // packaging/soak: 1e6 round trips, the worst printed
  test::Random random(test::Seed{20070401});
  double worst_m = 0.0, worst_angle = 0.0;
  for (int i = 0; i < test::sweep(20'000, 1'000'000); ++i) {
    JointAngles q_rad{};
    for (double& angle_rad : q_rad) angle_rad = random.between(-kPi, kPi);
    const Pose X_WT = tipPose(thesis().geometry, q_rad);
    const Solutions solutions = allSolutions(X_WT);
    ASSERT_TRUE(solutions.reachable);
    ASSERT_GT(solutions.count, 0U);
    if (!solutions.singular()) {
      ASSERT_EQ(solutions.count, 8U) << i;
    }
    double nearest_rad = kInfinity;
    for (const Solution& one : solutions) {
      const Pose again = tipPose(thesis().geometry, one.q_rad);
      worst_m = std::max(worst_m, (again.translation() - X_WT.translation()).cwiseAbs().maxCoeff());
      worst_angle = std::max(worst_angle, (again.linear() - X_WT.linear()).cwiseAbs().maxCoeff());
      nearest_rad = std::min(nearest_rad, apart(one.q_rad, q_rad));
      ASSERT_EQ(one.branch.elbow > 0, std::cos(one.q_rad[2]) >= 0.0 || solutions.at_elbow);
      ASSERT_EQ(one.branch.wrist > 0, std::sin(one.q_rad[4]) >= 0.0);
      for (const double angle_rad : one.q_rad) ASSERT_TRUE(angle_rad > -kPi && angle_rad <= kPi) << angle_rad;
    }
    if (!solutions.singular()) {
      ASSERT_LE(nearest_rad, 1e-12 / conditionOfSolution({q_rad, {}, Family::None, false})) << i;
    }
  }
  std::printf("round trips: worst place %.2e mm, worst entry of the rotation %.2e\n", 1e3 * worst_m, worst_angle);
  EXPECT_LE(worst_m, 1e-12);  // 1e-9 mm
  EXPECT_LE(worst_angle, 1e-12);
}

TEST(Branches, FaceAndTurnAwayAsTheirNamesSay) {
  JointAngles q_rad{0.3, 0.8, 0.4, 0.5, 1.1, -0.7};
  const Solutions solutions = allSolutions(tipPose(thesis().geometry, q_rad));
  EXPECT_LE(apart(solutions.all[0].q_rad, q_rad), 1e-14);
  EXPECT_EQ(solutions.all[0].branch, (Branch{1, 1, 1}));
  for (const Solution& one : solutions) {
    EXPECT_EQ(one.branch.shoulder > 0, std::cos(one.q_rad[0] - q_rad[0]) > 0.0);
  }
  EXPECT_EQ(solutions.all[7].branch, (Branch{-1, -1, -1}));
}

TEST(Branches, NearEachSingularityStayFiniteAndReachThePose) {  // down to the last bits on both sides
  test::Random random(test::Seed{20070402});
  for (double off = 1e-18; off < 1e-3; off *= 3.0) {
    for (int singularity = 0; singularity < 4; ++singularity) {
      JointAngles q_rad{random.between(-2, 2), random.between(0.3, 1), random.between(-1, 1),
                        random.between(-2, 2), random.between(0.5, 2), random.between(-2, 2)};
      const Geometry& geometry = thesis().geometry;
      if (singularity == 0) q_rad[4] = off;
      if (singularity == 1) q_rad[4] = kPi - off;
      if (singularity == 2) q_rad[2] = kPi / 2 - off;
      if (singularity == 3) {  // L1 cos q2 + L2 sin(q2 + q3) = off
        const double sine = (off - geometry.upper_m * std::cos(q_rad[1])) / geometry.fore_m;
        q_rad[2] = std::asin(std::clamp(sine, -1.0, 1.0)) - q_rad[1];
      }
      const Pose X_WT = tipPose(geometry, q_rad);
      const Solutions solutions = allSolutions(X_WT);
      ASSERT_GT(solutions.count, 0U) << singularity << " " << off;
      for (const Solution& one : solutions) ASSERT_LE(miss(one, X_WT), 1e-12) << singularity << " " << off;
      if (off < 3e-7) {
        EXPECT_TRUE(solutions.singular()) << singularity << " " << off;
      }
      if (off > 3e-6) {
        EXPECT_FALSE(solutions.singular()) << singularity << " " << off;
      }
    }
  }
}

TEST(Branches, TheBoundaryOfTheReachCountsAsReached) {
  const Geometry& geometry = thesis().geometry;
  const double reach_m = geometry.upper_m + geometry.fore_m;
  for (const double share : {1.0, 1.0 + 9.9e-10, 1.0 - 1e-13}) {
    Pose X_WT = Pose::Identity();
    X_WT.translation() = geometry.p_WB + share * reach_m * Vec3(0.36, 0.48, 0.8);
    EXPECT_TRUE(allSolutions(X_WT).reachable) << share;
    EXPECT_TRUE(allSolutions(X_WT).at_elbow) << share;
  }
  Pose folded = Pose::Identity();
  folded.translation() =
      geometry.p_WB + (geometry.fore_m - geometry.upper_m - 0.9e-9 * reach_m) * Vec3(0.36, 0.48, 0.8);
  EXPECT_TRUE(allSolutions(folded).reachable);
  folded.translation() = geometry.p_WB + (geometry.fore_m - geometry.upper_m - 2e-9 * reach_m) * Vec3(0.36, 0.48, 0.8);
  EXPECT_FALSE(allSolutions(folded).reachable);
  Pose beyond = Pose::Identity();
  beyond.translation() = geometry.p_WB + (1.0 + 1.2e-9) * reach_m * Vec3(0.36, 0.48, 0.8);
  EXPECT_FALSE(allSolutions(beyond).reachable);
  EXPECT_EQ(allSolutions(beyond).count, 0U);
}

TEST(Branches, AnArmOfEqualLinksFoldedOntoItsShoulderIsAnsweredToo) {
  const Preset& touch = *findPreset("touch-measured");
  Pose X_WT = Pose::Identity();
  X_WT.translation() = touch.geometry.p_WB;
  const Solutions solutions = solveAll(touch.geometry, touch.limits, X_WT);
  ASSERT_GT(solutions.count, 0U);
  EXPECT_TRUE(solutions.at_shoulder && solutions.at_elbow);
  for (const Solution& one : solutions) {
    EXPECT_LE((tipPose(touch.geometry, one.q_rad).matrix() - X_WT.matrix()).cwiseAbs().maxCoeff(), 1e-12);
  }
}

}  // namespace underact::arm
