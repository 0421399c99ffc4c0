#include "core/scene/mirror.h"

#include <utility>

namespace underact::scene {
namespace {

using Signs = Vec3;  // 1 or -1 each: the diagonal of a reflection

const Signs kMirror{-1.0, 1.0, 1.0};  // S of the header
// That of the arm: in its reflection y of frame 6 is reversed, so that the frame stays right-handed.
const Signs kTip{1.0, -1.0, 1.0};

double flipped(double number) {
  return number == 0.0 ? number : -number;  // a file should not say -0
}

/// The reflection of a position, or of a direction with a sense.
Vec3 seen(const Vec3& v) {
  return {flipped(v.x()), v.y(), v.z()};
}

/// The reflection of an axis of rotation: a right-handed screw becomes left-handed, so that an axis at right angles to
/// the mirror stays, and one parallel to it is reversed. Angles keep their sign, and so do limits, rest positions and
/// springs.
Vec3 seenTurning(const Vec3& axis) {
  return {axis.x(), flipped(axis.y()), flipped(axis.z())};
}

/// left R right.
template <class Matrix>
void reflect(Matrix& R, const Signs& left, const Signs& right) {
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = 0; column < 3; ++column) {
      if (left[row] * right[column] < 0.0) R(row, column) = flipped(R(row, column));
    }
  }
}

void mirror(Point& point) {
  point.position_mm = seen(point.position_mm);
}
void mirror(Sphere& sphere) {
  sphere.center_mm = seen(sphere.center_mm);
}
void mirror(Line& line) {
  line.point_mm = seen(line.point_mm);
  line.direction = seen(line.direction);
}
void mirror(Plane& plane) {
  plane.point_mm = seen(plane.point_mm);
  plane.normal = seen(plane.normal);
}
void mirror(Circle& circle) {
  circle.center_mm = seen(circle.center_mm);
  circle.normal = seen(circle.normal);  // as a line: nothing rotates about it
}
void mirror(Cylinder& cylinder) {
  cylinder.point_mm = seen(cylinder.point_mm);
  cylinder.axis = seen(cylinder.axis);
}
void mirror(Box& box) {
  box.center_mm = seen(box.center_mm);
  reflect(box.R_WB, kMirror, kMirror);
}

void mirror(VirtualManipulator& robot) {
  for (Joint& joint : robot.joints) {
    joint.axis = joint.type == chain::JointType::Revolute ? seenTurning(joint.axis) : seen(joint.axis);
    joint.point_mm = seen(joint.point_mm);
  }
  reflect(robot.X_WV_home, kMirror, kTip);  // compared with the arm's tip
  robot.X_WV_home(0, 3) = flipped(robot.X_WV_home(0, 3));
}

/// S (p_WM + s R p_M) = S p_WM + (-s) (-S R) p_M: a negative scale is the part that a rotation cannot do.
template <class FromFile>
void mirrorPlacement(FromFile& placed) {
  placed.scale_mm_per_unit = -placed.scale_mm_per_unit;
  reflect(placed.X_WM, -kMirror, Signs::Ones());
  placed.X_WM(0, 3) = flipped(placed.X_WM(0, 3));
}
void mirror(Mesh& mesh) {
  mirrorPlacement(mesh);
}
void mirror(Curve& curve) {
  mirrorPlacement(curve);  // its points keep their order, so the guide starts from the same end
}

}  // namespace

Constraint mirrored(Constraint constraint) {
  std::visit([](auto& shape) { mirror(shape); }, constraint.shape);
  return constraint;
}

Description mirrored(Description scene) {
  for (Constraint& constraint : scene.constraints) constraint = mirrored(std::move(constraint));
  return scene;
}

}  // namespace underact::scene
