#include "core/lab/extremes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/arm/general_arm.h"
#include "core/base/denormals.h"
#include "core/base/random.h"
#include "core/tick/step.h"

namespace underact::lab {
namespace {

constexpr std::int64_t kPeriod_ns = 1'000'000;

arm::JointAngles drawnPose(const arm::Preset& arm, std::uint64_t& state) {
  arm::JointAngles q_rad{};
  for (std::size_t joint = 0; joint < arm::jointsOf(arm.geometry); ++joint) {
    const double least_rad = arm.limits.min_rad[joint], most_rad = arm.limits.max_rad[joint];
    const bool has_limits = std::isfinite(least_rad) && std::isfinite(most_rad);
    const double from_rad = has_limits ? least_rad : -std::numbers::pi;
    const double to_rad = has_limits ? most_rad : std::numbers::pi;
    q_rad[joint] = from_rad + nextShare(state) * (to_rad - from_rad);
  }
  return q_rad;
}

/// Ticks at one pose after another, as the servo does, each from a fresh state.
class Prober {
 public:
  explicit Prober(const tick::TickProgram& program) : program_(program), state_(makeState(program)) {}

  const tick::TickReport& first(const arm::JointAngles& q_rad) {
    input_ = {};
    input_.engage = input_.restart = true;
    input_.sample.q_rad = q_rad;
    step(program_, input_, state_, report_);
    return report_;
  }
  void again() {
    input_.restart = false;
    input_.sample.time_ns += kPeriod_ns;
    step(program_, input_, state_, report_);
  }

 private:
  const tick::TickProgram& program_;
  tick::TickState state_;
  tick::TickInput input_;
  tick::TickReport report_;
};

void note(double value, const Vec3& p_WT, Greatest& greatest) {
  if (value > greatest.value) greatest = {value, p_WT};
}

/// How the asked force changes where one joint value changes by change(joint, value).
template <class Change>
void noteChanges(Prober& prober, const arm::JointAngles& q_rad, std::size_t joints, const tick::TickReport& at,
                 const Change& change, Greatest& greatest) {
  const Vec3 f_T_W = at.f_T_W, p_WT = at.p_WT;
  for (std::size_t joint = 0; joint < joints; ++joint) {
    arm::JointAngles beside_rad = q_rad;
    beside_rad[joint] = change(joint, q_rad[joint]);
    if (beside_rad[joint] != q_rad[joint]) note((prober.first(beside_rad).f_T_W - f_T_W).norm(), p_WT, greatest);
  }
}

}  // namespace

SceneExtremes extremesOf(const tick::TickProgram& program, const arm::Preset& arm, std::uint64_t seed, int poses) {
  const FlushDenormals as_the_servo;
  SceneExtremes all;
  Stopwatch watch(static_cast<std::size_t>(poses));
  const std::size_t joints = arm::jointsOf(arm.geometry);
  Prober prober(program);
  for (std::uint64_t state = seed; all.poses < poses; ++all.poses) {
    const arm::JointAngles q_rad = drawnPose(arm, state);
    const tick::TickReport at = prober.first(q_rad);
    watch.time([&] { prober.again(); });
    note(at.f_T_W.norm(), at.p_WT, all.force_N);
    all.beyond_limit += at.f_T_W.norm() > program.limits.max_force_N ? 1 : 0;
    all.without_answer += std::any_of(at.held.begin(), at.held.end(), [](const tick::ConstraintReport& held) {
      return held.status == target::Status::Degenerate;
    });
    noteChanges(
        prober, q_rad, joints, at, [](std::size_t, double value) { return std::nextafter(value, kInfinity); },
        all.per_ulp_N);
    noteChanges(
        prober, q_rad, joints, at,
        [&arm](std::size_t joint, double value) {
          const double counts = arm.counts_per_turn[joint];
          return counts > 0.0 ? value + 2.0 * std::numbers::pi / counts : value;
        },
        all.per_encoder_step_N);
  }
  all.tick = watch.cost();
  return all;
}

}  // namespace underact::lab
