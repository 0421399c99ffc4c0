#include "app/gui/view/constraint_picture.h"

#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>

#include "core/arm/forward.h"
#include "core/base/units.h"
#include "core/curve/along.h"
#include "core/scene/compile.h"
#include "core/scene/scene_arm.h"

namespace underact::gui {
namespace {

// Unbounded shapes are drawn as far as this: the workspace is 160 x 120 x 70 mm.
const Vec3 kRegion_mm(110.0, 85.0, 62.0);
constexpr double kPointRadius_mm = 2.6;
constexpr double kGrid_mm = 20.0;
constexpr double kHair_mm = 4.0;  // of a wall, and the least distance between two of them

/// The part of a line inside the region, enlarged by margin_mm; false: none.
bool clip(const Vec3& p_mm, const Vec3& direction, double margin_mm, double& from, double& to) {
  from = -kInfinity;
  to = kInfinity;
  for (int axis = 0; axis < 3; ++axis) {
    const double half = kRegion_mm[axis] + margin_mm;
    if (std::abs(direction[axis]) < 1e-12) {
      if (std::abs(p_mm[axis]) > half) return false;
      continue;
    }
    const double one = (-half - p_mm[axis]) / direction[axis], other = (half - p_mm[axis]) / direction[axis];
    from = std::max(from, std::min(one, other));
    to = std::min(to, std::max(one, other));
  }
  return from < to;
}

/// Clips the line to the region; if it misses the region, the part nearest to it, so that it stays visible.
void clipOrNear(const Vec3& p_mm, const Vec3& direction, double margin_mm, double& from, double& to) {
  if (clip(p_mm, direction, margin_mm, from, to)) return;
  const double nearest = -p_mm.dot(direction);
  from = nearest - kRegion_mm.norm();
  to = nearest + kRegion_mm.norm();
}

/// The corners of the plane's part inside the region, in order around the normal.
std::vector<Vec3> cutOfPlane(const Vec3& p_mm, const Vec3& normal) {
  std::vector<Vec3> corners;
  for (int axis = 0; axis < 3; ++axis) {
    const int second = (axis + 1) % 3, third = (axis + 2) % 3;
    for (const double a : {-1.0, 1.0}) {
      for (const double b : {-1.0, 1.0}) {
        Vec3 edge_mm = Vec3::Zero();
        edge_mm[second] = a * kRegion_mm[second];
        edge_mm[third] = b * kRegion_mm[third];
        if (std::abs(normal[axis]) < 1e-12) continue;
        edge_mm[axis] = (p_mm - edge_mm).dot(normal) / normal[axis];
        if (std::abs(edge_mm[axis]) <= kRegion_mm[axis]) corners.push_back(edge_mm);
      }
    }
  }
  if (corners.size() < 3) return {};
  Vec3 middle_mm = Vec3::Zero();
  for (const Vec3& corner : corners) middle_mm += corner / static_cast<double>(corners.size());
  const Vec3 u = normal.unitOrthogonal(), v = normal.cross(u);
  const auto angleOf = [&](const Vec3& q_mm) {
    return std::atan2((q_mm - middle_mm).dot(v), (q_mm - middle_mm).dot(u));
  };
  std::sort(corners.begin(), corners.end(), [&](const Vec3& a, const Vec3& b) { return angleOf(a) < angleOf(b); });
  return corners;
}

/// Two directions in the plane: along the axes of W where possible, so that a grid reads as millimetres.
Vec3 gridDirection(const Vec3& normal) {
  int best = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (std::abs(normal[axis]) < std::abs(normal[best]) - 1e-9) best = axis;
  }
  const Vec3 along_W = Vec3::Unit(best);
  return (along_W - along_W.dot(normal) * normal).normalized();
}

}  // namespace

ConstraintPicture::ConstraintPicture()
    : bold_actor_(makeActor(bold_.data(), PieceKind::Line)),
      fine_actor_(makeActor(fine_.data(), PieceKind::Line)),
      outline_actor_(makeActor(outlines_.data(), PieceKind::Line)) {}

std::vector<vtkActor*> ConstraintPicture::lines() const {
  return {fine_actor_, bold_actor_, outline_actor_};
}

void ConstraintPicture::setLineWidth(double scale) {
  fine_actor_->GetProperty()->SetLineWidth(static_cast<float>(1.0 * scale));
  bold_actor_->GetProperty()->SetLineWidth(static_cast<float>(2.5 * scale));
  outline_actor_->GetProperty()->SetLineWidth(static_cast<float>(2.0 * scale));
}

