#include "core/lab/step_response.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/lab/unit_step.h"
#include "core/scene/read.h"

namespace underact::lab {
namespace {

scene::Description sceneOf(const std::string& constraint, const std::string& control = R"("law": "P")") {
  const std::string text =
      R"({"underact_scene": 1, "title": "Test", "control": {)" + control + R"(}, "constraints": [)" + constraint + "]}";
  return scene::readScene(text, "test").value();
}

const std::string kPoint = R"({"type": "point", "position_mm": [0, 0, 20]})";

/// An arm without friction and with exact angles, in a hand's mass and damping: what the model is of.
StepSetup smooth(double mass_kg, double damping_N_s_per_m) {
  StepSetup setup;
  setup.arm = *sim::findArmModel("ideal");
  setup.hand = {mass_kg, damping_N_s_per_m, 0.0};
  setup.rate_hz = 10'000;
  setup.limits = false;
  return setup;
}

/// The largest distance between measured and model, a share of the step.
double worstOf(const ArmStep& step) {
  const UnitStep model(step.analytic);
  double worst = 0.0;
  for (std::size_t index = 0; index < step.travel_m.value.size(); ++index) {
    const double y = model.at(step.travel_m.period_s * static_cast<double>(index));
    worst = std::max(worst, std::abs(step.travel_m.value[index] / step.step_m - y));
  }
  return worst;
}

TEST(ArmStep, WithoutFrictionAndAtAHighRateItIsTheModels) {
  // What is left is the sampling: it takes kp T / 2 from the damping, 0.6 % of it here.
  const ArmStep p = measureStep(sceneOf(kPoint), smooth(0.1, 4.0)).value();
  EXPECT_LT(worstOf(p), 0.01);
  EXPECT_NEAR(p.fit->omega_n_rad_per_s, std::sqrt(500.0 / 0.1), 0.3);
  EXPECT_NEAR(p.fit->zeta, (4.0 - 0.5 * 500.0 * 1e-4) / (2.0 * std::sqrt(500.0 * 0.1)), 1e-3);
  EXPECT_NEAR(p.fit->gain, 0.010, 1e-5);
  EXPECT_NEAR(p.steady_error_m, 0.0, 1e-6);
}

TEST(ArmStep, TheRateOfALawAddsToTheDampingAndItsIntegralAPole) {
  const std::string raw = R"(, "velocity": {"filter": "raw"})";
  const ArmStep pd =
      measureStep(sceneOf(kPoint, R"("law": "PD", "kd_N_s_per_mm": 0.003)" + raw), smooth(0.1, 4.0)).value();
  EXPECT_NEAR(pd.model.kd_N_s_per_m, 3.0, 1e-9);
  EXPECT_LT(worstOf(pd), 0.01);
  const ArmStep pid =
      measureStep(sceneOf(kPoint, R"("law": "PID", "kd_N_s_per_mm": 0.003, "ki_N_per_mm_s": 1.0)" + raw),
                  smooth(0.1, 4.0))
          .value();
  EXPECT_NEAR(pid.model.ki_N_per_m_s, 1000.0, 1e-6);
  EXPECT_EQ(poles(pid.analytic).size(), 3U);
  EXPECT_LT(worstOf(pid), 0.01);
}

TEST(ArmStep, TheSlowerTheTicksTheLessDampingIsLeft) {
  double last = 1.0;
  for (const int rate_hz : {8000, 4000, 2000, 1000}) {
    StepSetup setup = smooth(0.1, 4.0);
    setup.rate_hz = rate_hz;
    const double zeta = measureStep(sceneOf(kPoint), setup).value().fit->zeta;
    EXPECT_NEAR(zeta, (4.0 - 0.5 * 500.0 / rate_hz) / (2.0 * std::sqrt(50.0)), 3e-3) << rate_hz;
    EXPECT_LT(zeta, last);
    last = zeta;
  }
}

TEST(ArmStep, FrictionHoldsTheTipWithinItsOwnShareOfTheStiffness) {
  StepSetup setup;
  setup.arm = *sim::findArmModel("vendor-nominal");
  setup.step_m = 0.0004;  // kp times the step is 0.2 N, friction 0.26 N
  const ArmStep stuck = measureStep(sceneOf(kPoint), setup).value();
  EXPECT_FALSE(stuck.fit.has_value());
  EXPECT_EQ(stuck.measured.final_value, 0.0);
  for (const double step_m : {0.0012, 0.0015, 0.01, -0.01}) {
    setup.step_m = step_m;
    const ArmStep step = measureStep(sceneOf(kPoint), setup).value();
    EXPECT_TRUE(step.measured.settling_2pct_s.has_value()) << step_m;
    EXPECT_LE(std::abs(step.steady_error_m), 0.26 / 500.0 + 5e-5) << step_m;  // and an encoder step
    EXPECT_EQ(step.limited_ticks > 0, std::abs(step_m) > 0.88 / 500.0) << step_m;
    EXPECT_LE(step.peak_force_N, 0.88 * (1.0 + 1e-12));
  }
}

TEST(ArmStep, TheIntegralWorksTheFrictionOff) {
  StepSetup setup;
  setup.arm = *sim::findArmModel("vendor-nominal");
  setup.limits = false;
  const ArmStep pd = measureStep(sceneOf(kPoint, R"("law": "PD", "kd_N_s_per_mm": 0.004)"), setup).value();
  const ArmStep pid =
      measureStep(sceneOf(kPoint, R"("law": "PID", "kd_N_s_per_mm": 0.004, "ki_N_per_mm_s": 3)"), setup).value();
  EXPECT_LT(std::abs(pid.steady_error_m), 0.3 * std::abs(pd.steady_error_m));
}

TEST(ArmStep, TheSameStepGivesTheSameNumbers) {
  StepSetup setup;
  setup.arm = *sim::findArmModel("vendor-nominal");
  EXPECT_EQ(measureStep(sceneOf(kPoint), setup).value().travel_m.value,
            measureStep(sceneOf(kPoint), setup).value().travel_m.value);
}

TEST(ArmStep, AShapeIsMeasuredAcrossItself) {
  const StepSetup setup = smooth(0.1, 4.0);
  const std::string plane = R"({"type": "plane", "point_mm": [0, 0, 0], "normal": [1, 2, 2]})";
  const ArmStep tilted = measureStep(sceneOf(plane), setup).value();
  EXPECT_EQ(tilted.axis, Axis::Held);
  EXPECT_NEAR(std::abs(tilted.along_W.dot(Vec3(1, 2, 2) / 3.0)), 1.0, 1e-6);
  EXPECT_NEAR(tilted.model.kp_N_per_m, 500.0, 1e-3);
  EXPECT_LT(worstOf(tilted), 0.01);
  const ArmStep upright =
      measureStep(sceneOf(R"({"type": "plane", "point_mm": [0, 0, 0], "normal": [0, 1, 0]})"), setup).value();
  EXPECT_EQ(upright.axis, Axis::Y);
  const ArmStep uneven = measureStep(sceneOf(kPoint, R"("kp_N_per_mm": [0.5, 0.2, 0.4])"),
                                     [&] {
                                       StepSetup along_y = setup;
                                       along_y.axis = Axis::Y;
                                       return along_y;
                                     }())
                             .value();
  EXPECT_NEAR(uneven.model.kp_N_per_m, 200.0, 1e-6);
}

TEST(ArmStep, GainsOfJointsAreFeltByTheirLevers) {
  const ArmStep step = measureStep(sceneOf(kPoint, R"("law": "P", "space": "joint")"), smooth(0.1, 4.0)).value();
  EXPECT_GT(step.model.kp_N_per_m, 200.0);
  EXPECT_LT(step.model.kp_N_per_m, 2000.0);
  EXPECT_NEAR(step.fit->omega_n_rad_per_s / std::sqrt(step.model.kp_N_per_m / 0.1), 1.0, 0.1);
}

TEST(ArmStep, RefusesWhatItCannotMeasureInASentence) {
  const auto sentence = [](const scene::Description& scene, const StepSetup& setup) {
    const Result<ArmStep> step = measureStep(scene, setup);
    return step ? Sentence() : step.problems().at(0).sentence;
  };
  StepSetup setup = smooth(0.1, 4.0);
  const std::string wall = R"({"type": "plane", "point_mm": [0, 0, 0], "normal": [0, 1, 0], "side": "outside"})";
  EXPECT_NE(sentence(sceneOf(wall), setup).find("wall"), std::string::npos);
  EXPECT_NE(sentence(sceneOf(kPoint + "," + wall), setup).find("2 constraints"), std::string::npos);
  setup.constraint = "nothing";
  EXPECT_NE(sentence(sceneOf(kPoint), setup).find("nothing"), std::string::npos);
  setup.constraint.clear();
  setup.axis = Axis::X;
  EXPECT_NE(sentence(sceneOf(R"({"type": "line", "point_mm": [0, 0, 0], "direction": [1, 0, 0]})"), setup)
                .find("another axis"),
            std::string::npos);
  EXPECT_NE(sentence(sceneOf(kPoint), smooth(0.0, 0.0)).find("neither mass"), std::string::npos);
  StepSetup far = smooth(0.1, 4.0);
  far.step_m = 0.4;
  EXPECT_NE(sentence(sceneOf(kPoint), far).find("reach"), std::string::npos);
}

TEST(HeldMass, ItsFunctionIsThatOfTheLaw) {
  const HeldMass held{0.1, 2.0, 500.0, 3.0, 1000.0};
  EXPECT_EQ(transferOf(held, scene::LawType::P).value().den, (std::vector<double>{0.1, 2.0, 500.0}));
  EXPECT_EQ(transferOf(held, scene::LawType::PD).value().den, (std::vector<double>{0.1, 5.0, 500.0}));
  EXPECT_EQ(transferOf(held, scene::LawType::PID).value().den, (std::vector<double>{0.1, 5.0, 500.0, 1000.0}));
  EXPECT_EQ(transferOf(held, scene::LawType::PID).value().num, (std::vector<double>{500.0, 1000.0}));
  EXPECT_NEAR(naturalMotion(held, scene::LawType::PD).zeta, 5.0 / (2.0 * std::sqrt(50.0)), 1e-15);
  EXPECT_FALSE(transferOf({0.0, 0.0, 500.0, 3.0, 0.0}, scene::LawType::P));
  EXPECT_FALSE(transferOf({-0.1, 2.0, 500.0, 0.0, 0.0}, scene::LawType::P));
  EXPECT_EQ(transferOf({0.0, 2.0, 500.0, 0.0, 0.0}, scene::LawType::P).value().den.size(), 2U);  // first order
}

TEST(MovedTarget, EveryShapeGoesAlong) {
  const scene::Description scene = sceneOf(
      R"({"type": "box", "center_mm": [1, 2, 3], "size_mm": [10, 10, 10]},
         {"type": "circle", "center_mm": [1, 2, 3], "normal": [0, 0, 1], "radius_mm": 10},
         {"type": "cylinder", "point_mm": [1, 2, 3], "axis": [0, 0, 1], "radius_mm": 10},
         {"type": "virtual_manipulator", "joints": [{"type": "revolute", "axis": [0, 0, 1], "point_mm": [1, 2, 3]}],
          "X_WV_home": [[1, 0, 0, 1], [0, 1, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1]], "orientation": "none"})");
  const scene::Description moved = withTargetsMoved(scene, {10, 20, 30});
  const Vec3 there(11, 22, 33);
  EXPECT_EQ(std::get<scene::Box>(moved.constraints[0].shape).center_mm, there);
  EXPECT_EQ(std::get<scene::Circle>(moved.constraints[1].shape).center_mm, there);
  EXPECT_EQ(std::get<scene::Cylinder>(moved.constraints[2].shape).point_mm, there);
  const auto& robot = std::get<scene::VirtualManipulator>(moved.constraints[3].shape);
  EXPECT_EQ(robot.joints[0].point_mm, there);
  EXPECT_EQ(Vec3(robot.X_WV_home.topRightCorner<3, 1>()), there);
}

}  // namespace
}  // namespace underact::lab
