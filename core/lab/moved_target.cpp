#include "core/lab/moved_target.h"

#include <variant>

namespace underact::lab {
namespace {

struct MoveBy {
  Vec3 by_mm;
  void operator()(scene::Point& point) const { point.position_mm += by_mm; }
  void operator()(scene::Sphere& sphere) const { sphere.center_mm += by_mm; }
  void operator()(scene::Line& line) const { line.point_mm += by_mm; }
  void operator()(scene::Plane& plane) const { plane.point_mm += by_mm; }
  void operator()(scene::Circle& circle) const { circle.center_mm += by_mm; }
  void operator()(scene::Cylinder& cylinder) const { cylinder.point_mm += by_mm; }
  void operator()(scene::Box& box) const { box.center_mm += by_mm; }
  void operator()(scene::VirtualManipulator& robot) const {
    for (scene::Joint& joint : robot.joints) joint.point_mm += by_mm;
    robot.X_WV_home.topRightCorner<3, 1>() += by_mm;
  }
  void operator()(scene::Curve& curve) const { curve.X_WM.topRightCorner<3, 1>() += by_mm; }
  void operator()(scene::Mesh& mesh) const { mesh.X_WM.topRightCorner<3, 1>() += by_mm; }
};

}  // namespace

scene::Description withTargetsMoved(scene::Description scene, const Vec3& by_mm) {
  for (scene::Constraint& constraint : scene.constraints) std::visit(MoveBy{by_mm}, constraint.shape);
  return scene;
}

}  // namespace underact::lab