void ConstraintPicture::setScene(const scene::Description& scene) {
  middle_mm_ = kMillimetrePerMetre * arm::workspaceMiddle(scene::armOf(scene).geometry);
  held_.clear();
  for (const scene::Constraint& constraint : scene.constraints) held_.push_back({constraint.shape, constraint.side});
  build();
}

void ConstraintPicture::setTheme(const Theme& theme) {
  theme_ = theme;
  build();
}

void ConstraintPicture::update(const Vec3& eye_mm) {
  if (eye_mm == eye_mm_) return;
  eye_mm_ = eye_mm;
  outlines_.clear();
  for (const Ball& ball : balls_) outlines_.outline(eye_mm, ball.center_mm, ball.axes_mm, theme_.constraint);
  for (const Tube& tube : tubes_)
    outlines_.sides(eye_mm, tube.a_mm, tube.b_mm, tube.radius_mm, tube.radius_mm, theme_.constraint);
  outlines_.done();
}

vtkActor& ConstraintPicture::addTint(vtkPolyData* data) {
  tints_.push_back(makeActor(data, PieceKind::Tint));
  setColour(*tints_.back(), theme_.constraint);
  return *tints_.back();
}

void ConstraintPicture::addHair(const Vec3& p_mm, const Vec3& outwards) {
  if (side_ == target::Side::Both) return;
  const double into_solid = side_ == target::Side::Outside ? -kHair_mm : kHair_mm;
  fine_.segment(p_mm, p_mm + into_solid * outwards, theme_.constraint);
}

void ConstraintPicture::addHairs(const Vec3& center_mm, const Vec3& u, const Vec3& v, const Mat3& axes_mm) {
  const double radius_mm = std::max((axes_mm * u).norm(), (axes_mm * v).norm());
  const int count = 4 * std::clamp(static_cast<int>(radius_mm / kHair_mm), 2, 18);
  for (int hair = 0; hair < count; ++hair) {
    const double angle_rad = 2.0 * kPi * hair / count;
    const Vec3 out = std::cos(angle_rad) * u + std::sin(angle_rad) * v;
    addHair(center_mm + axes_mm * out, (axes_mm.inverse().transpose() * out).normalized());
  }
}

void ConstraintPicture::addBall(const Vec3& center_mm, const Mat3& axes_mm) {
  vtkActor& ball = addTint(unitSphere(64, 32));
  ball.GetProperty()->BackfaceCullingOn();  // one layer, so that 25 % is 25 %
  Eigen::Matrix4d X = Eigen::Matrix4d::Identity();
  X.topLeftCorner<3, 3>() = axes_mm;
  X.topRightCorner<3, 1>() = center_mm;
  place(ball, X);
  balls_.push_back({center_mm, axes_mm});
  const QColor soft = faint(theme_.constraint, 0.55);
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 u = Vec3::Unit((axis + 1) % 3), v = Vec3::Unit((axis + 2) % 3);
    fine_.circle(center_mm, axes_mm * u, axes_mm * v, 1.0, soft);
    addHairs(center_mm, u, v, axes_mm);
    extent_mm_.push_back(center_mm + axes_mm.col(axis));
    extent_mm_.push_back(center_mm - axes_mm.col(axis));
  }
}

template <>
void ConstraintPicture::add(const scene::Point& point) {
  vtkActor& ball = addTint(unitSphere(24, 12));
  ball.GetProperty()->SetOpacity(1.0);  // too small to be translucent
  ball.GetProperty()->BackfaceCullingOn();
  place(ball, at(point.position_mm, kPointRadius_mm));
  balls_.push_back({point.position_mm, kPointRadius_mm * Mat3::Identity()});
  for (int axis = 0; axis < 3; ++axis) {  // a small cross shows where it is, from any direction
    fine_.segment(point.position_mm - 8.0 * Vec3::Unit(axis), point.position_mm + 8.0 * Vec3::Unit(axis),
                  theme_.constraint);
  }
  extent_mm_.push_back(point.position_mm);
}

template <>
void ConstraintPicture::add(const scene::Sphere& sphere) {
  addBall(sphere.center_mm, sphere.radius_mm * Mat3::Identity());
}

template <>
void ConstraintPicture::add(const scene::Ellipsoid& ellipsoid) {
  addBall(ellipsoid.center_mm, ellipsoid.R_WB * ellipsoid.semi_axes_mm.asDiagonal());
}

