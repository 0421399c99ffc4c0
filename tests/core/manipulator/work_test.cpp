#include <algorithm>
#include <cmath>

#include "core/manipulator/global.h"
#include "core/manipulator/thesis_law.h"
#include "tests/core/manipulator/hand.h"

// What a field of force does on the hand's way: the energy's law is conservative where the stylus does not turn; the
// thesis's is not; and turning the stylus, whose moment is never sent, can pump.
namespace underact::manipulator {
namespace {

using test::Loop;

/// The force on the hand of one tick.
Vec3 forceOf(const Manipulator& m, const Followed& followed, const Pose& X_WT) {
  return m.kp_N_per_m.cwiseProduct(followed.p_WP - X_WT.translation()) + followed.f_along_T_W;
}

struct Work {
  double work_J = 0.0;
  double turnover_J = 0.0;  // of the same with every part counted as positive
};

/// Once round at fixed turn, from a state that has been round before. The trapezoid rule over a period of an analytic
/// function converges exponentially (Trefethen and Weideman 2014).
Work around(const Manipulator& m, const Mat3& R_WT, const Loop& loop, int points) {
  int cold_steps = 0;
  State state = settledState(m, test::poseOf(R_WT, loop.place(0.0)), cold_steps);
  Work work;
  for (int i = -points; i < points; ++i) {
    const double step = 2.0 * kPi / points, s = step * i;
    const Pose X_WT = test::poseOf(R_WT, loop.place(s));
    const double part_J = step * forceOf(m, follow(m, X_WT, 0.0, state), X_WT).dot(loop.slope(s));
    if (i < 0) continue;
    work.work_J += part_J;
    work.turnover_J += std::abs(part_J);
  }
  return work;
}

Manipulator ringOf(ForceLaw law) {
  Wanted wanted;
  wanted.chain = test::ring();
  wanted.orientation = Orientation::Angle;
  wanted.ko_N_m_per_rad = 0.25;
  wanted.law = law;
  wanted.tolerance = 1e-13;
  return test::made(wanted);
}

/// A stylus whose z points outward at an angle of the ring.
Mat3 pointing(double angle_rad) {
  return test::about(Vec3::UnitZ(), angle_rad) * test::tipAt(Vec3::Zero()).linear();
}

Vec3 onRing(double radius_m, double angle_rad) {
  return radius_m * Vec3(std::cos(angle_rad), std::sin(angle_rad), 0.0);
}

}  // namespace

TEST(Work, OnAClosedWayAtFixedTurnTheEnergysLawDoesNone) {
  test::property::Random random(test::property::Seed{20070631});
  for (test::Held& one : test::heldOnes()) {
    one.manipulator.options.tolerance = 1e-13;
    for (int i = 0; i < test::property::sweep(3, 30); ++i) {
      const Loop loop{one.X_WT.translation(), 0.008 * random.direction(), 0.006 * random.direction(),
                      0.002 * random.direction()};
      const Work work = around(one.manipulator, one.X_WT.linear(), loop, 512);
      EXPECT_NEAR(work.work_J, 0.0, 1e-12) << one.name;  // 1e-9 N mm
      EXPECT_GT(work.turnover_J, 1e-4) << one.name;      // and it is no path without forces
    }
  }
}

TEST(Work, OnAClosedWayTheThesissLawDoesWhatGreensTheoremSays) {
  // Of the pull along the circle, -(ko e / L) t with e = phi - alpha: round rho = rho0 + a cos s, phi = phi0 + b sin s
  // the work is -(ko / L) pi a b (phi0 - alpha); the pull towards the circle does none.
  const Manipulator m = ringOf(ForceLaw::Thesis52);
  const double phi0_rad = 0.4, alpha_rad = -0.4, a_m = 0.02, b_rad = 0.5;
  State state;
  const int points = 256;
  double work_J = 0.0;
  for (int i = 0; i < points; ++i) {
    const double s = 2.0 * kPi * i / points;
    const double rho_m = 0.05 + a_m * std::cos(s), phi_rad = phi0_rad + b_rad * std::sin(s);
    const Vec3 slope_W = onRing(-a_m * std::sin(s), phi_rad) + onRing(rho_m * b_rad * std::cos(s), phi_rad + kPi / 2);
    const Pose X_WT = test::poseOf(pointing(alpha_rad), onRing(rho_m, phi_rad));
    work_J += 2.0 * kPi / points * forceOf(m, follow(m, X_WT, 0.0, state), X_WT).dot(slope_W);
  }
  const double green_J = -(0.25 / 0.05) * kPi * a_m * b_rad * (phi0_rad - alpha_rad);
  EXPECT_NEAR(work_J, green_J, 1e-12);
  EXPECT_LT(work_J, -0.1);  // 0.13 J a round; backwards, the hand gains as much
}

TEST(Work, OnTheSameWayTheEnergysLawDoesNone) {
  const Manipulator m = ringOf(ForceLaw::Energy);
  const Loop loop{onRing(0.05, 0.4), onRing(0.015, 0.4), onRing(0.02, 0.4 + kPi / 2), Vec3::Zero()};
  const Work work = around(m, pointing(-0.4), loop, 256);
  EXPECT_NEAR(work.work_J, 0.0, 1e-12);
  EXPECT_GT(work.turnover_J, 0.1);
}

/// A way along the ring, or a turn of the stylus, in small steps from the last tick's state: the work of the force, and
/// what the moment would do if it were sent. Simpson's rule: 200 steps leave some 1e-11 of it.
struct Pumped {
  double force_J = 0.0;
  double moment_J = 0.0;
};
Pumped goOn(const Manipulator& m, double from_rad[2], const double to_rad[2], State& state) {
  constexpr int kSteps = 200;
  Pumped pumped;
  for (int i = 0; i <= kSteps; ++i) {
    const double share = static_cast<double>(i) / kSteps;
    const double weight = (i == 0 || i == kSteps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) / (3.0 * kSteps);
    const double phi_rad = from_rad[0] + share * (to_rad[0] - from_rad[0]);
    const double alpha_rad = from_rad[1] + share * (to_rad[1] - from_rad[1]);
    const Pose X_WT = test::poseOf(pointing(alpha_rad), onRing(0.05, phi_rad));
    const Followed followed = follow(m, X_WT, 0.0, state);
    const Vec3 slope_W = (to_rad[0] - from_rad[0]) * onRing(0.05, phi_rad + kPi / 2);
    pumped.force_J += weight * forceOf(m, followed, X_WT).dot(slope_W);
    pumped.moment_J += weight * followed.moment_W.z() * (to_rad[1] - from_rad[1]);
  }
  from_rad[0] = to_rad[0], from_rad[1] = to_rad[1];
  return pumped;
}

TEST(Work, TurningAndSlidingPumpsWhatTheMissingMomentWouldTakeAndNoMore) {
  // Turn by D, slide, turn back, slide: ks D^2 with 1 / ks = 1 / (kp L^2) + 1 / ko; 18.75 N mm for D = 0.3. Exactly it
  // is twice the least energy at a difference of D, ks D^2 less a share of the joint's fourth order (2e-5 here).
  const Manipulator m = ringOf(ForceLaw::Energy);
  const double turn_rad = 0.3;
  const double min_J = minEnergy(m, test::poseOf(pointing(turn_rad), onRing(0.05, 0.0))).at.energy_J;
  const double corners[4][2] = {{0.0, turn_rad}, {turn_rad, turn_rad}, {turn_rad, 0.0}, {0.0, 0.0}};
  double at_rad[2] = {0.0, 0.0};
  State state;
  for (int cycle = 0; cycle < 5; ++cycle) {
    double force_J = 0.0, moment_J = 0.0;
    for (const auto& corner : corners) {
      const Pumped pumped = goOn(m, at_rad, corner, state);
      force_J += pumped.force_J;
      moment_J += pumped.moment_J;
    }
    EXPECT_NEAR(force_J, 0.01875, 2e-6);
    EXPECT_NEAR(force_J, 2.0 * min_J, 1e-9);  // each cycle the same: nothing winds up
    EXPECT_NEAR(force_J + moment_J, 0.0, 1e-9);
  }
}

TEST(Work, APumpIsBoundedHoweverFarTheStylusTurns) {
  // A cycle gains at most twice the energy of half a turn, ko pi^2, whatever is done.
  const Manipulator m = ringOf(ForceLaw::Energy);
  for (const double turn_rad : {0.5, 1.5, 2.5, 3.1}) {
    const double corners[4][2] = {{0.0, turn_rad}, {turn_rad, turn_rad}, {turn_rad, 0.0}, {0.0, 0.0}};
    double at_rad[2] = {0.0, 0.0}, force_J = 0.0;
    State state;
    for (const auto& corner : corners) force_J += goOn(m, at_rad, corner, state).force_J;
    EXPECT_GT(force_J, 0.0);
    EXPECT_LE(force_J, 0.25 * kPi * kPi);
  }
}

}  // namespace underact::manipulator
