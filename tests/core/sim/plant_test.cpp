#include "core/sim/plant.h"

#include <cmath>
#include <utility>

#include "core/arm/forward.h"
#include "core/arm/inverse.h"
#include "core/arm/sample.h"
#include "core/base/units.h"
#include "tests/support/property.h"

namespace underact::sim {
namespace {

constexpr std::int64_t kPlantMillisecond_ns = 1'000'000;
constexpr double kSubstep_s = 50e-6;
const Vec3 kMiddle(0.0, 0.0, 0.03);
// Nearer than this no step is taken: half an ulp of 0.033 m in half a substep is a speed that the demo hand's damper
// allows under this stretch of its spring, 3.5e-18 m / 25 us * 4 N s/m / 300 N/m.
constexpr double kStall_m = 1.9e-15;

Plant plantOf(const char* model, const HandModel& hand = {}) {
  return {*arm::findPreset("touch-measured"), *findArmModel(model), hand};
}

HandSetpoint stayAt(const Vec3& p_WT) {
  HandSetpoint setpoint;
  setpoint.p_WT = p_WT;
  return setpoint;
}

double energyOf(const Plant& plant, const PlantState& state, const Vec3& p_WH) {
  const double mass_kg = plant.model.mass_kg + plant.hand.mass_kg;
  return 0.5 * mass_kg * state.v_WT.squaredNorm() +
         0.5 * plant.hand.stiffness_N_per_m * (p_WH - state.p_WT).squaredNorm();
}

bool isInside(const Plant& plant, const PlantState& state) {
  return arm::withinLimits(plant.arm.limits, state.q_rad) == state.q_rad;
}

/// The stretch of a hand's spring after a wish that jumps by 1: M x'' + b x' + k x = 0 from x = 1 at rest, b below
/// critical.
double stretchAt(const Plant& plant, double t_s) {
  const double mass_kg = plant.model.mass_kg + plant.hand.mass_kg;
  const double decay = plant.hand.damping_N_s_per_m / (2.0 * mass_kg);
  const double omega = std::sqrt(plant.hand.stiffness_N_per_m / mass_kg - decay * decay);
  return std::exp(-decay * t_s) * (std::cos(omega * t_s) + decay / omega * std::sin(omega * t_s));
}

/// Largest distance from stretchAt() over 0.2 s, a share of the jump, with substeps of step_ns.
double stepError(const Plant& plant, std::int64_t step_ns) {
  const double jump_m = 0.01;
  PlantState state = restingState(plant, kMiddle);
  const HandSetpoint setpoint = stayAt(kMiddle + Vec3(jump_m, 0.0, 0.0));
  double worst = 0.0;
  for (std::int64_t time_ns = step_ns; time_ns <= 200 * kPlantMillisecond_ns; time_ns += step_ns) {
    state = advance(plant, state, Vec3::Zero(), setpoint, step_ns);
    const double stretch = (setpoint.p_WT.x() - state.p_WT.x()) / jump_m;
    worst = std::max(worst, std::abs(stretch - stretchAt(plant, 1e-9 * static_cast<double>(time_ns))));
  }
  return worst;
}

TEST(Plant, FollowsTheStepResponseOfMassSpringAndDamper) {
  const Plant plant = plantOf("ideal");
  // A first-order integrator is behind by about a substep's travel; the fastest travel of the jump is omega_0 a second.
  const double omega = std::sqrt(plant.hand.stiffness_N_per_m / plant.hand.mass_kg);
  EXPECT_LE(stepError(plant, 50'000), omega * kSubstep_s);
}

TEST(Plant, ByTheMeanVelocityHalvingTheSubstepHalvesTheError) {
  Plant plant = plantOf("ideal");
  plant.integration = {Integrator::MeanVelocity, kPlantMillisecond_ns};  // a call of advance() is one substep
  const double coarse = stepError(plant, 50'000), middle = stepError(plant, 25'000), fine = stepError(plant, 12'500);
  EXPECT_NEAR(coarse / middle, 2.0, 0.02);  // order 1: 2 + O(omega dt), omega dt = 0.003
  EXPECT_NEAR(middle / fine, 2.0, 0.01);
}

TEST(Plant, TheTrapezoidalIntegratorIsOfSecondOrder) {
  Plant plant = plantOf("ideal");
  plant.integration = {Integrator::Trapezoidal, kPlantMillisecond_ns};  // a call of advance() is one substep
  const double coarse = stepError(plant, 800'000), middle = stepError(plant, 400'000), fine = stepError(plant, 200'000);
  EXPECT_NEAR(coarse / middle, 4.0, 0.05);  // order 2: 4 + O((omega dt)^2), omega dt = 0.05
  EXPECT_NEAR(middle / fine, 4.0, 0.02);
}

TEST(Plant, GoesInSubstepsOfTheLengthThatItIsTold) {
  for (const Integrator integrator : {Integrator::MeanVelocity, Integrator::EndVelocity, Integrator::Trapezoidal}) {
    Plant coarse = plantOf("vendor-nominal"), fine = coarse;
    coarse.integration = {integrator, 250'000};
    fine.integration = {integrator, kPlantMillisecond_ns};
    const PlantState start{kMiddle, Vec3(0.1, 0.0, 0.0), restingState(coarse, kMiddle).q_rad};
    HandSetpoint setpoint = stayAt(kMiddle);
    setpoint.v_WT = Vec3(0.0, 0.2, 0.0);
    PlantState parts = start;
    for (int part = 4; part-- > 0;) {
      HandSetpoint there = setpoint;
      there.p_WT -= part * 0.25e-3 * setpoint.v_WT;
      parts = advance(fine, parts, Vec3(0.5, 0.0, 0.0), there, 250'000);
    }
    const PlantState whole = advance(coarse, start, Vec3(0.5, 0.0, 0.0), setpoint, kPlantMillisecond_ns);
    EXPECT_LE((whole.p_WT - parts.p_WT).norm(), 1e-16);  // roundings of 0.06 m
    EXPECT_NE(whole.p_WT, advance(fine, start, Vec3(0.5, 0.0, 0.0), setpoint, kPlantMillisecond_ns).p_WT);
  }
}

TEST(Plant, ByTheEndVelocityAForceActsHalfASubstepEarly) {
  Plant plant = plantOf("ideal", {0.1, 0.0, 0.0});
  plant.integration = {Integrator::EndVelocity, 50'000};
  const PlantState state =
      advance(plant, restingState(plant, kMiddle), Vec3(0.1, 0.0, 0.0), stayAt(kMiddle), kPlantMillisecond_ns);
  const double t_s = 1e-3;  // x = a t (t + dt) / 2 where it should be a t^2 / 2
  EXPECT_NEAR(state.p_WT.x() - kMiddle.x(), 0.5 * t_s * (t_s + kSubstep_s), 1e-16);
}

TEST(Plant, ItsOwnDampingSlowsItDownWhateverTheHandWants) {
  Plant plant = plantOf("ideal", {0.1, 0.0, 0.0});
  plant.model.damping_N_s_per_m = 2.0;
  PlantState state = restingState(plant, kMiddle);
  state.v_WT = Vec3(0.1, 0.0, 0.0);
  for (int tick = 0; tick < 100; ++tick) {
    state = advance(plant, state, Vec3::Zero(), stayAt(kMiddle), kPlantMillisecond_ns);
  }
  const double decay = 2.0 / 0.1 * 0.1;  // b / m times 0.1 s; implicitly, (1 + dt b / m) per substep
  EXPECT_NEAR(state.v_WT.x(), 0.1 * std::exp(-decay), 0.1 * std::exp(-decay) * decay * kSubstep_s * 2.0 / 0.1);
}

TEST(Plant, TakesTheEncodersOfItsModelWhereThatHasItsOwn) {
  ArmModel model = *findArmModel("vendor-nominal");
  EXPECT_EQ(makePlant(*arm::findPreset("touch-measured"), model, {}).arm.counts_per_turn,
            arm::findPreset("touch-measured")->counts_per_turn);
  model.counts_per_turn = arm::EncoderCounts{100, 200, 300, 400, 500, 600};
  EXPECT_EQ(makePlant(*arm::findPreset("touch-measured"), model, {}).arm.counts_per_turn, *model.counts_per_turn);
}

TEST(Plant, UnderAForceTheHandsSpringGivesWayByHookesLaw) {
  const Plant plant = plantOf("ideal");
  PlantState state = restingState(plant, kMiddle);
  const Vec3 f_T_W(0.6, -0.3, 0.9);
  for (int tick = 0; tick < 5000; ++tick) state = advance(plant, state, f_T_W, stayAt(kMiddle), kPlantMillisecond_ns);
  const Vec3 expected_W = kMiddle + f_T_W / plant.hand.stiffness_N_per_m;  // after 5 s, 100 time constants of the decay
  EXPECT_LE((state.p_WT - expected_W).cwiseAbs().maxCoeff(), kStall_m);
}

TEST(Plant, SticksBelowItsFrictionToTheLastBit) {
  const Plant plant = plantOf("vendor-nominal", {0.1, 0.0, 0.0});
  const PlantState rest = restingState(plant, kMiddle);
  PlantState state = rest;
  const Vec3 direction = Vec3(1.0, -2.0, 2.0) / 3.0;
  for (int tick = 0; tick < 1000; ++tick) {
    state = advance(plant, state, 0.2599 * direction, stayAt(kMiddle), kPlantMillisecond_ns);
  }
  EXPECT_EQ(state.p_WT, rest.p_WT);
  EXPECT_EQ(state.v_WT, Vec3::Zero());
}

TEST(Plant, SlidesAboveItsFrictionByTheRest) {
  const Plant plant = plantOf("vendor-nominal", {0.1, 0.0, 0.0});
  PlantState state = restingState(plant, kMiddle);
  for (int tick = 0; tick < 100; ++tick) {
    state = advance(plant, state, Vec3(0.27, 0.0, 0.0), stayAt(kMiddle), kPlantMillisecond_ns);
  }
  const double speed_m_per_s = (0.27 - 0.26) / 0.145 * 0.1;  // constant force over 0.1 s
  EXPECT_NEAR(state.v_WT.x(), speed_m_per_s, 1e-12);         // 2000 roundings of impulses of 1.35e-5 N s, over 0.145 kg
  EXPECT_NEAR(state.p_WT.x(), 0.5 * speed_m_per_s * 0.1, 1e-12);  // exact: the mean velocity of each substep counts
}

TEST(Plant, FrictionBringsItToRestAndNeverBack) {
  const Plant plant = plantOf("vendor-nominal", {0.1, 0.0, 0.0});
  PlantState state = restingState(plant, kMiddle);
  state.v_WT = Vec3(0.1, -0.05, 0.02);
  const double stops_s = state.v_WT.norm() * 0.145 / 0.26;  // 63.3 ms
  for (double t_s = 0.0; t_s < stops_s + 0.005; t_s += 0.001) {
    const Vec3 v_before = state.v_WT;
    state = advance(plant, state, Vec3::Zero(), stayAt(kMiddle), kPlantMillisecond_ns);
    ASSERT_GE(state.v_WT.dot(v_before), 0.0);
    EXPECT_EQ(state.v_WT == Vec3::Zero(), t_s + 0.001 > stops_s) << t_s;
  }
}

TEST(Plant, AStretchThatFrictionCanHoldIsHeld) {  // 0.26 N over 300 N/m: 0.867 mm
  const Plant plant = plantOf("vendor-nominal");
  const PlantState rest = restingState(plant, kMiddle);
  const auto after = [&](double stretch_m) {
    PlantState state = rest;
    for (int tick = 0; tick < 100; ++tick) {
      state = advance(plant, state, Vec3::Zero(), stayAt(kMiddle + Vec3(0, stretch_m, 0)), kPlantMillisecond_ns);
    }
    return state.p_WT;
  };
  EXPECT_EQ(after(0.86e-3), rest.p_WT);
  EXPECT_GT(after(0.88e-3).y(), rest.p_WT.y());
}

TEST(Plant, ItsEnergyNeverGrowsByItself) {
  test::Random random(test::Seed{5});
  const HandModel hands[]{{0.1, 4.0, 300.0}, {0.1, 0.0, 300.0}, {0.554, 6.45, 135.0}, {0.01, 0.0, 20000.0}};
  for (const char* const model : {"ideal", "vendor-nominal"}) {
    for (const HandModel& hand : hands) {
      const Plant plant = plantOf(model, hand);
      for (int draw = 0; draw < test::sweep(10, 1000); ++draw) {
        PlantState state = restingState(plant, kMiddle);
        state.v_WT = random.inBox(0.1);
        const HandSetpoint setpoint = stayAt(kMiddle + random.inBox(0.01));
        double energy_J = energyOf(plant, state, setpoint.p_WT);
        for (int tick = 0; tick < 300; ++tick) {
          state = advance(plant, state, Vec3::Zero(), setpoint, kPlantMillisecond_ns);
          const double next_J = energyOf(plant, state, setpoint.p_WT);
          // A stretch is known to the rounding of the place, 3.5e-18 m at 0.03 m (twenty times a tick): its square's
          // energy.
          const double slack_J = hand.stiffness_N_per_m * 0.02 * 1e-16 + 1e-14 * energy_J;
          ASSERT_LE(next_J, energy_J + slack_J) << model << ", " << hand.stiffness_N_per_m << " N/m, tick " << tick;
          energy_J = next_J;
        }
      }
    }
  }
}

TEST(Plant, AWishThatMovesEvenlyIsFollowedWithoutLag) {  // the wish is for the end of the period
  const Plant plant = plantOf("ideal");
  PlantState state = restingState(plant, kMiddle);
  state.v_WT = Vec3(0.05, 0.02, -0.03);
  HandSetpoint setpoint = stayAt(kMiddle);
  setpoint.v_WT = state.v_WT;
  for (int tick = 1; tick <= 200; ++tick) {
    setpoint.p_WT = kMiddle + 1e-3 * tick * setpoint.v_WT;
    state = advance(plant, state, Vec3::Zero(), setpoint, kPlantMillisecond_ns);
    ASSERT_LE((state.p_WT - setpoint.p_WT).cwiseAbs().maxCoeff(), kStall_m) << tick;
  }
}

TEST(Plant, APeriodIsItsSubsteps) {
  const Plant plant = plantOf("vendor-nominal");
  PlantState whole = restingState(plant, kMiddle);
  PlantState parts = whole;
  const HandSetpoint setpoint = stayAt(kMiddle + Vec3(0.01, 0.005, -0.01));
  for (int tick = 0; tick < 100; ++tick) {
    const Vec3 f_T_W(0.3 * std::sin(0.1 * tick), 0.0, 0.5);
    whole = advance(plant, whole, f_T_W, setpoint, kPlantMillisecond_ns + 10'000);  // 20 whole substeps and a short one
    for (std::int64_t part_ns = 0; part_ns < kPlantMillisecond_ns; part_ns += kSubstep_ns)
      parts = advance(plant, parts, f_T_W, setpoint, kSubstep_ns);
    parts = advance(plant, parts, f_T_W, setpoint, 10'000);
    ASSERT_EQ(whole.p_WT, parts.p_WT);
    ASSERT_EQ(whole.v_WT, parts.v_WT);
    ASSERT_EQ(whole.q_rad, parts.q_rad);
  }
}

TEST(Plant, JointsBringTheTipToWhereItIs) {
  const Plant plant = plantOf("vendor-nominal");
  PlantState state = restingState(plant, kMiddle);
  test::Random random(test::Seed{6});
  for (int tick = 0; tick < 1000; ++tick) {
    state = advance(plant, state, random.inBox(3.3), stayAt(kMiddle), kPlantMillisecond_ns);
    ASSERT_LE((arm::tipPosition(plant.arm.geometry, state.q_rad) - state.p_WT).norm(),
              2e-15);  // as inverse_test: kTip_m
  }
}

TEST(Plant, RestsInsideReachAndLimitsWithTheGimbalInTheMiddle) {
  for (const arm::Preset& preset : arm::presets()) {
    const Plant plant{preset, *findArmModel("ideal"), {}};
    const PlantState state = restingState(plant, Vec3(0.0, 0.0, 0.06));
    EXPECT_EQ(state.p_WT, Vec3(0.0, 0.0, 0.06));
    EXPECT_EQ(state.v_WT, Vec3::Zero());
    EXPECT_EQ(state.q_rad[3], 0.0);
    EXPECT_EQ(state.q_rad[4], kPi / 2);
    EXPECT_EQ(state.q_rad[5], -kPi / 2);
    for (const Vec3& p_WT : test::pointsInBox(1.0, 500, test::Seed{7})) {
      const PlantState held = restingState(plant, p_WT);
      ASSERT_TRUE(isInside(plant, held));
      ASSERT_LE((arm::tipPosition(preset.geometry, held.q_rad) - held.p_WT).norm(), 2e-15);
    }
  }
}

TEST(Plant, ALimitStopsItAndLetsItGoAgain) {
  const Plant plant = plantOf("ideal", {0.1, 0.0, 0.0});
  for (const Vec3& direction :
       {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)}) {
    PlantState state = restingState(plant, kMiddle);
    for (int tick = 0; tick < 1000; ++tick) {
      state = advance(plant, state, 2.0 * direction, stayAt(kMiddle), kPlantMillisecond_ns);
      ASSERT_TRUE(isInside(plant, state));
      ASSERT_LE((arm::tipPosition(plant.arm.geometry, state.q_rad) - state.p_WT).norm(), 2e-15);
    }
    // 2 N on 0.1 kg over 1 s would be 20 m/s outwards; what is left is sliding along the limit.
    const double outwards_m_per_s = state.v_WT.dot(direction);
    EXPECT_LT(outwards_m_per_s, 0.05) << direction.transpose();
    const Vec3 at_limit = state.p_WT;
    for (int tick = 0; tick < 100; ++tick) {
      state = advance(plant, state, -2.0 * direction, stayAt(kMiddle), kPlantMillisecond_ns);
    }
    // Free: 2 N, 0.1 kg, 0.1 s: 0.1 m. From the corner of +y it slides down along the stop of joint 2: 11 mm.
    EXPECT_LT((state.p_WT - at_limit).dot(direction), -0.01) << direction.transpose();
  }
}

TEST(Plant, FromBeyondItsReachTheTipComesBackAsFastAsItCame) {  // a stop takes what goes outwards alone
  const Plant plant = plantOf("ideal", {0.1, 0.0, 0.0});
  const Vec3 out_W(0.0, 1.0, 0.0);
  PlantState state = restingState(plant, kMiddle);
  state.p_WT = kMiddle + out_W;
  state.v_WT = -out_W;
  const PlantState back = advance(plant, state, Vec3::Zero(), stayAt(kMiddle), kPlantMillisecond_ns);
  ASSERT_TRUE(isInside(plant, back));
  EXPECT_NEAR((back.v_WT - state.v_WT).norm(), 0.0, 1e-12);  // no force, no damping, no spring: nothing slows it
}

TEST(Plant, AtAStopTheTipSlidesAndDoesNotLeap) {
  for (const arm::Preset& preset : arm::presets()) {
    const Plant plant{preset, *findArmModel("vendor-nominal"), {}};
    const double mass_kg = plant.model.mass_kg + plant.hand.mass_kg;
    PlantState state = restingState(plant, kMiddle);
    int cut = 0;
    for (const Vec3& p_WH : test::pointsInBox(0.3, 200, test::Seed{20261121})) {  // most are out of reach
      for (int tick = 0; tick < 100; ++tick) {
        const PlantState before = state;
        state = advance(plant, state, Vec3::Zero(), stayAt(p_WH), kPlantMillisecond_ns);
        // Freely it would get no further than this; at a stop it goes to the place that is nearest to there, and the
        // one it came from is one of those there are: at most twice as far.
        const double pull_m_per_s2 = plant.hand.stiffness_N_per_m * (p_WH - before.p_WT).norm() / mass_kg;
        const double freely_m = 0.001 * (before.v_WT.norm() + 0.001 * pull_m_per_s2);
        ASSERT_LE((state.p_WT - before.p_WT).norm(), 2.0 * freely_m + 1e-9) << preset.name << " " << p_WH.transpose();
        ASSERT_TRUE(isInside(plant, state));
        for (std::size_t joint = 0; joint < 3; ++joint) {
          if (state.q_rad[joint] == preset.limits.max_rad[joint] || state.q_rad[joint] == preset.limits.min_rad[joint])
            ++cut;
        }
      }
    }
    EXPECT_GT(cut, 1000) << preset.name;
  }
}

TEST(Plant, TheWristTurnsWhenTheHandTurns) {
  const Plant plant = plantOf("vendor-nominal");
  PlantState state = restingState(plant, kMiddle);
  HandSetpoint setpoint = stayAt(kMiddle);
  arm::JointAngles turned_rad = state.q_rad;
  turned_rad[3] += 0.3;
  turned_rad[4] -= 0.2;
  turned_rad[5] += 0.4;
  setpoint.R_WT = arm::tipPose(plant.arm.geometry, turned_rad).linear();
  state = advance(plant, state, Vec3::Zero(), setpoint, kPlantMillisecond_ns);
  EXPECT_EQ(state.q_rad[5], -kPi / 2);  // not meant: it stays
  setpoint.turns = true;
  state = advance(plant, state, Vec3::Zero(), setpoint, kPlantMillisecond_ns);
  // sin q5 = 0.98: a few roundings of angles below 2 pi.
  for (std::size_t joint = 3; joint < 6; ++joint) EXPECT_NEAR(state.q_rad[joint], turned_rad[joint], 2e-15);
  setpoint.R_WT = -setpoint.R_WT;
  setpoint.R_WT.col(0) = -setpoint.R_WT.col(0);  // right-handed again, far from where the gimbal can go
  state = advance(plant, state, Vec3::Zero(), setpoint, kPlantMillisecond_ns);
  EXPECT_TRUE(isInside(plant, state));
}

TEST(Plant, TakesANaNAsNoForceAndAHandAtRest) {
  const Plant plant = plantOf("ideal");
  PlantState moving = restingState(plant, kMiddle);
  moving.v_WT = Vec3(0.1, 0.0, -0.1);
  const HandSetpoint stay = stayAt(kMiddle);
  const PlantState expected = advance(plant, moving, Vec3::Zero(), stay, kPlantMillisecond_ns);
  for (const double strange : {kNotANumber, kInfinity, -kInfinity}) {
    const PlantState pushed = advance(plant, moving, Vec3(0.0, strange, 0.0), stay, kPlantMillisecond_ns);
    EXPECT_EQ(pushed.p_WT, expected.p_WT);
    EXPECT_EQ(pushed.v_WT, expected.v_WT);
    HandSetpoint setpoint = stayAt(Vec3(strange, 0.0, 0.0));
    setpoint.v_WT = Vec3(1.0, 0.0, 0.0);
    EXPECT_EQ(advance(plant, moving, Vec3::Zero(), setpoint, kPlantMillisecond_ns).p_WT, expected.p_WT);
    setpoint = stayAt(kMiddle);
    setpoint.v_WT.x() = strange;
    EXPECT_EQ(advance(plant, moving, Vec3::Zero(), setpoint, kPlantMillisecond_ns).p_WT, expected.p_WT);
    HandSetpoint turn = stay;
    turn.turns = true;
    turn.R_WT(1, 2) = strange;
    EXPECT_EQ(advance(plant, moving, Vec3::Zero(), turn, kPlantMillisecond_ns).q_rad, expected.q_rad);
  }
}

TEST(Plant, HoweverLargeTheForceItStaysFinite) {
  const Plant plant = plantOf("vendor-nominal");
  for (const double force_N : {1e10, 1e150, 1e300, 1.7e308}) {
    PlantState state = restingState(plant, kMiddle);
    for (int tick = 0; tick < 10; ++tick) {
      state = advance(plant, state, Vec3(force_N, -force_N, force_N), stayAt(kMiddle), kPlantMillisecond_ns);
      ASSERT_TRUE(state.p_WT.allFinite() && state.v_WT.allFinite()) << force_N;
      ASSERT_TRUE(isInside(plant, state)) << force_N;
    }
  }
  PlantState pulled = restingState(plant, kMiddle);
  pulled = advance(plant, pulled, Vec3::Zero(), stayAt(Vec3(1.7e308, 0.0, 0.0)),
                   kPlantMillisecond_ns);  // its spring overflows
  EXPECT_EQ(pulled.p_WT, kMiddle);
  EXPECT_EQ(pulled.v_WT, Vec3::Zero());
  const Plant weightless = plantOf("ideal", {0.0, 0.0, 0.0});  // nothing there that a force could move
  EXPECT_EQ(
      advance(weightless, restingState(weightless, kMiddle), Vec3(1, 2, 3), stayAt(kMiddle), kPlantMillisecond_ns).p_WT,
      kMiddle);
}

TEST(Encoders, OneStepOfThighOrShinMovesTheTipByAbout54Micrometres) {  // 15 400 steps a turn at 0.133 m: 0.0545 mm
  const arm::Preset& preset = *arm::findPreset("touch-measured");
  const arm::JointAngles rest_device =
      arm::deviceFromDh(quantized(preset, restingState(plantOf("ideal"), kMiddle).q_rad));
  for (const std::size_t joint : {1U, 2U}) {
    arm::JointAngles device_rad = rest_device;
    device_rad[joint] += 0.6 * 2.0 * kPi / preset.counts_per_turn[joint];  // more than half a step: the next one
    const arm::JointAngles stepped = quantized(preset, arm::dhFromDevice(device_rad));
    const double moved_m =
        (arm::tipPosition(preset.geometry, stepped) - arm::tipPosition(preset.geometry, arm::dhFromDevice(rest_device)))
            .norm();
    EXPECT_NEAR(moved_m, 0.0545e-3, 0.0003e-3)
        << joint;  // 2 pi / 15399 and / 15419 of 133.35 mm; the figure's rounding
  }
}

TEST(Encoders, ShowWholeStepsOfTheDeviceNearestToTheAngle) {
  test::Random random(test::Seed{8});
  const arm::Preset& preset = *arm::findPreset("touch-measured");
  for (int draw = 0; draw < test::sweep(500, 50000); ++draw) {
    arm::JointAngles q_rad{};
    for (double& angle_rad : q_rad) angle_rad = random.between(-2.5, 2.5);
    const arm::JointAngles exact = arm::deviceFromDh(q_rad);
    const arm::JointAngles shown = arm::deviceFromDh(quantized(preset, q_rad));
    for (std::size_t joint = 0; joint < 6; ++joint) {
      const double step_rad = 2.0 * kPi / preset.counts_per_turn[joint], steps = shown[joint] / step_rad;
      ASSERT_LE(std::abs(steps - std::round(steps)), 1e-11);  // the conversion's rounding, 1e-15 rad, of a step of 4e-4
      ASSERT_LE(std::abs(shown[joint] - exact[joint]), 0.5 * step_rad * (1 + 1e-11));
    }
  }
}

TEST(Encoders, MeasureTheShinFromTheBase) {
  const arm::Preset& preset = *arm::findPreset("touch-measured");
  const double step_rad = 2.0 * kPi / preset.counts_per_turn[1];
  // The thigh turns by a step, the shin keeps its place in space: q2 up, q3 down.
  const arm::JointAngles before = quantized(preset, {0, 100 * step_rad, 0.2, 0, 1, 0});
  const arm::JointAngles after = quantized(preset, {0, 101 * step_rad, 0.2 - step_rad, 0, 1, 0});
  EXPECT_NEAR(after[1] - before[1], step_rad, 1e-15);
  EXPECT_NEAR(after[1] + after[2], before[1] + before[2], 1e-15);
}

TEST(Encoders, AStepIsOfOneEncoderAndOfASlideInMillimetres) {
  const arm::Preset& omni = *arm::findPreset("touch-measured");
  const arm::JointAngles q_rad{0.1, 0.6, 0.2, 0.3, 1.0, 0.4};
  for (std::size_t joint = 0; joint < 6; ++joint) {
    arm::JointAngles device_rad = arm::deviceFromDh(afterEncoderStep(omni, q_rad, joint));
    device_rad[joint] -= 2.0 * kPi / omni.counts_per_turn[joint];
    for (std::size_t other = 0; other < 6; ++other)
      EXPECT_NEAR(device_rad[other], arm::deviceFromDh(q_rad)[other], 4e-16) << joint << " of " << other;
  }
  arm::Preset scara = *arm::findPreset("cobra-600");
  EXPECT_EQ(afterEncoderStep(scara, q_rad, 2), q_rad) << "its readings are exact";
  scara.counts_per_turn = {1000, 0, 50};
  EXPECT_DOUBLE_EQ(afterEncoderStep(scara, q_rad, 0)[0], 0.1 + 2e-3 * kPi);
  EXPECT_DOUBLE_EQ(afterEncoderStep(scara, q_rad, 2)[2], 0.2 + 20e-6) << "50 steps a millimetre";
}

TEST(ArmModel, IsFoundByItsNameAndSaysWhereItComesFrom) {
  for (const ArmModel& model : armModels()) {
    EXPECT_EQ(findArmModel(model.name), &model);
    EXPECT_FALSE(model.provenance.empty());
  }
  EXPECT_EQ(findArmModel("premium"), nullptr);
  ASSERT_NE(findArmModel(kDefaultArmModel), nullptr);
  EXPECT_EQ(findArmModel(kDefaultArmModel)->mass_kg, 0.045);
  EXPECT_EQ(findArmModel(kDefaultArmModel)->friction_N, 0.26);
}

}  // namespace
}  // namespace underact::sim
