#include "core/scene/mirror.h"

#include <utility>

#include "core/base/units.h"
#include "core/scene/scene_arm.h"

namespace underact::scene {
namespace {

using Signs = Vec3;  // 1 or -1 each: the diagonal of a reflection

// That of the arm: in its reflection y of the tip's frame is reversed, so that the frame stays right-handed.
const Signs kTip{1.0, -1.0, 1.0};

double flipped(double number) {
  return number == 0.0 ? number : -number;  // a file should not say -0
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

/// Reflects what a scene file says, in its units.
class SceneMirror {
 public:
  explicit SceneMirror(const arm::MirrorPlane& plane)
      : axis_(plane.axis), twice_at_mm_(2.0 * kMillimetrePerMetre * plane.at_m) {
    signs_[axis_] = -1.0;
  }

  template <PlainShape OneShape>
  void reflect(OneShape& shape) const {
    eachField(shape, [this](const auto& field, auto& number) { this->reflect(field.meaning, number); });
  }
  void reflect(VirtualManipulator& robot) const {
    for (Joint& joint : robot.joints) {
      if (joint.type == chain::JointType::Revolute)
        turningAxis(joint.axis);
      else
        direction(joint.axis);
      position(joint.point_mm);
    }
    scene::reflect(robot.X_WV_home, signs_, kTip);  // compared with the arm's tip
    coordinate(robot.X_WV_home(axis_, 3));
  }
  void reflect(Mesh& mesh) const { placement(mesh); }
  void reflect(Curve& curve) const { placement(curve); }  // its points keep their order: the guide starts as before

 private:
  void reflect(Meaning meaning, Vec3& number) const {
    if (meaning == Meaning::Position) position(number);
    if (meaning == Meaning::Direction) direction(number);  // as a line: nothing rotates about it
  }
  void reflect(Meaning, Mat3& R) const { scene::reflect(R, signs_, signs_); }
  void reflect(Meaning, double&) const {}  // a length
  void coordinate(double& at_mm) const { at_mm = twice_at_mm_ == 0.0 ? flipped(at_mm) : twice_at_mm_ - at_mm; }
  void position(Vec3& p_mm) const { coordinate(p_mm[axis_]); }
  void direction(Vec3& v) const { v[axis_] = flipped(v[axis_]); }
  /// An axis of rotation: a right-handed screw becomes left-handed, so that an axis at right angles to the mirror
  /// stays, and one parallel to it is reversed. Angles keep their sign, and so do limits, rest positions and springs.
  void turningAxis(Vec3& axis) const {
    for (Eigen::Index other = 0; other < 3; ++other) {
      if (other != axis_) axis[other] = flipped(axis[other]);
    }
  }
  /// S (p_WM + s R p_M) = S p_WM + (-s) (-S R) p_M: a negative scale is the part that a rotation cannot do.
  template <class FromFile>
  void placement(FromFile& placed) const {
    placed.scale_mm_per_unit = -placed.scale_mm_per_unit;
    scene::reflect(placed.X_WM, -signs_, Signs::Ones());
    coordinate(placed.X_WM(axis_, 3));
  }

  Eigen::Index axis_;
  double twice_at_mm_;
  Signs signs_ = Signs::Ones();  // S of the header
};

}  // namespace

arm::MirrorPlane mirrorPlaneOf(const Description& scene) {
  return arm::mirrorPlane(modelOf(scene));
}

Constraint mirrored(Constraint constraint, const arm::MirrorPlane& plane) {
  std::visit([mirror = SceneMirror(plane)](auto& shape) { mirror.reflect(shape); }, constraint.shape);
  return constraint;
}

Description mirrored(Description scene, const arm::MirrorPlane& plane) {
  for (Constraint& constraint : scene.constraints) constraint = mirrored(std::move(constraint), plane);
  return scene;
}

Description mirrored(Description scene) {
  const arm::MirrorPlane plane = mirrorPlaneOf(scene);
  return mirrored(std::move(scene), plane);
}

}  // namespace underact::scene
