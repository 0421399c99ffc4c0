#include "core/lab/extremes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/arm/mechanism.h"
#include "core/base/denormals.h"
#include "core/base/random.h"
#include "core/sim/plant.h"
#include "core/tick/step.h"

namespace underact::lab {
namespace {

constexpr std::int64_t kPeriod_ns = 1'000'000;
constexpr double kTurn_rad = 2.0 * std::numbers::pi;

arm::JointAngles drawnPose(const arm::Preset& arm, std::uint64_t& state) {
  arm::JointAngles q_rad{};
  for (std::size_t joint = 0; joint < arm::jointsOf(arm.geometry); ++joint) {
    const double min_rad = std::max(arm.limits.min_rad[joint], -kTurn_rad);
    const double max_rad = std::min(arm.limits.max_rad[joint], kTurn_rad);
    q_rad[joint] = min_rad + nextShare(state) * (max_rad - min_rad);
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

/// How the asked force changes where beside(joint) gives the joints instead.
template <class Beside>
void noteChanges(Prober& prober, const arm::Preset& arm, const tick::TickReport& at, const Beside& beside,
                 Greatest& greatest) {
  for (std::size_t joint = 0; joint < arm::jointsOf(arm.geometry); ++joint)
    note((prober.first(beside(joint)).f_T_W - at.f_T_W).norm(), at.p_WT, greatest);
}

}  // namespace

SceneExtremes extremesOf(const tick::TickProgram& program, const arm::Preset& arm, std::uint64_t seed, int poses) {
  const FlushDenormals as_the_servo;
  SceneExtremes all;
  Stopwatch watch(static_cast<std::size_t>(poses));
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
    const auto bit_beside = [&q_rad](std::size_t joint) {
      arm::JointAngles beside_rad = q_rad;
      beside_rad[joint] = std::nextafter(q_rad[joint], kInfinity);
      return beside_rad;
    };
    const auto step_beside = [&](std::size_t joint) { return sim::afterEncoderStep(arm, q_rad, joint); };
    noteChanges(prober, arm, at, bit_beside, all.per_ulp_N);
    noteChanges(prober, arm, at, step_beside, all.per_encoder_step_N);
  }
  all.tick = watch.cost();
  return all;
}

}  // namespace underact::lab
