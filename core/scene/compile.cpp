#include "core/scene/compile.h"

#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>

#include "core/base/units.h"
#include "core/scene/read.h"

namespace underact::scene {
namespace {

Vec3 metres(const Vec3& v_mm) {
  return kMetrePerMillimetre * v_mm;
}
double metres(double length_mm) {
  return kMetrePerMillimetre * length_mm;
}

Result<shape::Point> make(const Point& point, const Place& place) {
  return shape::makePoint(metres(point.position_mm), place);
}
Result<shape::Sphere> make(const Sphere& sphere, const Place& place) {
  return shape::makeSphere(metres(sphere.center_mm), metres(sphere.radius_mm), place);
}
Result<shape::Line> make(const Line& line, const Place& place) {
  return shape::makeLine(metres(line.point_mm), line.direction, place);
}
Result<shape::Plane> make(const Plane& plane, const Place& place) {
  return shape::makePlane(metres(plane.point_mm), plane.normal, place);
}
Result<shape::Circle> make(const Circle& circle, const Place& place) {
  return shape::makeCircle(metres(circle.center_mm), circle.normal, metres(circle.radius_mm), place);
}
Result<shape::Cylinder> make(const Cylinder& cylinder, const Place& place) {
  return shape::makeCylinder(metres(cylinder.point_mm), cylinder.axis, metres(cylinder.radius_mm), place);
}
Result<shape::Box> make(const Box& box, const Place& place) {
  return shape::makeBox(metres(box.center_mm), metres(box.size_mm), box.R_WB, place);
}

Result<shape::Shape> shapeOf(const Constraint& constraint) {
  return std::visit(
      [&](const auto& chosen) -> Result<shape::Shape> {
        const auto made = make(chosen, constraint.place);
        if (!made) return made.problems();
        return shape::Shape(made.value());
      },
      constraint.shape);
}

control::Law lawOf(const Control& control, double integral_limit_N) {
  const Vec3 kp_N_per_m = kNewtonPerMetre * control.gains.kp_N_per_mm;
  const Vec3 kd_N_s_per_m = kNewtonPerMetre * control.gains.kd_N_s_per_mm;
  const Vec3 ki_N_per_m_s = kNewtonPerMetre * control.gains.ki_N_per_mm_s;
  switch (control.law) {
    case LawType::P:
      return control::P{kp_N_per_m};
    case LawType::PD:
      return control::PD{kp_N_per_m, kd_N_s_per_m};
    case LawType::PID:
      return control::PID{kp_N_per_m, kd_N_s_per_m, ki_N_per_m_s, integral_limit_N};
  }
  return control::P{};
}

/// The gains whose metric says what is nearest; equal ones mean the Euclidean metric.
Vec3 metricOf(const Control& control) {
  return control.anisotropy == Anisotropy::Weighted ? control.gains.kp_N_per_mm : Vec3::Ones();
}

}  // namespace

Result<tick::TickProgram> compile(const Description& scene) {
  Problems problems = check(scene);
  if (!problems.empty()) return problems;
  const arm::Preset& preset = *arm::findPreset(scene.arm);
  std::vector<tick::Entry> entries;
  for (std::size_t index = 0; index < scene.constraints.size(); ++index) {
    const Constraint& constraint = scene.constraints[index];
    const Control& control = controlOf(scene, index);
    const Result<shape::Shape> made = shapeOf(constraint);
    if (!made) {
      problems.insert(problems.end(), made.problems().begin(), made.problems().end());
      continue;
    }
    entries.push_back({target::makeConstraint(made.value(), constraint.side, metricOf(control)),
                       lawOf(control, preset.continuous_force_N)});
  }
  if (!problems.empty()) return problems;
  safety::Limits limits;
  limits.max_force_N = preset.continuous_force_N;
  return tick::makeProgram(preset.geometry, std::move(entries), scene.combine, limits);
}

}  // namespace underact::scene
