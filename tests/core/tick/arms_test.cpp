// Ticks of arms that are not of the Omni's form.
#include <sstream>

#include "core/arm/forward.h"
#include "core/arm/mechanism.h"
#include "core/arm/model.h"
#include "core/json/json.h"
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
  return arm::findPreset(arm)->geometry.mechanism->rest;
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

TEST(Arms, LimitsWatchJointsBeyondTheThirdToo) {
  arm::JointAngles q = restOf("panda");
  q[5] = arm::findPreset("panda")->limits.max_rad[5] - 0.01;  // a fifth of the last 3 degrees
  const chain::Kinematics at_stop = chain::kinematics(arm::findPreset("panda")->geometry.mechanism->chain, q);
  const Vec3 along = at_stop.J.col(5).head<3>().normalized();
  const auto cutFor = [&](double sign) {
    const TickProgram program = programFor("panda", 1e3 * at_stop.X_WT.translation() + 4.0 * sign * along);
    TickState state = makeState(program);
    TickReport report;
    for (std::int64_t ms = 1; ms <= 500; ++ms) step(program, at(q, ms, ms == 1), state, report);
    EXPECT_EQ(report.joints, 7);
    EXPECT_NEAR(report.f_T_W.norm(), 2.0, 1e-6);
    return report.cuts.edge_N;
  };
  EXPECT_NEAR(cutFor(1.0), 1.6, 1e-6) << "towards the stop of joint 6";
  EXPECT_EQ(cutFor(-1.0), 0.0) << "away from it";
}

TEST(Arms, EachDrivenJointHeatsUp) {
  const TickProgram program = programFor("panda", {560.0, 0.0, 480.0});
  TickState state = makeState(program);
  TickReport report;
  for (std::int64_t ms = 1; ms <= 2000; ++ms) step(program, at(restOf("panda"), ms, ms == 1), state, report);
  ASSERT_GT(report.force.f_T_W().norm(), 1.0);
  const chain::Jacobian J = chain::jacobian(arm::findPreset("panda")->geometry.mechanism->chain, restOf("panda"));
  for (std::size_t joint = 3; joint < 7; ++joint) {
    const double torque_N_m = J.col(static_cast<Eigen::Index>(joint)).head<3>().dot(report.force.f_T_W());
    EXPECT_EQ(state.gate.heat[joint] > 0.0, torque_N_m != 0.0) << "joint " << joint + 1;
  }
}

namespace {

/// A robot that holds the stylus to a pose turned by turn_rad from that of the arm at rest, about x.
TickProgram poseFor(const std::string& arm, double turn_rad, const std::string& arm_text = {}) {
  const arm::Preset& preset = *arm::findPreset(arm);
  const arm::JointAngles rest = arm::solvesInTick(preset.geometry) ? arm::JointAngles{0.0, 0.6, 0.4, 0.0, 1.5, 0.0}
                                                                   : preset.geometry.mechanism->rest;
  Pose X = arm::tipPose(preset.geometry, rest);
  X.linear() = Eigen::AngleAxisd(turn_rad, Vec3::UnitX()) * X.linear();
  std::string pose = "[";
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      std::ostringstream number;
      number.precision(17);
      number << (column == 3 && row < 3 ? 1e3 : 1.0) * X.matrix()(row, column);
      pose += (column == 0 ? (row == 0 ? "[" : ", [") : ", ") + number.str();
    }
    pose += "]";
  }
  const std::string named =
      arm_text.empty() ? json::quotedText(arm) : R"("a.json", "arm_text": )" + json::quotedText(arm_text);
  const std::string text = R"({"underact_scene": 1, "title": "t", "arm": )" + named +
                           R"(, "constraints": [{"type": "virtual_manipulator", "orientation": "full",
      "ko_N_mm_per_rad": 2000, "joints": [{"type": "prismatic", "axis": [1, 0, 0], "min": -0.001, "max": 0.001}],
      "X_WV_home": )" + pose +
                           "]}]}";
  return scene::compile(scene::readScene(text, "s", scene::NamedFiles::Closed).value()).value();
}

TickReport heldFor(const TickProgram& program, const arm::JointAngles& q, int ms = 600) {
  TickState state = makeState(program);
  TickReport report;
  for (std::int64_t now = 1; now <= ms; ++now) step(program, at(q, now, now == 1), state, report);
  EXPECT_EQ(report.fault.kind, FaultKind::None);
  return report;
}

}  // namespace

TEST(Arms, SixOfSixMotorsRenderTheMomentOfAPose) {
  const TickReport report = heldFor(poseFor("ur5e", 0.1), restOf("ur5e"));
  EXPECT_LT((report.m_T_W - Vec3(0.2, 0.0, 0.0)).norm(), 1e-6) << "2 N m/rad for 0.1 rad";
  EXPECT_LT((report.force.m_T_W() - report.m_T_W).norm(), 1e-9);
  EXPECT_NEAR(report.cuts.moment_N_m, 0.0, 1e-9);
}

TEST(Arms, TheMomentIsLimitedAndRampsLikeTheForce) {
  const TickProgram program = poseFor("ur5e", 1.0);
  EXPECT_DOUBLE_EQ(program.limits.max_moment_N_m, 0.5) << "5 N at 100 mm";
  const TickReport report = heldFor(program, restOf("ur5e"));
  EXPECT_NEAR(report.m_T_W.x(), 2.0, 1e-6);
  EXPECT_NEAR(report.force.m_T_W().norm(), 0.5, 1e-9);
  EXPECT_NEAR(report.cuts.moment_N_m, 1.5, 1e-6);
  EXPECT_NEAR(heldFor(program, restOf("ur5e"), 151).force.m_T_W().norm(), 0.25, 0.01) << "half of the soft start";
}

TEST(Arms, TheOmniRendersNoMoment) {
  const TickProgram program = poseFor("omni-thesis", 0.5);
  EXPECT_FALSE(program.needs.moment);
  const TickReport report = heldFor(program, {0.0, 0.6, 0.4, 0.0, 1.5, 0.0});
  ASSERT_EQ(report.held.size(), 1U);
  EXPECT_GT(report.held[0].robot.moment_W.norm(), 0.5) << "it is told";
  EXPECT_EQ(report.m_T_W, Vec3(Vec3::Zero()));
  EXPECT_EQ(report.force.m_T_W(), Vec3(Vec3::Zero())) << "but not sent";
}

TEST(Arms, MotorsGiveNoMoreThanTheirLargestTorque) {
  std::string text(arm::fileOf("ur5e"));
  const std::string key = "\"rest_deg\": 90";  // of joint 5
  text.insert(text.find(key), "\"max_torque_N_m\": 0.05, ");
  const TickProgram program = poseFor("ur5e", 0.2, text);
  const arm::Mechanism& arm = *program.geometry.mechanism;
  const TickReport report = heldFor(program, arm.rest);
  const chain::Jacobian J = chain::jacobian(arm.chain, arm.rest);
  Vec6 wrench;
  wrench << report.force.f_T_W(), report.force.m_T_W();
  EXPECT_NEAR(std::abs(J.col(4).dot(wrench)), 0.05, 1e-6) << "of 0.4 N m about an axis that is not across it";
  EXPECT_GT(report.cuts.moment_N_m, 0.05);
}

TEST(Arms, AnyJointsGiveAFiniteForceWithinTheLimit) {
  test::Random random(test::Seed{4711});
  for (const char* name : {"ur5e", "planar-3", "cobra-600", "stanford", "panda", "iiwa7"}) {
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
