#include "core/scene/compile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>

#include "core/arm/inverse.h"
#include "core/arm/jacobian.h"
#include "core/arm/mechanism.h"
#include "core/base/units.h"
#include "core/scene/manipulators.h"
#include "core/scene/meshes.h"
#include "core/scene/read.h"
#include "core/scene/scene_arm.h"

namespace underact::scene {
namespace {

Vec3 metres(const Vec3& v_mm) {
  return kMetrePerMillimetre * v_mm;
}
double metres(double length_mm) {
  return kMetrePerMillimetre * length_mm;
}

/// The number in SI.
template <class Shape, class Number>
Number inSi(const Field<Shape, Number>& field, const Shape& shape) {
  if constexpr (!std::is_same_v<Number, Mat3>)
    if (field.meaning == Meaning::Position || field.meaning == Meaning::Length) return metres(shape.*field.member);
  return shape.*field.member;
}

/// The shape of the tick.
template <class Shape>
auto make(const Shape& shape, const SourceLocation& place) {
  return std::apply([&](const auto&... field) { return kRow<Shape>.make(inSi(field, shape)..., place); },
                    kRow<Shape>.fields);
}

/// For each joint the displacement of the tip per rad, m, with the tip in the middle of the workspace; of an arm that
/// does not solvesInTick(), of the watched joints at its rest, and at least a tenth of the longest: a joint whose axis
/// passes by the tip there has a motor all the same.
Vec3 leversOf(const arm::Geometry& geometry) {
  const arm::JointAngles q_rad = arm::solvePosition(geometry, Vec3::Zero()).q_rad;
  const Vec3 levers = arm::positionJacobian(geometry, q_rad).colwise().norm();
  return arm::solvesInTick(geometry) ? levers : Vec3(levers.cwiseMax(0.1 * levers.maxCoeff()));
}

/// The limits of the driven joints of an arm that is driven by more than the first three. What a motor bears without
/// end is what the continuous force takes of it at the arm's rest, and, where a moment is rendered, what that takes; at
/// least a tenth of the greatest.
void limitJoints(const arm::Geometry& geometry, double force_N, safety::Limits& limits) {
  const arm::Mechanism& arm = *geometry.mechanism;
  const chain::Jacobian J = chain::jacobian(arm.chain, arm.rest);
  const arm::Watched watched = arm::watchedJoints(geometry);
  std::array<double, safety::kMaxDriven> bears{};
  for (std::size_t i = 0; i < watched.count; ++i) {
    const auto column = J.col(static_cast<Eigen::Index>(watched.joint[i]));
    bears[i] = force_N * column.head<3>().norm();
    if (arm.renders_moment) bears[i] = std::max(bears[i], arm.max_moment_N_m * column.tail<3>().norm());
    const double max = arm.max_torque[watched.joint[i]];
    if (max > 0.0) limits.max_torque_N_m[i] = max;
  }
  const double min = 0.1 * *std::max_element(bears.begin(), bears.end());
  for (std::size_t i = 0; i < watched.count; ++i) {
    limits.thermal.continuous_N_m[i] = std::min(std::max(bears[i], min), limits.max_torque_N_m[i]);
  }
  if (arm.renders_moment) limits.max_moment_N_m = arm.max_moment_N_m;
}

/// The filter of a joint: noise and acceleration are those of the tip at the end of its lever arm.
control::Velocity velocityOf(const Velocity& velocity, const Vec3& lever_m) {
  if (const auto* low_pass = std::get_if<LowPassFilter>(&velocity))
    return control::LowPass{kSecondPerMillisecond * low_pass->time_constant_ms};
  if (const auto* adaptive = std::get_if<AdaptiveWindowFilter>(&velocity)) {
    const Vec3 noise = Vec3::Constant(metres(adaptive->noise_mm)).cwiseQuotient(lever_m);
    return control::AdaptiveWindow{static_cast<int>(adaptive->window), noise};
  }
  if (const auto* kalman = std::get_if<KalmanFilter>(&velocity))
    return control::Kalman{metres(kalman->noise_mm), metres(kalman->acceleration_mm_per_s2)};
  return control::RawDifference{};
}

/// The law in SI. lever_m: 1 for Cartesian space. A joint's gain is that of the file times its lever arm in the middle
/// of the workspace, squared: kp of 0.5 N/mm with 0.176 m is 15.5 N m/rad.
control::Law lawOf(const Control& control, double max_force_N, const Vec3& lever_m) {
  const Vec3 per_turn = kNewtonPerMetre * lever_m.cwiseAbs2();
  const Vec3 kp_N_per_m = per_turn.cwiseProduct(control.gains.kp_N_per_mm);
  const Vec3 kd_N_s_per_m = per_turn.cwiseProduct(control.gains.kd_N_s_per_mm);
  const Vec3 ki_N_per_m_s = per_turn.cwiseProduct(control.gains.ki_N_per_mm_s);
  const double integral_limit_N = max_force_N * lever_m.minCoeff();
  const control::Velocity velocity = velocityOf(control.velocity, lever_m);
  switch (control.law) {
    case LawType::P:
      return control::P{kp_N_per_m};
    case LawType::PD:
      return control::PD{kp_N_per_m, kd_N_s_per_m, velocity};
    case LawType::PID:
      return control::PID{kp_N_per_m, kd_N_s_per_m, ki_N_per_m_s, integral_limit_N, velocity};
  }
  return control::P{};
}

/// The gains whose metric defines the nearest point; equal ones, and those of joints, mean the Euclidean metric.
Vec3 metricOf(const Control& control) {
  const bool weighted = control.anisotropy == Anisotropy::Weighted && control.space == tick::Space::Cartesian;
  return weighted ? control.gains.kp_N_per_mm : Vec3::Ones();
}

target::Influence influenceOf(const Influence& influence) {
  const double sign = influence.stylus_axis == StylusAxis::PlusZ ? 1.0 : -1.0;
  return {influence.t, sign, kRadPerDegree * influence.blend_deg};
}

/// The constraint of the tick, without friction.
Result<target::Constraint> heldTo(const Constraint& constraint, const Control& control) {
  const target::Side side = constraint.side;
  const auto held = [](auto made, target::Side on) -> Result<target::Constraint> {
    if (!made) return made.problems();
    return target::Constraint{std::move(made).value(), on};
  };
  return std::visit(
      [&](const auto& chosen) -> Result<target::Constraint> {
        using Chosen = std::decay_t<decltype(chosen)>;
        if constexpr (std::is_same_v<Chosen, Mesh>) {
          return held(makeMeshPlace(chosen, side, constraint.place), side);
        } else if constexpr (std::is_same_v<Chosen, Curve>) {
          return held(makeCurvePath(chosen, constraint.place), target::Side::Both);
        } else if constexpr (std::is_same_v<Chosen, VirtualManipulator>) {
          return held(makeManipulator(chosen, control, constraint.place), target::Side::Both);
        } else {
          const auto made = make(chosen, constraint.place);
          if (!made) return made.problems();
          if (constraint.influence)
            return target::Constraint{target::InfluencedShape{made.value(), influenceOf(*constraint.influence)}, side};
          return target::makeConstraint(made.value(), side, metricOf(control));
        }
      },
      constraint.shape);
}

}  // namespace

Result<tick::TickProgram> compile(const Description& scene) {
  Problems problems = check(scene);
  if (!problems.empty()) return problems;
  const arm::Preset& preset = armOf(scene);
  std::vector<tick::Entry> entries;
  for (std::size_t index = 0; index < scene.constraints.size(); ++index) {
    const Constraint& constraint = scene.constraints[index];
    const Control& control = controlOf(scene, index);
    Result<target::Constraint> made = heldTo(constraint, control);
    if (!made) {
      problems.insert(problems.end(), made.problems().begin(), made.problems().end());
      continue;
    }
    const Vec3 lever_m = control.space == tick::Space::Joint ? leversOf(preset.geometry) : Vec3::Ones();
    target::Constraint held = std::move(made).value();
    if (constraint.friction) {
      held.friction = {constraint.friction->static_share, constraint.friction->dynamic_share};
    }
    entries.push_back(
        {std::move(held), lawOf(control, preset.continuous_force_N, lever_m), control.space, control.passivity});
  }
  if (!problems.empty()) return problems;
  safety::Limits limits =
      safety::limitsForHands(preset.continuous_force_N, preset.continuous_force_N * leversOf(preset.geometry));
  if (!arm::solvesInTick(preset.geometry)) limitJoints(preset.geometry, preset.continuous_force_N, limits);
  return tick::makeProgram(preset.geometry, std::move(entries), scene.combine, limits, preset.limits);
}

}  // namespace underact::scene