template <>
void ConstraintPicture::add(const scene::Line& line) {
  const Vec3 direction = line.direction.normalized();
  double from = 0.0, to = 0.0;
  clipOrNear(line.point_mm - middle_mm_, direction, 0.0, from, to);
  const Vec3 a_mm = line.point_mm + from * direction, b_mm = line.point_mm + to * direction;
  bold_.segment(a_mm, b_mm, theme_.constraint);
  extent_mm_.insert(extent_mm_.end(), {a_mm, b_mm});
}

template <>
void ConstraintPicture::add(const scene::Plane& plane) {
  const Vec3 normal = plane.normal.normalized();
  const Vec3 from_middle_mm = plane.point_mm - middle_mm_;
  std::vector<Vec3> corners = cutOfPlane(from_middle_mm, normal);
  for (Vec3& corner : corners) corner += middle_mm_;
  const Vec3 u = gridDirection(normal), v = normal.cross(u);
  if (corners.empty()) {  // it misses the region
    const double half = kRegion_mm.x();
    for (const auto& [a, b] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}) {
      corners.push_back(middle_mm_ + from_middle_mm.dot(normal) * normal + half * (a * u + b * v));
    }
  }
  addTint(polygon(corners, normal));
  bold_.chain(corners, theme_.constraint, true);
  for (std::size_t corner = 0; corner < corners.size(); ++corner) {
    const Vec3 &from_mm = corners[corner], &to_mm = corners[(corner + 1) % corners.size()];
    const double steps = std::max(1.0, std::floor((to_mm - from_mm).norm() / (2.0 * kHair_mm)));
    for (double step = 0.0; step < steps; step += 1.0) addHair(from_mm + step / steps * (to_mm - from_mm), normal);
  }
  const QColor soft = faint(theme_.constraint, 0.35);
  for (const auto& [heading, across] : {std::pair{u, v}, {v, u}}) {
    double min = kInfinity, max = -kInfinity;
    for (const Vec3& corner : corners) {
      min = std::min(min, across.dot(corner - plane.point_mm));
      max = std::max(max, across.dot(corner - plane.point_mm));
    }
    for (double step = std::ceil(min / kGrid_mm); step * kGrid_mm < max; step += 1.0) {
      const Vec3 start_mm = plane.point_mm + step * kGrid_mm * across;
      double from = 0.0, to = 0.0;
      if (clip(start_mm - middle_mm_, heading, 1e-9, from, to))
        fine_.segment(start_mm + from * heading, start_mm + to * heading, soft);
    }
  }
  extent_mm_.insert(extent_mm_.end(), corners.begin(), corners.end());
}

template <>
void ConstraintPicture::add(const scene::Circle& circle) {
  const Vec3 normal = circle.normal.normalized(), u = normal.unitOrthogonal(), v = normal.cross(u);
  bold_.circle(circle.center_mm, u, v, circle.radius_mm, theme_.constraint);
  const double mark_mm = std::min(3.0, 0.2 * circle.radius_mm);
  fine_.segment(circle.center_mm - mark_mm * u, circle.center_mm + mark_mm * u, theme_.constraint);
  fine_.segment(circle.center_mm - mark_mm * v, circle.center_mm + mark_mm * v, theme_.constraint);
  for (const Vec3& out : {u, v}) {
    extent_mm_.push_back(circle.center_mm + circle.radius_mm * out);
    extent_mm_.push_back(circle.center_mm - circle.radius_mm * out);
  }
}

template <>
void ConstraintPicture::add(const scene::Cylinder& cylinder) {
  const Vec3 axis = cylinder.axis.normalized(), u = axis.unitOrthogonal(), v = axis.cross(u);
  double from = 0.0, to = 0.0;
  clipOrNear(cylinder.point_mm - middle_mm_, axis, 0.0, from, to);
  const Vec3 a_mm = cylinder.point_mm + from * axis, b_mm = cylinder.point_mm + to * axis;
  vtkActor& tube = addTint(unitTube(64, false));
  tube.GetProperty()->BackfaceCullingOn();
  place(tube, along(a_mm, b_mm, cylinder.radius_mm));
  tubes_.push_back({a_mm, b_mm, cylinder.radius_mm});
  const Mat3 around_mm = cylinder.radius_mm * Mat3::Identity();
  bold_.circle(a_mm, u, v, cylinder.radius_mm, theme_.constraint);
  bold_.circle(b_mm, u, v, cylinder.radius_mm, theme_.constraint);
  addHairs(a_mm, u, v, around_mm);
  addHairs(b_mm, u, v, around_mm);
  const QColor soft = faint(theme_.constraint, 0.35);
  for (double step = std::ceil((from + 1.0) / kGrid_mm); step * kGrid_mm < to - 1.0; step += 1.0) {
    const Vec3 center_mm = cylinder.point_mm + step * kGrid_mm * axis;
    fine_.circle(center_mm, u, v, cylinder.radius_mm, soft);
    addHairs(center_mm, u, v, around_mm);
  }
  for (const Vec3& end_mm : {a_mm, b_mm}) {
    for (const Vec3& out : {u, v}) {
      extent_mm_.push_back(end_mm + cylinder.radius_mm * out);
      extent_mm_.push_back(end_mm - cylinder.radius_mm * out);
    }
  }
}

