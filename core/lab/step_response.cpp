#include "core/lab/step_response.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "core/arm/preset.h"
#include "core/base/decompositions.h"
#include "core/base/fault.h"
#include "core/base/translate.h"
#include "core/base/units.h"
#include "core/lab/loop.h"
#include "core/scene/compile.h"
#include "core/scene/scene_arm.h"
#include "core/sim/plant.h"
#include "core/tick/step.h"

namespace underact::lab {
namespace {

constexpr double kBefore_s = 0.5;  // the ramp takes 0.3 s
constexpr double kShortest_s = 0.5, kLongest_s = 10.0;
constexpr int kMaxTicks = 20'000;  // so that it takes less than a second
constexpr double kMissed = 1e-3;   // relative to the step, by which a target may miss it
constexpr double kNudge_m = 1e-4;  // for the derivative of a force

/// A scene before and after its step.
struct Programs {
  tick::TickProgram before, after;
};

Result<tick::TickProgram> programOf(const scene::Description& scene, const StepSetup& setup) {
  Result<tick::TickProgram> program = scene::compile(scene);
  if (program && !setup.limits) program.value().limits = withoutLimits(program.value().limits);
  return program;
}

/// The slope of the law's force along a direction, with these gains instead of its stiffness.
double along(tick::TickProgram program, const sim::Plant& plant, const Vec3& gains, const Vec3& p_WP,
             const Vec3& along_W) {
  program.entries[0].law = control::P{gains};
  program = tick::makeProgram(program.geometry, program.entries, program.combine, program.limits, program.joint_limits);
  const Vec3 nudge_W = kNudge_m * along_W;
  const Vec3 above_N = firstTick(program, plant, p_WP + nudge_W).f_T_W;
  const Vec3 below_N = firstTick(program, plant, p_WP - nudge_W).f_T_W;
  return std::max(0.0, (below_N - above_N).dot(along_W) / (2.0 * kNudge_m));
}

HeldMass modelOf(const tick::TickProgram& program, const sim::Plant& plant, const Vec3& p_WP, const Vec3& along_W) {
  const control::Law& law = program.entries[0].law;
  HeldMass held{plant.model.mass_kg + plant.hand.mass_kg, plant.model.damping_N_s_per_m + plant.hand.damping_N_s_per_m};
  held.kp_N_per_m = along(program, plant, control::stiffness(law), p_WP, along_W);
  if (const auto* pd = std::get_if<control::PD>(&law))
    held.kd_N_s_per_m = along(program, plant, pd->kd_N_s_per_m, p_WP, along_W);
  if (const auto* pid = std::get_if<control::PID>(&law)) {
    held.kd_N_s_per_m = along(program, plant, pid->kd_N_s_per_m, p_WP, along_W);
    held.ki_N_per_m_s = along(program, plant, pid->ki_N_per_m_s, p_WP, along_W);
  }
  return held;
}

/// A duration long enough to see it come to rest: three times the model's settling time, and the periods that friction
/// takes to stop it, with a loss of 4 friction / kp of the amplitude in each.
double secondsFor(const ArmStep& step) {
  const StepMetrics model = metricsOf(step.analytic);
  double seconds = model.settling_2pct_s ? 3.0 * *model.settling_2pct_s : kLongest_s;
  const NaturalMotion motion = naturalMotion(step.model, step.law);
  if (motion.omega_n_rad_per_s > 0.0 && step.friction_N > 0.0) {
    const double turns = step.model.kp_N_per_m * std::abs(step.step_m) / (4.0 * step.friction_N) + 4.0;
    const double stopped_s = 3.0 * turns * 2.0 * kPi / motion.omega_n_rad_per_s;
    seconds = step.law == scene::LawType::PID ? std::max(seconds, stopped_s) : std::min(seconds, stopped_s);
  }
  return std::clamp(seconds, kShortest_s, std::min(kLongest_s, static_cast<double>(kMaxTicks) / step.rate_hz));
}

void record(const Programs& programs, const sim::Plant& plant, double seconds, ArmStep& step) {
  const auto& [before, after] = programs;
  SimulatedLoop loop(plant, step.p_WBefore, step.rate_hz);
  tick::TickState rest = makeState(before), state = makeState(after);
  for (int tick = 0; tick < static_cast<int>(kBefore_s * step.rate_hz); ++tick) loop.tick(before, rest);
  carryOver(rest, state, tick::Carry::ArmAndMovedLaws);
  state.retuned = false;  // the step is intended here
  step.travel_m.period_s = loop.period_s();
  const auto ticks = static_cast<int>(std::lround(seconds * step.rate_hz));
  Vec3 p_WBegin = Vec3::Zero(), p_WEnd = Vec3::Zero();
  for (int tick = 0; tick <= ticks; ++tick) {
    const tick::TickReport& report = loop.tick(after, state);
    if (report.fault.kind != FaultKind::None) {
      step.fault = describe(report.fault);
      return;
    }
    p_WEnd = report.p_WT;
    if (tick == 0) p_WBegin = p_WEnd;
    step.travel_m.value.push_back((p_WEnd - p_WBegin).dot(step.along_W));
    step.limited_ticks += report.cut_N > 0.0 ? 1 : 0;
    step.peak_force_N = std::max(step.peak_force_N, report.force.f_T_W().norm());
  }
  step.steady_error_m = step.step_m - (p_WEnd - step.p_WBefore).dot(step.along_W);
}

/// The direction of W's axis; of Axis::Held the one in which the error grows most for a tip slightly off the target.
Vec3 directionOf(Axis axis, const tick::TickProgram& program, const sim::Plant& plant, const Vec3& p_WP) {
  if (axis != Axis::Held) return Vec3::Unit(static_cast<Eigen::Index>(axis));
  Mat3 growth = Mat3::Zero();
  for (Eigen::Index column = 0; column < 3; ++column) {
    const Vec3 nudge_W = kNudge_m * Vec3::Unit(column);
    const tick::TickReport above = firstTick(program, plant, p_WP + nudge_W);
    const tick::TickReport below = firstTick(program, plant, p_WP - nudge_W);
    growth.col(column) = (above.p_WT - above.held[0].p_WP - below.p_WT + below.held[0].p_WP) / (2.0 * kNudge_m);
  }
  const Mat3 symmetric = 0.5 * (growth + growth.transpose());
  Vec3 max_W = principalAxes(symmetric).axes.col(2);
  Eigen::Index largest = 0;
  max_W.cwiseAbs().maxCoeff(&largest);
  return max_W[largest] < 0.0 ? Vec3(-max_W) : max_W;
}

/// The scene after a step along axis, if its target moves as a whole; none: it does not.
Result<std::optional<Programs>> steppedAlong(const scene::Description& held, const tick::TickProgram& before,
                                             const sim::Plant& plant, const StepSetup& setup, ArmStep& step) {
  step.along_W = directionOf(step.axis, before, plant, step.p_WBefore);
  const Vec3 step_W = setup.step_m * step.along_W;
  Result<tick::TickProgram> after = programOf(withTargetsMoved(held, kMillimetrePerMetre * step_W), setup);
  if (!after) return after.problems();
  const tick::TickReport first = firstTick(after.value(), plant, step.p_WBefore);
  const Vec3 miss_W = first.held[0].p_WP - step.p_WBefore - step_W;
  if (first.held[0].status != target::Status::Unique || !(miss_W.norm() <= kMissed * std::abs(setup.step_m)))
    return std::optional<Programs>();
  const Vec3 p_WAfter = step.p_WBefore + step_W;
  if (!isWithinReach(plant, p_WAfter))
    return Problems{{phrase(TRANSLATE_NOOP("problem",
                                           "The arm does not reach the target after this step (%1). Make the step "
                                           "smaller, or step in the other direction."),
                            {name(step.axis)})}};
  return std::optional<Programs>({before, std::move(after).value()});
}

/// The scene after a step along the first axis that holds. step: gets the axis and its direction.
Result<Programs> stepped(const scene::Description& held, const tick::TickProgram& before, const sim::Plant& plant,
                         const StepSetup& setup, ArmStep& step) {
  for (const Axis axis : {Axis::X, Axis::Y, Axis::Z, Axis::Held}) {
    if (setup.axis.value_or(axis) != axis) continue;
    step.axis = axis;
    Result<std::optional<Programs>> found = steppedAlong(held, before, plant, setup, step);
    if (!found) return found.problems();
    if (found.value()) return std::move(*std::move(found).value());
  }
  const std::string where = setup.axis ? std::string(" (") + name(*setup.axis) + ")" : "";
  return Problems{
      {phrase(TRANSLATE_NOOP("problem",
                             "The constraint does not hold the tip along a straight step there%1: its target does not "
                             "follow the whole step. Choose another axis, or start from another position."),
              {where})}};
}

struct MoveBy {
  Vec3 by_mm;
  template <scene::PlainShape Shape>
  void operator()(Shape& shape) const {
    eachField(shape, [this]<class Number>(const auto& field, Number& number) {
      if constexpr (std::is_same_v<Number, Vec3>)
        if (field.meaning == scene::Meaning::Position) number += this->by_mm;
    });
  }
  void operator()(scene::VirtualManipulator& robot) const {
    for (scene::Joint& joint : robot.joints) joint.point_mm += by_mm;
    robot.X_WV_home.topRightCorner<3, 1>() += by_mm;
  }
  void operator()(scene::Curve& curve) const { curve.X_WM.topRightCorner<3, 1>() += by_mm; }
  void operator()(scene::Mesh& mesh) const { mesh.X_WM.topRightCorner<3, 1>() += by_mm; }
};

}  // namespace

const char* name(Axis axis) {
  static constexpr const char* kNames[] = {"x", "y", "z", "held"};
  return kNames[static_cast<std::size_t>(axis)];
}

Result<ArmStep> measureStep(const scene::Description& scene, const StepSetup& setup) {
  const Result<scene::Description> held = onlyOne(scene, setup.constraint);
  if (!held) return held.problems();
  const Result<tick::TickProgram> before = programOf(held.value(), setup);
  if (!before) return before.problems();
  const sim::Plant plant =
      sim::makePlant(scene::armOf(held.value()), setup.arm, setup.hand, integrationOf(held.value().simulation));
  const Result<Vec3> begin = restingPlace(before.value(), plant, setup.from_W);
  if (!begin) return begin.problems();

  ArmStep step;
  step.constraint = held.value().constraints[0].name;
  step.law = controlOf(held.value(), 0).law;
  step.step_m = setup.step_m;
  step.rate_hz = setup.rate_hz;
  step.p_WBefore = begin.value();
  step.friction_N = setup.arm.friction_N;
  const Result<Programs> programs = stepped(held.value(), before.value(), plant, setup, step);
  if (!programs) return programs.problems();
  step.model = modelOf(before.value(), plant, step.p_WBefore, step.along_W);
  const Result<TransferFunction> analytic = transferOf(step.model, step.law);
  if (!analytic) return analytic.problems();
  step.analytic = analytic.value();
  record(programs.value(), plant, setup.seconds > 0.0 ? setup.seconds : secondsFor(step), step);
  step.measured = metricsOf(step.travel_m);
  step.fit = fitSecondOrder(step.travel_m);
  return step;
}

scene::Description withTargetsMoved(scene::Description scene, const Vec3& by_mm) {
  for (scene::Constraint& constraint : scene.constraints) std::visit(MoveBy{by_mm}, constraint.shape);
  return scene;
}

}  // namespace underact::lab
