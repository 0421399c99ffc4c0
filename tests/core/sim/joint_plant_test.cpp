// The simulated arm that is not of the Omni's form, against what mechanics says of it.
#include <cmath>

#include "core/arm/forward.h"
#include "core/arm/inverse.h"
#include "core/arm/mechanism.h"
#include "core/arm/model.h"
#include "core/base/units.h"
#include "core/sim/mechanics.h"
#include "tests/support/property.h"

namespace underact::sim {
namespace {

constexpr std::int64_t kJointTick_ns = 1'000'000;
constexpr std::array kJointArms{"ur5e", "puma-560", "stanford", "cobra-600", "planar-3", "panda", "iiwa7"};

Plant plantNamed(const char* name, const HandModel& hand = {}, const char* model = "vendor-nominal") {
  return makePlant(*arm::findPreset(name), modelFor(*arm::findPreset(name), *findArmModel(model)), hand,
                   {Integrator::MeanVelocity, 200'000});
}

HandSetpoint atPlace(const Vec3& p_WT) {
  HandSetpoint setpoint;
  setpoint.p_WT = p_WT;
  return setpoint;
}

PlantState afterMs(const Plant& plant, PlantState state, const Vec3& f_T_W, const HandSetpoint& wish, int ms) {
  for (int tick = 0; tick < ms; ++tick) state = advance(plant, state, f_T_W, wish, kJointTick_ns);
  return state;
}

}  // namespace

TEST(JointPlant, StaysWhereItRests) {
  for (const char* name : kJointArms) {
    const Plant plant = plantNamed(name);
    const PlantState rest = restingState(plant);
    const PlantState later = afterMs(plant, rest, Vec3::Zero(), atPlace(rest.p_WT), 1000);
    EXPECT_LT((later.p_WT - rest.p_WT).norm(), 1e-12) << name;
    EXPECT_EQ(rest.p_WT, arm::tipPosition(plant.arm.geometry, rest.q_rad));
  }
}

TEST(JointPlant, BringsTheTipWhereTheHandWantsIt) {
  for (const char* name : kJointArms) {
    const Plant plant = plantNamed(name);
    const PlantState rest = restingState(plant);
    const Vec3 wish = rest.p_WT + Vec3(-0.02, 0.01, std::string_view(name) == "planar-3" ? 0.0 : -0.02);
    const PlantState later = afterMs(plant, rest, Vec3::Zero(), atPlace(wish), 6000);
    // Coulomb's friction, softened, creeps to the end: friction / (damping at 1 mm/s) of the way a second.
    EXPECT_LT((later.p_WT - wish).norm(), 1e-3) << name;
    EXPECT_EQ(arm::withinLimits(plant.arm.limits, later.q_rad), later.q_rad);
  }
}

TEST(JointPlant, HandAndMotorsBalance) {  // at rest: k (p_w - p) = -f, in the directions that the arm has
  for (const char* name : {"ur5e", "puma-560", "stanford", "panda"}) {
    Plant plant = plantNamed(name, {0.1, 4.0, 300.0});
    plant.model.friction_N = 0.0;
    const PlantState rest = restingState(plant);
    const Vec3 f_T_W(1.0, -0.5, 0.7);
    const PlantState later = afterMs(plant, rest, f_T_W, atPlace(rest.p_WT), 10000);
    EXPECT_LT((300.0 * (later.p_WT - rest.p_WT) - f_T_W).norm(), 1e-3) << name;
  }
}

TEST(JointPlant, ThePendulumOfOneLinkIsAccelerated) {  // torque over inertia, against a closed form
  const arm::Model model =
      arm::readArm(
          R"({"underact_arm": 1, "name": "rod", "title": "t", "provenance": "p", "convention": "classic",
          "dh": [{"alpha_deg": 0, "a_mm": 200, "d_mm": 0,
                  "mass": {"mass_kg": 3, "center_mm": [-100, 0, 0], "inertia_kg_mm2": [0, 10000, 10000, 0, 0, 0]}}],
          "X_WB": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]})",
          "rod.json")
          .value();
  const arm::Preset preset = arm::presetOf(model).value();
  Plant plant = makePlant(preset, modelFor(preset, *findArmModel("vendor-nominal")), {0.0, 0.0, 0.0},
                          {Integrator::MeanVelocity, 10'000});
  plant.model.friction_N = 0.0;
  const PlantState rest = restingState(plant);
  const PlantState later = afterMs(plant, rest, Vec3(0.0, 1.0, 0.0), atPlace(rest.p_WT), 20);
  const double inertia = 0.01 + 3.0 * 0.01 + 1e-3 * 0.04;    // about the joint, and the armature: 1 g at the reach
  const double rate = 10.0 * (0.01 + 3.0 * 0.01) / inertia;  // the joints' damping
  const double speed = 0.2 / inertia / rate * (1.0 - std::exp(-rate * 0.02));
  EXPECT_NEAR(later.dq[0] / speed, 1.0, 1e-3);  // of first order in the substep, and the lever turns by 1 mrad
}

TEST(JointPlant, UndrivenJointsAreMovedByTheHandAlone) {
  arm::Model model = *arm::findModel("planar-3");
  for (arm::JointFacts& joint : model.joints) joint.driven = false;
  const arm::Preset preset = arm::presetOf(model).value();
  const Plant plant = makePlant(preset, *findArmModel("vendor-nominal"), {0.0, 0.0, 0.0});
  const PlantState rest = restingState(plant);
  const PlantState later = afterMs(plant, rest, Vec3(5.0, 5.0, 0.0), atPlace(rest.p_WT), 100);
  EXPECT_EQ(later.q_rad, rest.q_rad);
}

TEST(JointPlant, StopsAtItsLimits) {
  for (const char* name : kJointArms) {
    const Plant plant = plantNamed(name);
    const PlantState rest = restingState(plant);
    const PlantState later = afterMs(plant, rest, Vec3::Zero(), atPlace(rest.p_WT + Vec3(-5.0, 3.0, 0.0)), 3000);
    EXPECT_EQ(arm::withinLimits(plant.arm.limits, later.q_rad), later.q_rad) << name;
    EXPECT_TRUE(later.p_WT.allFinite());
  }
}

TEST(JointPlant, TakesTheThreeIntegratorsOfWhichTheTrapezoidalIsOfSecondOrder) {
  for (const char* name : kJointArms) {
    const auto off_m = [name](Integrator integrator, std::int64_t substep_ns, bool leads, double friction_N) {
      const auto tipBy = [&](const Integration& integration) {
        Plant plant = plantNamed(name, {0.1, 4.0, 300.0});
        plant.model.friction_N = friction_N;
        plant.integration = integration;
        const PlantState rest = restingState(plant);
        HandSetpoint wish = atPlace(rest.p_WT + Vec3(-0.03, 0.02, 0.0));
        wish.v_WT = Vec3(0.1, 0.0, 0.0);
        wish.turns = true;
        if (leads) wish.posture = rest.q_rad, (*wish.posture)[1] += 0.2;
        return afterMs(plant, rest, Vec3(0.2, 0.5, 0.0), wish, 50).p_WT;
      };
      return (tipBy({integrator, substep_ns}) - tipBy({Integrator::Trapezoidal, 2'000})).norm();
    };
    for (const auto& [integrator, halved] :
         {std::pair{Integrator::EndVelocity, 2.0}, {Integrator::MeanVelocity, 2.0}, {Integrator::Trapezoidal, 4.0}}) {
      for (const bool leads : {false, true})
        EXPECT_NEAR(off_m(integrator, 200'000, leads, 0.0) / off_m(integrator, 100'000, leads, 0.0), halved, 0.4);
    }
    EXPECT_LT(off_m(Integrator::Trapezoidal, 200'000, false, 0.26),
              0.2 * off_m(Integrator::EndVelocity, 200'000, false, 0.26))
        << name << ", Coulomb's friction, softened";
  }
}

TEST(JointPlant, AnyInputLeavesItFiniteAndTheSameGivesTheSame) {
  test::Random random(test::Seed{3232});
  for (const char* name : kJointArms) {
    PlantState state = restingState(plantNamed(name));
    for (int i = 0; i < 300; ++i) {
      const HandModel hand{random.between(0.0, 1.0), std::pow(10.0, random.between(-6, 6)),
                           std::pow(10.0, random.between(-6, 9))};
      Plant plant = plantNamed(name, hand, random.between(0, 1) < 0.5 ? "ideal" : "vendor-nominal");
      plant.integration.integrator = static_cast<Integrator>(i % 3);
      HandSetpoint wish = atPlace(random.inBox(std::pow(10.0, random.between(-3, 12))));
      wish.turns = random.between(0, 1) < 0.5;
      if (random.between(0, 1) < 0.1) wish.p_WT.x() = kNotANumber;
      const Vec3 f_T_W = random.inBox(std::pow(10.0, random.between(-3, 12)));
      const PlantState next = advance(plant, state, f_T_W, wish, kJointTick_ns);
      const PlantState again = advance(plant, state, f_T_W, wish, kJointTick_ns);
      EXPECT_EQ(next.q_rad, again.q_rad);
      EXPECT_EQ(next.dq, again.dq);
      ASSERT_TRUE(next.p_WT.allFinite() && next.v_WT.allFinite()) << name;
      ASSERT_EQ(arm::withinLimits(plant.arm.limits, next.q_rad), next.q_rad);
      state = next;
      if (i % 20 == 19) state = restingState(plantNamed(name));
    }
  }
}

TEST(JointPlant, ReachesAPositionFromItsRestOrComesNear) {
  const Plant plant = plantNamed("ur5e");
  const Vec3 wanted(0.4, 0.2, 0.3);
  EXPECT_LT((restingState(plant, wanted).p_WT - wanted).norm(), 1e-6);
  const PlantState far = restingState(plant, Vec3(9.0, 0.0, 0.0));
  EXPECT_GT(far.p_WT.x(), 0.8);
}

TEST(JointPlant, EncodersShowTurnsAndSlidesInSteps) {
  arm::Preset preset = *arm::findPreset("cobra-600");
  preset.counts_per_turn = {1000, 0, 20, 0, 0, 0};
  const Plant plant = makePlant(preset, *findArmModel("vendor-nominal"), {});
  PlantState state = restingState(plant);
  state.q_rad = {0.1, 0.2, 0.10007, 0.3, 0.0, 0.0};
  const arm::JointAngles shown = shownAngles(plant, state);
  EXPECT_NEAR(shown[0], 16 * 2.0 * kPi / 1000, 1e-15);
  EXPECT_EQ(shown[1], 0.2);
  EXPECT_NEAR(shown[2], 0.10005, 1e-15);
  EXPECT_EQ(shown[3], 0.3);
}

}  // namespace underact::sim