template <>
void ConstraintPicture::add(const scene::Box& box) {
  vtkActor& cube = addTint(unitCube());
  cube.GetProperty()->BackfaceCullingOn();
  Eigen::Matrix4d X = Eigen::Matrix4d::Identity();
  X.block<3, 3>(0, 0) = box.R_WB * box.size_mm.asDiagonal();
  X.block<3, 1>(0, 3) = box.center_mm;
  place(cube, X);
  addBoxEdges(bold_, 0.5 * box.size_mm, box.center_mm, box.R_WB, theme_.constraint);
  for (int axis = 0; axis < 3; ++axis) {  // along the four edges of that axis, between the two faces
    const int second = (axis + 1) % 3, third = (axis + 2) % 3;
    const double steps = std::clamp(std::floor(box.size_mm[axis] / (2.0 * kHair_mm)), 1.0, 40.0);
    for (const auto& [a, b] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}) {
      const Vec3 out = box.R_WB * (a * Vec3::Unit(second) + b * Vec3::Unit(third)).normalized();
      for (double step = 0.5; step < steps; step += 1.0) {
        Vec3 share = 0.5 * (a * Vec3::Unit(second) + b * Vec3::Unit(third));
        share[axis] = step / steps - 0.5;
        addHair(box.center_mm + box.R_WB * share.cwiseProduct(box.size_mm), out);
      }
    }
  }
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 share((corner & 1) != 0 ? 0.5 : -0.5, (corner & 2) != 0 ? 0.5 : -0.5, (corner & 4) != 0 ? 0.5 : -0.5);
    const Vec3 corner_mm = box.center_mm + box.R_WB * share.cwiseProduct(box.size_mm);
    extent_mm_.push_back(corner_mm);
  }
}

/// As fine as the eye can see: a million points are drawn with some thousands.
template <>
void ConstraintPicture::add(const scene::Curve& curve) {
  const Result<target::CurvePath> path = scene::makeCurvePath(curve);
  if (!path) return;
  constexpr double kStep_mm = 0.5, kMaxSteps = 4000.0;
  const curve::Curve& drawn = *path.value().curve;
  const double length_m = lengthOf(drawn);
  const double steps = std::clamp(std::ceil(kMillimetrePerMetre * length_m / kStep_mm), 1.0, kMaxSteps);
  Vec3 last_mm = kMillimetrePerMetre * pointAt(drawn, 0.0);
  extent_mm_.push_back(last_mm);
  for (double step = 1.0; step <= steps; step += 1.0) {
    const Vec3 p_mm = kMillimetrePerMetre * pointAt(drawn, length_m * step / steps);
    bold_.segment(last_mm, p_mm, theme_.constraint);
    last_mm = p_mm;
    extent_mm_.push_back(p_mm);
  }
}

/// The robot moves and is drawn elsewhere; this is the space it takes up.
template <>
void ConstraintPicture::add(const scene::VirtualManipulator& robot) {
  extent_mm_.push_back(robot.X_WV_home.topRightCorner<3, 1>());
  for (const scene::Joint& joint : robot.joints) {
    if (joint.type == chain::JointType::Revolute) extent_mm_.push_back(joint.point_mm);
  }
}

template <>
void ConstraintPicture::add(const scene::Mesh&) {}  // see MeshPicture

void ConstraintPicture::build() {
  bold_.clear();
  fine_.clear();
  tints_.clear();
  balls_.clear();
  tubes_.clear();
  extent_mm_.clear();
  for (const Held& held : held_) {
    side_ = held.side;
    std::visit([this](const auto& one) { add(one); }, held.shape);
  }
  bold_.done();
  fine_.done();
  eye_mm_ = Vec3::Constant(kNotANumber);
}

}  // namespace underact::gui
