// Ticks of arms that are not of the Omni's form.
#include "core/arm/general_arm.h"
#include "core/arm/model.h"
#include "core/scene/compile.h"
#include "core/scene/read.h"
#include "core/tick/state.h"
#include "core/tick/step.h"
#include "tests/support/property.h"

namespace underact::tick {
namespace {

TickProgram programFor(const std::string& arm, const Vec3& place_mm) {
  const std::string place = "[" + std::to_string(place_mm.x()) + ", " + std::to_string(place_mm.y()) + ", " +
                            std::to_string(place_mm.z()) + "]";
  return scene::compile(scene::readScene(R"({"underact_scene": 1, "title": "t", "arm": ")" + arm +
                                             R"(", "constraints": [{"type": "point", "position_mm": )" + place + "}]}",
                                         "s")
                            .value())
      .value();
}

TickInput at(const arm::JointAngles& q, std::int64_t ms, bool restart = false) {
  TickInput input;
  input.sample.q_rad = q;
  input.sample.time_ns = 1'000'000 * ms;
  input.has_sample = true;
  input.engage = true;
  input.restart = restart;
  input.period_s = 1e-3;
  return input;
}

const arm::JointAngles& restOf(const std::string& arm) {
  return arm::findPreset(arm)->geometry.general->rest;
}

}  // namespace

TEST(Arms, OfAPlaneIsSentNoForceOutOfItAndTheRestIsReported) {
  const TickProgram program = programFor("planar-3", {112.0, 170.0, 2.0});
  TickState state = makeState(program);
  TickReport report;
  for (std::int64_t ms = 1; ms <= 500; ++ms) step(program, at(restOf("planar-3"), ms, ms == 1), state, report);
  EXPECT_EQ(report.fault.kind, FaultKind::None);
  EXPECT_NEAR(report.f_T_W.z(), 1.0, 1e-9) << "2 mm at 0.5 N/mm";
  EXPECT_NEAR(report.force.f_T_W().z(), 0.0, 1e-12);
  EXPECT_NEAR(report.cuts.motors_N, 1.0, 1e-9);
  EXPECT_NE(safety::bitsOf(report.cuts) & safety::kMotorsBit, 0U);
  EXPECT_GT(report.force.f_T_W().head<2>().norm(), 0.5);
}

TEST(Arms, WithAllMotorsAreSentTheWholeForce) {
  const TickProgram program = programFor("ur5e", {650.0, -130.0, 233.0});
  TickState state = makeState(program);
  TickReport report;
  for (std::int64_t ms = 1; ms <= 500; ++ms) step(program, at(restOf("ur5e"), ms, ms == 1), state, report);
  EXPECT_EQ(report.cuts.motors_N, 0.0);
  EXPECT_EQ(report.force.f_T_W(), report.f_T_W);
}

TEST(Arms, FromOneToAnotherIsNoMotion) {
  const TickProgram omni = programFor("omni-thesis", Vec3::Zero()), ur = programFor("ur5e", {650.0, -130.0, 233.0});
  TickState state = makeState(omni);
  TickReport report;
  const arm::JointAngles q_rad{0.0, 0.6, 0.4, 0.0, 1.5, 0.0};
  for (std::int64_t ms = 1; ms <= 10; ++ms) step(omni, at(q_rad, ms, ms == 1), state, report);
  TickState next = makeState(ur);
  carryOver(omni, state, ur, next, Carry::Arm);
  for (std::int64_t ms = 11; ms <= 20; ++ms) step(ur, at(restOf("ur5e"), ms), next, report);
  EXPECT_EQ(report.fault.kind, FaultKind::None) << "half a metre in a millisecond is no hand's";
  TickState same = makeState(omni);
  carryOver(omni, state, omni, same, Carry::Arm);
  EXPECT_TRUE(same.has_time) << "of the Omni's form all stays as it was";
}

TEST(Arms, LimitsWatchTheDrivenJoints) {
  arm::JointAngles q = restOf("cobra-600");
  q[2] = 0.209;                                                                // a millimetre from the slide's stop
  const TickProgram program = programFor("cobra-600", {520.0, -25.0, 150.0});  // below: further out
  TickState state = makeState(program);
  TickReport report;
  for (std::int64_t ms = 1; ms <= 500; ++ms) step(program, at(q, ms, ms == 1), state, report);
  EXPECT_NEAR(report.cuts.edge_N, 4.0, 0.1) << "a fifth of 5 N is left of the last 5 mm";
}

TEST(Arms, AnyJointsGiveAFiniteForceWithinTheLimit) {
  test::Random random(test::Seed{4711});
  for (const char* name : {"ur5e", "planar-3", "cobra-600", "stanford"}) {
    const TickProgram program = programFor(name, {100.0, 50.0, 20.0});
    TickState state = makeState(program);
    TickReport report;
    for (int i = 0; i < 500; ++i) {
      arm::JointAngles q{};
      for (double& value : q) value = std::pow(10.0, random.between(-6.0, 9.0)) * random.between(-1.0, 1.0);
      step(program, at(q, i + 1, true), state, report);
      ASSERT_TRUE(report.force.f_T_W().allFinite());
      ASSERT_LE(report.force.f_T_W().norm(), program.limits.max_force_N * (1.0 + 1e-12));
    }
  }
}

}  // namespace underact::tick
