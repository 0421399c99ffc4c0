#include <algorithm>
#include <cmath>

#include "app/gui/view/kinematics_picture.h"
#include "core/base/units.h"

// The inverse solutions of an arm that is not of the Omni's form: arms, each from joint to joint as its geometry has
// it.
namespace underact::gui {
namespace {

constexpr double kOthersOpacity = 0.2;  // so that the highlighted one stands out
constexpr double kSameJoints = 1e-6;    // rad, or m: the solution is the arm itself

bool isSameConfiguration(const chain::Chain& chain, const arm::JointAngles& a, const arm::JointAngles& b) {
  for (std::size_t joint = 0; joint < chain.joints.size(); ++joint) {
    const bool slides = chain.joints[joint].type == chain::JointType::Prismatic;
    const double apart = slides ? a[joint] - b[joint] : std::remainder(a[joint] - b[joint], 2.0 * kPi);
    if (std::abs(apart) > kSameJoints) return false;
  }
  return true;
}

}  // namespace

/// The point of the skeleton at which the solutions differ most, counted from the base: where each has a place of its
/// own; of several such points that where they lie farthest apart.
std::size_t KinematicsPicture::apartPoint() const {
  std::vector<std::vector<Vec3>> skeletons_mm;
  for (const NumberedSolution& one : solutions().all) skeletons_mm.push_back(others_.skeleton_mm(one.q));
  std::size_t best = 0, max = 0;
  double widest_mm = 0.0;
  for (std::size_t point = 0;; ++point) {
    std::vector<Vec3> places_mm;
    Eigen::AlignedBox3d around_mm;
    for (const std::vector<Vec3>& skeleton_mm : skeletons_mm) {
      if (point >= skeleton_mm.size()) return best;
      placeAmong(places_mm, skeleton_mm[point]);
      around_mm.extend(skeleton_mm[point]);
    }
    const double wide_mm = places_mm.size() > 1 ? around_mm.diagonal().norm() : 0.0;
    if (places_mm.size() < max || (places_mm.size() == max && wide_mm <= widest_mm)) continue;
    best = point;
    max = places_mm.size();
    widest_mm = wide_mm;
  }
}

void KinematicsPicture::addArms() {
  others_.setOpacity(kOthersOpacity);
  const QColor faint = mixed(theme_.background, theme_.virtual_robot, 0.75);
  std::vector<arm::JointAngles> surfaces;
  for (const NumberedSolution& one : solutions().all) {
    if (one.number == chosen_ && share_ >= 1.0) continue;
    const std::vector<Vec3> points_mm = others_.skeleton_mm(one.q);
    const bool is_arm = isSameConfiguration(model_.chain, one.q, q_rad_);
    if (one.within_limits && !is_arm) surfaces.push_back(one.q);
    for (std::size_t index = 0; index + 1 < points_mm.size(); ++index) {
      if (one.within_limits)
        thin_.segment(points_mm[index], points_mm[index + 1], theme_.virtual_robot);
      else
        addDashes(thin_, points_mm[index], points_mm[index + 1], others_.size() * kDash_mm, faint);
    }
  }
  others_.presentAll(surfaces);
  if (solutions().all.empty()) return;
  const std::size_t point = apartPoint();
  addNumbers(
      [this, point](const NumberedSolution& one) { return others_.skeleton_mm(one.q)[point]; },
      [this](const Vec3& place_mm) { return Vec3(place_mm + others_.size() * kNumber_mm * outwards(place_mm)); });
}

void KinematicsPicture::addChosenArm(const arm::JointAngles& q_rad, const OrbitCamera& camera) {
  const std::vector<Vec3> points_mm = ghost_.skeleton_mm(q_rad);
  const double hollow_mm = ghost_.size() * kHollow_mm;
  const QColor colour = theme_.virtual_robot;
  for (std::size_t index = 0; index < points_mm.size(); ++index) {
    mark_.circle(points_mm[index], camera.right_W(), camera.up_W(), hollow_mm, colour);
    if (index == 0) continue;
    const Vec3 travel_mm = points_mm[index] - points_mm[index - 1];
    if (travel_mm.norm() < 2.0 * hollow_mm) continue;
    const Vec3 rim_mm = hollow_mm * travel_mm.normalized();  // up to the rims of the hollow joints
    mark_.segment(points_mm[index - 1] + rim_mm, points_mm[index] - rim_mm, colour);
  }
}

std::vector<Vec3> KinematicsPicture::skeletonExtent_mm(const arm::JointAngles& q_rad) const {
  std::vector<Vec3> points_mm = others_.skeleton_mm(q_rad);
  for (Vec3& p_mm : points_mm) p_mm += others_.size() * kNumber_mm * outwards(p_mm);
  return points_mm;
}

}  // namespace underact::gui
