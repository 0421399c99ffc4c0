#include <algorithm>
#include <cmath>

#include "core/control/law.h"
#include "tests/core/control/tick.h"
#include "tests/support/property.h"

namespace underact::control {
namespace {

constexpr double kMax_N = 0.88;

/// A stylus of 0.145 kg in a hand that only damps, 2 N s/m, drawn to a target by a force of at most kMax_N.
struct Drawn {
  PID law{Vec3::Constant(100.0), Vec3::Constant(4.0), Vec3::Constant(100.0), kMax_N, {}};
  bool told = true;  // the law is told that its force was cut
  LawState state = {};
  Vec3 p_W = Vec3::Zero(), v_W = Vec3::Zero();
  bool limited = false;

  void tick(const Vec3& target_W, const Vec3& pushed_T_W = Vec3::Zero()) {
    Vec3 f_T_W = force(law, state, target_W - p_W, {kTick_s, told && limited, false});
    limited = f_T_W.norm() > kMax_N;
    if (limited) f_T_W *= kMax_N / f_T_W.norm();
    v_W += kTick_s / 0.145 * (f_T_W + pushed_T_W - 2.0 * v_W);
    p_W += kTick_s * v_W;
  }
};

/// How far it goes past a target that was put away so far that the force is cut, as a share of the way.
double overshoot(bool told) {
  Drawn drawn;
  drawn.told = told;
  for (int n = 0; n < 500; ++n) drawn.tick(Vec3::Zero());
  drawn.state.velocity.has_last = false;  // as an edit that puts the target elsewhere
  const Vec3 target_W(0.1, 0, 0);
  double farthest_m = 0.0;
  for (int n = 0; n < 5000; ++n) {
    drawn.tick(target_W);
    farthest_m = std::max(farthest_m, drawn.p_W.x());
  }
  EXPECT_NEAR(drawn.p_W.x(), target_W.x(), 2e-4) << "and there it ends";
  return farthest_m / target_W.x() - 1.0;
}

TEST(AntiWindup, OutOfACutItOvershootsLessThanAnIntegralThatGrewOn) {
  const double with = overshoot(true), without = overshoot(false);
  EXPECT_LT(with, 0.02);     // 1.4 % in a script of its own
  EXPECT_GT(without, 0.08);  // 9.0 %
}

TEST(AntiWindup, AHandThatHeldAgainstTheCutForceIsNotThrownWhenItGivesWay) {
  for (const bool told : {true, false}) {
    Drawn drawn;
    drawn.told = told;
    for (int n = 0; n < 3000; ++n) drawn.tick(Vec3(0.02, 0, 0), {-2.0, 0, 0});  // 3 s against a force that is cut
    const double integral_N = std::abs(drawn.state.integral_T_W.x());
    if (told) {
      EXPECT_LT(integral_N, 0.1);
    } else {
      EXPECT_NEAR(integral_N, kMax_N, 1e-9) << "the case did not come up";
    }
  }
}

TEST(AntiWindup, OneAxisDoesNotStopAnotherThatUnwinds) {
  Drawn drawn;
  drawn.state.integral_T_W = {0.0, 0.4, 0.0};
  drawn.limited = true;
  // x is pressed into the cut, y pulls back: its error is against its force.
  drawn.tick(Vec3(0.05, -0.001, 0));
  EXPECT_EQ(drawn.state.integral_T_W.x(), 0.0);
  EXPECT_NEAR(drawn.state.integral_T_W.y(), 0.4 - 100.0 * 0.001 * kTick_s, 1e-15);
}

TEST(PidLaw, EachAxisHasGainsOfItsOwn) {
  Drawn drawn;
  drawn.law.kp_N_per_m = {10.0, 0.0, 0.0};
  drawn.law.kd_N_s_per_m = {0.0, 1.0, 0.0};
  drawn.law.ki_N_per_m_s = {0.0, 0.0, 1000.0};
  drawn.law.velocity = RawDifference{};
  (void)force(drawn.law, drawn.state, Vec3::Zero(), {kTick_s, false, false});
  const Vec3 f_T_W = force(drawn.law, drawn.state, Vec3::Constant(1e-3), {kTick_s, false, false});
  EXPECT_NEAR(f_T_W.x(), 0.01, 1e-15);
  EXPECT_NEAR(f_T_W.y(), 1.0, 1e-12);
  EXPECT_NEAR(f_T_W.z(), 1e-3, 1e-15);
}

TEST(PidLaw, APutTargetGivesNoKickOfTheDamper) {  // derivative on measurement
  for (const Velocity& velocity :
       {Velocity(LowPass{}), Velocity(RawDifference{}), Velocity(AdaptiveWindow{16, Vec3::Constant(55e-6)}),
        Velocity(Kalman{20e-6, 10.0})}) {
    Drawn drawn;
    drawn.law = {Vec3::Zero(), Vec3::Constant(4.0), Vec3::Zero(), kMax_N, velocity};
    for (int n = 0; n < 100; ++n) drawn.tick(Vec3::Zero());
    drawn.state.velocity.has_last = false;
    drawn.tick({0.05, 0, 0});
    EXPECT_EQ(drawn.v_W, Vec3(Vec3::Zero()));
  }
}

TEST(PidLaw, WithoutKiNothingOfAnOldIntegralStays) {
  const PID pid{Vec3::Constant(100.0), Vec3::Zero(), Vec3(0.0, 500.0, 500.0), kMax_N, {}};
  LawState state;
  state.integral_T_W = {0.3, 0.2, 0.1};
  (void)force(pid, state, Vec3::Zero(), {kTick_s, false, false});
  EXPECT_EQ(state.integral_T_W, Vec3(0.0, 0.2, 0.1)) << "nothing could unwind the one along x";
  const PD pd{Vec3::Constant(100.0), Vec3::Zero(), {}};
  (void)force(pd, state, Vec3::Zero(), {kTick_s, false, false});
  EXPECT_EQ(state.integral_T_W, Vec3(Vec3::Zero())) << "it must not come back with the next PID";
}

}  // namespace
}  // namespace underact::control
