#include "core/arm/follower.h"

#include <algorithm>

#include "core/arm/forward.h"
#include "core/base/units.h"
#include "tests/core/arm/thesis.h"
#include "tests/support/property.h"

namespace underact::arm {
namespace {

double largest(const JointAngles& a_rad, const JointAngles& b_rad) {
  double largest_rad = 0.0;
  for (std::size_t joint = 0; joint < 6; ++joint)
    largest_rad = std::max(largest_rad, std::abs(a_rad[joint] - b_rad[joint]));
  return largest_rad;
}

/// Follows the poses of a motion in joints, from its start.
struct Ride {
  explicit Ride(const JointAngles& q_rad) : state{q_rad, {}, false} {}
  void go(const JointAngles& q_rad) {
    const Followed followed = follow(thesis().geometry, thesis().limits, state, tipPose(thesis().geometry, q_rad));
    ASSERT_TRUE(followed.reachable);
    changes += followed.changed ? 1 : 0;
    furthest_rad = std::max(furthest_rad, largest(followed.next.q_rad, q_rad));
    step_rad = state.begun ? std::max(step_rad, largest(followed.next.q_rad, state.q_rad)) : 0.0;
    state = followed.next;
  }
  FollowerState state;
  int changes = 0;
  double furthest_rad = 0.0, step_rad = 0.0;
};

}  // namespace

TEST(Follower, StaysOnEachOfTheEightBranchesThroughAMotion) {
  const JointAngles start_rad{0.2, 0.7, 0.3, 0.4, 1.2, -0.6};
  const Solutions solutions = solveAll(thesis().geometry, thesis().limits, tipPose(thesis().geometry, start_rad));
  ASSERT_EQ(solutions.count, 8U);
  for (const Solution& begin : solutions) {
    Ride ride(begin.q_rad);
    for (int i = 0; i <= 2000; ++i) {
      JointAngles q_rad = begin.q_rad;
      const double phase = 2.0 * kPi * i / 2000;
      for (std::size_t joint = 0; joint < 6; ++joint)
        q_rad[joint] += 0.25 * std::sin(phase * static_cast<double>(1 + joint % 3));
      ride.go(q_rad);
    }
    EXPECT_EQ(ride.changes, 0);
    EXPECT_EQ(ride.state.branch, begin.branch);
    EXPECT_LE(ride.furthest_rad, 1e-12);
  }
}

TEST(Follower, TurnsOnPastPiInsteadOfJumpingBack) {
  Ride ride({0.2, 0.7, 0.3, 3.0, 1.2, -3.0});
  for (int i = 0; i <= 1000; ++i) ride.go({0.2, 0.7, 0.3, 3.0 + 8e-3 * i, 1.2, -3.0 - 8e-3 * i});
  EXPECT_EQ(ride.changes, 0);
  EXPECT_NEAR(ride.state.q_rad[3], 11.0, 1e-12);
  EXPECT_LE(ride.step_rad, 8.1e-3);
}

TEST(Follower, GoesOverToTheOtherWristWhereTheMotionPassesThroughInLineAndSaysSo) {
  Ride ride({0.2, 0.7, 0.3, 0.5, 0.3, 0.4});
  for (int i = 0; i <= 600; ++i) ride.go({0.2, 0.7, 0.3, 0.5, 0.3 - 1e-3 * i, 0.4});  // q5 from 0.3 to -0.3
  EXPECT_EQ(ride.changes, 1);
  EXPECT_EQ(ride.state.branch.wrist, -1);
  EXPECT_LE(ride.furthest_rad, 1e-9);  // in line, joint 4 stays and joint 6 takes the rest
  for (int i = 0; i <= 600; ++i) ride.go({0.2, 0.7, 0.3, 0.5, -0.3 + 1e-3 * i, 0.4});
  EXPECT_EQ(ride.changes, 2);
}

TEST(Follower, DoesNotFlutterWhileTheMotionTremblesAboutASingularity) {
  test::Random random(test::Seed{20070431});
  Ride ride({0.2, 0.7, 0.3, 0.5, 0.01, 0.4});
  for (int i = 0; i < 2000; ++i) {
    // The stylus trembles on the one side of being in line: never through.
    ride.go({0.2, 0.7, 0.3, 0.5 + random.between(-0.05, 0.05), random.between(0.001, 0.02), 0.4});
  }
  EXPECT_EQ(ride.changes, 0);
}

TEST(Follower, OutOfReachItStaysWhereItWasAndIsThereAgainAfterwards) {
  Ride ride({0.2, 0.7, 0.3, 0.5, 1.0, 0.4});
  ride.go({0.2, 0.7, 0.3, 0.5, 1.0, 0.4});
  const FollowerState before = ride.state;
  Pose far = Pose::Identity();
  far.translation() = Vec3(1.0, 0.0, 0.0);
  const Followed lost = follow(thesis().geometry, thesis().limits, before, far);
  EXPECT_FALSE(lost.reachable);
  EXPECT_FALSE(lost.changed);
  EXPECT_EQ(lost.next.q_rad, before.q_rad);
}

TEST(Follower, FollowsPlacesOnEachOfTheFourBranches) {
  for (const double q1_rad : {0.2, 0.2 - kPi}) {
    for (const double q3_rad : {0.3, kPi - 0.3}) {
      FollowerState state{{q1_rad, q1_rad > 0 ? 0.4 : 2.6, q3_rad, 0.1, 1.0, 0.2}, {}, false};
      const JointAngles middle_rad = state.q_rad;
      for (int i = 0; i <= 1000; ++i) {
        JointAngles q_rad = middle_rad;
        for (std::size_t joint = 0; joint < 3; ++joint) {
          q_rad[joint] += 0.2 * std::sin(2.0 * kPi * i / 1000 * static_cast<double>(joint + 1));
        }
        const Followed followed = followPosition(thesis().geometry, state, tipPosition(thesis().geometry, q_rad));
        ASSERT_TRUE(followed.reachable);
        ASSERT_FALSE(followed.changed);
        ASSERT_LE(largest(followed.next.q_rad, q_rad), 1e-12) << i;
        state = followed.next;
      }
    }
  }
}

TEST(Follower, APlaceThatPassesOverAxisOneTurnsTheShoulderOver) {
  FollowerState state{{0.0, 1.2, 1.5, 0.0, 1.0, 0.0}, {}, false};
  int changes = 0;
  for (int i = 0; i <= 400; ++i) {  // the tip passes over axis 1, at a height of 0.2 m
    const Vec3 p_WT = thesis().geometry.p_WB + Vec3(0.0, 0.2, 0.02 - 1e-4 * i);
    const Followed followed = followPosition(thesis().geometry, state, p_WT);
    changes += followed.changed ? 1 : 0;
    if (state.begun) {
      ASSERT_LE(largest(followed.next.q_rad, state.q_rad), 0.05) << i;
    }
    ASSERT_LE((tipPosition(thesis().geometry, followed.next.q_rad) - p_WT).norm(), 1e-9) << i;
    state = followed.next;
  }
  EXPECT_EQ(changes, 1);
  EXPECT_EQ(state.branch.shoulder, -1);
}

TEST(Follower, OutOfReachAPlaceIsAnsweredByTheNearestOne) {
  FollowerState state{{0.0, 0.7, 0.3, 0.0, 1.0, 0.0}, {}, false};
  const Vec3 p_WT = thesis().geometry.p_WB + Vec3(0.3, 0.3, 0.3);
  const Followed followed = followPosition(thesis().geometry, state, p_WT);
  EXPECT_FALSE(followed.reachable);
  const double reach_m = thesis().geometry.upper_m + thesis().geometry.fore_m;
  const Vec3 nearest_m = thesis().geometry.p_WB + reach_m * Vec3::Ones().normalized();
  EXPECT_LE((tipPosition(thesis().geometry, followed.next.q_rad) - nearest_m).norm(), 1e-12);
}

}  // namespace underact::arm
