#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "core/base/units.h"
#include "core/scene/load_meshes.h"
#include "core/scene/read.h"
#include "core/tick/step.h"
#include "tests/core/scene/scene_support.h"

// Hands that nobody planned, through each scene in which the stylus's turn or a robot has a part.
namespace underact::scene {
namespace {

constexpr int kTicks = 20;
constexpr double kDt_s = 1e-3;

/// Joints somewhere within their limits, and how fast they go: up to 5 rad/s, the tip up to 1.4 m/s.
struct Motion {
  arm::JointAngles q_rad{};
  arm::JointAngles rate_rad_s{};
};

Motion drawn(const arm::Preset& arm, test::Random& random) {
  Motion motion;
  for (std::size_t joint = 0; joint < 6; ++joint) {
    motion.q_rad[joint] = random.between(arm.limits.min_rad[joint], arm.limits.max_rad[joint]);
    motion.rate_rad_s[joint] = random.between(-5.0, 5.0);
  }
  return motion;
}

/// How many ticks took so many steps.
using Histogram = std::array<long, 102>;

void print(const std::string& name, const Histogram& steps) {
  long all = 0, seen = 0;
  for (const long count : steps) all += count;
  std::printf("[    STEPS ] %s:", name.c_str());
  const std::array<std::pair<const char*, double>, 4> marks{
      {{"p50", 0.5}, {"p99", 0.99}, {"p99.9", 0.999}, {"max", 1.0}}};
  std::size_t mark = 0;
  for (std::size_t count = 0; count < steps.size() && mark < marks.size(); ++count) {
    seen += steps[count];
    while (mark < marks.size() && static_cast<double>(seen) >= marks[mark].second * static_cast<double>(all)) {
      std::printf(" %s %zu", marks[mark++].first, count);
    }
  }
  std::printf("\n");
}

class RandomHands : public ::testing::TestWithParam<const char*> {};

}  // namespace

TEST_P(RandomHands, NoNumberIsLostAndNoTargetJumps) {
  const std::string name = GetParam();
  Description scene = readSceneFile(std::string(UNDERACT_SOURCE) + "/scenes/" + name + ".json").value();
  const tick::TickProgram program = loadAndCompile(scene).value();
  const arm::Preset& arm = *arm::findPreset(scene.arm);
  test::Random random(test::Seed{20071201});
  Histogram steps{};
  for (int hand = 0; hand < test::sweep(300, 100'000); ++hand) {
    const Motion motion = drawn(arm, random);
    tick::TickState state = makeState(program);
    tick::TickReport report;
    std::array<Vec3, 4> last;
    for (int tick = 0; tick < kTicks; ++tick) {
      tick::TickInput input;
      input.engage = true;
      input.sample.time_ns = 1'000'000 * (tick + 1);
      for (std::size_t joint = 0; joint < 6; ++joint) {
        input.sample.q_rad[joint] = motion.q_rad[joint] + kDt_s * tick * motion.rate_rad_s[joint];
      }
      step(program, input, state, report);
      ASSERT_EQ(report.fault.kind, FaultKind::None) << hand;
      ASSERT_TRUE(report.f_T_W.allFinite() && report.force.f_T_W().allFinite()) << hand;
      ASSERT_LE(report.force.f_T_W().norm(), arm.continuous_force_N * (1.0 + 1e-15));
      for (std::size_t index = 0; index < report.held.size(); ++index) {
        const tick::ConstraintReport& held = report.held[index];
        ASSERT_EQ(held.status, target::Status::Unique) << hand;
        ASSERT_TRUE(held.p_WP.allFinite() && held.robot.moment_W.allFinite()) << hand;
        // A cylinder's target goes along with the tip besides.
        const bool slides = std::holds_alternative<Cylinder>(scene.constraints[index].shape);
        const double slew_m = manipulator::kSlew_m_per_s * kDt_s, along_m = slides ? 5e-3 : 0.0;
        if (tick > 0) {
          ASSERT_LE((held.p_WP - last[index]).norm(), (slew_m + along_m) * (1.0 + 1e-9)) << hand << ", tick " << tick;
        }
        last[index] = held.p_WP;
        if (held.robot.joints > 0) ++steps[std::min<std::size_t>(static_cast<std::size_t>(held.robot.steps), 101)];
      }
    }
  }
  print(name, steps);
}

INSTANTIATE_TEST_SUITE_P(EachScene, RandomHands,
                         ::testing::Values("14_circle_influence", "15_cylinder_influence", "16_one_joint_robot",
                                           "17_thesis_force_law", "18_sphere_of_two_joints", "19_four_bar", "20_scara",
                                           "21_puma_560", "22_out_of_reach", "23_two_beams"));

}  // namespace underact::scene
