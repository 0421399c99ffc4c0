#include <algorithm>
#include <cmath>

#include "app/gui/view/arm_solids.h"
#include "core/base/units.h"

namespace underact::gui {
namespace {

// Of an arm of the Omni's size, m.
constexpr double kYoke_m = 0.0215, kInnerYoke_m = 0.0165, kYokeRod_m = 0.0021, kPivot_m = 0.0030;
constexpr double kGimbalHousing_m = 0.0075;
constexpr double kColumnEnd = 1.1;  // below the middle of the first housing, of its radius
constexpr double kUpright = 0.9;    // the cosine to the vertical of a first axis that a column can carry

Vec3 across(const Vec3& wish_W, const Vec3& axis_W) {
  const Vec3 part_W = wish_W - wish_W.dot(axis_W) * axis_W;
  return part_W.norm() > 1e-6 ? Vec3(part_W.normalized()) : Vec3(axis_W.unitOrthogonal());
}

/// A pen, its tip at 0, the hand's end up. Unit: m, of the Omni's size.
std::vector<Ring> penProfile(double size) {
  constexpr double kBall = 0.0022, kNeck = 0.0015;
  std::vector<Ring> profile;
  const double meet_rad = std::acos(kNeck / kBall);
  for (int step = 0; step <= 10; ++step) {
    const double angle_rad = -0.5 * kPi + step * (meet_rad + 0.5 * kPi) / 10;
    profile.push_back({step == 0 ? 0.0 : kBall * std::cos(angle_rad), kBall * std::sin(angle_rad)});
  }
  for (const auto& [radius, z] : {std::pair{0.0026, 0.010},
                                  {0.0040, 0.0175},
                                  {0.0046, 0.028},
                                  {0.0049, 0.040},
                                  {0.0048, 0.055},
                                  {0.0043, 0.072},
                                  {0.0037, 0.090}})
    profile.push_back({radius, z});
  for (int step = 1; step <= 6; ++step) {
    const double angle_rad = 0.5 * kPi * step / 6;
    profile.push_back({step == 6 ? 0.0 : 0.0037 * std::cos(angle_rad), 0.090 + 0.0037 * std::sin(angle_rad)});
  }
  for (Ring& ring : profile) ring = {size * ring.radius, size * ring.z};
  return profile;
}

void addPen(ArmSolids& arm, std::size_t link, const Vec3& tip_W, const Vec3& along_W) {
  const double size = arm.stand.size;
  const Pose X_WS = frameAlong(tip_W, along_W);
  arm.solids.push_back({link, Finish::Pen, TurnedForm{X_WS, penProfile(size)}});
  arm.solids.push_back(
      {link, Finish::Metal, TurnedForm{X_WS, roundedRod(0.0225 * size, 0.0255 * size, 0.0047 * size, 0.0008 * size)}});
  arm.p_WEnd = tip_W + 0.084 * size * along_W;
}

}  // namespace

void addGimbal(ArmSolids& arm, const arm::Model& model) {
  const double size = arm.stand.size;
  const std::size_t count = arm.axes.size();
  const DrawnAxis& roll = arm.axes[count - 3];
  const Vec3 tip_W = arm.p_WTip, pivot_W = arm.axes[count - 2].axis_W;
  const Vec3 pen_W = model.chain.X_WT_home.linear().col(2);
  Vec3 back_W = roll.in_W - tip_W;  // along the forearm
  back_W = back_W.norm() > 1e-6 ? Vec3(back_W.normalized()) : Vec3(-pen_W);
  const std::size_t before = count - 3, outer = count - 2, inner = count - 1;  // links
  // The forearm ends before the gimbal; its housing is where joint 4 turns.
  const double forearm_m = (roll.in_W - tip_W).norm(), collar_m = 1.75 * kYoke_m * size;
  const double elbow_m = arm.axes[count - 4].radius_m;
  const double housing_m = kGimbalHousing_m * size;
  const Pose X_WS = frameAlong(tip_W, back_W);
  if (forearm_m > 1.2 * collar_m) {
    arm.solids.push_back(
        {before, Finish::Metal, TurnedForm{X_WS, taperedRod(collar_m, forearm_m, 0.86 * housing_m, 0.72 * elbow_m)}});
  }
  arm.solids.push_back(
      {before, Finish::Shell,
       TurnedForm{X_WS, roundedRod(1.42 * kYoke_m * size, collar_m + 1.3 * housing_m, housing_m, 0.35 * housing_m)}});
  arm.solids.push_back(
      {outer, Finish::Trim,
       TurnedForm{X_WS, roundedRod(0.98 * kYoke_m * size, 1.40 * kYoke_m * size, 0.8 * housing_m, 0.25 * housing_m)}});
  arm.solids.push_back({outer, Finish::Metal,
                        BentForm{tip_W, pivot_W, across(back_W, pivot_W), kYoke_m * size, kPi, kYokeRod_m * size}});
  arm.solids.push_back({inner, Finish::Metal,
                        BentForm{tip_W, pivot_W, across(pen_W, pivot_W), kInnerYoke_m * size, kPi, kYokeRod_m * size}});
  for (const double side : {-1.0, 1.0}) {
    arm.solids.push_back({inner, Finish::Trim,
                          TurnedForm{frameAlong(tip_W, side * pivot_W),
                                     roundedRod((kInnerYoke_m - 0.003) * size, (kYoke_m + 0.003) * size,
                                                kPivot_m * size, 0.001 * size)}});
  }
  arm.solids.push_back(
      {inner, Finish::Trim,
       TurnedForm{frameAlong(tip_W, pen_W), roundedRod((kInnerYoke_m - 0.0035) * size, (kInnerYoke_m + 0.0035) * size,
                                                       0.0066 * size, 0.0015 * size)}});
  addPen(arm, count, tip_W, pen_W);
}

void addStylus(ArmSolids& arm, const arm::Model& model) {
  const std::size_t count = arm.axes.size();
  const DrawnAxis& last = arm.axes.back();
  const Vec3 tip_W = arm.p_WTip;
  const double size = arm.stand.size, radius_m = last.radius_m, length_m = (tip_W - last.out_W).norm();
  if (length_m < 0.03 * kOmniReach_m * size) {  // the tip is on the last joint: a pen stands in it
    addPen(arm, count, tip_W, model.chain.X_WT_home.linear().col(2));
    return;
  }
  const Vec3 back_W = (last.out_W - tip_W) / length_m;
  const Pose X_WS = frameAlong(tip_W, back_W);
  // A flange, then a cone down to a ball, as long as it fits.
  const double cone_m = std::min(0.6 * length_m, 0.22 * kOmniReach_m * size);
  const double ball_m = 0.0022 * size, thick_m = std::min(0.55 * radius_m, 0.4 * cone_m);
  arm.solids.push_back(
      {count, Finish::Metal, TurnedForm{X_WS, taperedRod(cone_m, length_m, 0.62 * radius_m, 0.72 * radius_m)}});
  arm.solids.push_back({count, Finish::Trim,
                        TurnedForm{X_WS, roundedRod(cone_m - 0.25 * radius_m, cone_m + 0.25 * radius_m, 0.8 * radius_m,
                                                    0.1 * radius_m)}});
  std::vector<Ring> profile;
  for (int step = 0; step <= 8; ++step) {
    const double angle_rad = -0.5 * kPi + step * 0.75 * kPi / 8;
    profile.push_back({step == 0 ? 0.0 : ball_m * std::cos(angle_rad), ball_m * (1.0 + std::sin(angle_rad))});
  }
  profile.push_back({thick_m, cone_m});
  profile.push_back({0.0, cone_m});
  arm.solids.push_back({count, Finish::Pen, TurnedForm{X_WS, profile}});
  arm.p_WEnd = tip_W + std::min(length_m, 0.084 * size) * back_W;
}

void addBase(ArmSolids& arm, bool is_device) {
  const DrawnAxis& first = arm.axes.front();
  const Vec3 up_W = arm.stand.up_W(), shoulder_W = first.out_W;
  const double size = arm.stand.size, radius_m = first.radius_m;
  const double height_m = (shoulder_W - arm.stand.p_WG).dot(up_W);
  const Pose X_WG = frameAlong(shoulder_W - height_m * up_W, up_W);
  const auto add = [&](std::size_t link, Finish finish, std::vector<Ring> profile) {
    arm.solids.push_back({link, finish, TurnedForm{X_WG, std::move(profile)}});
  };
  if (is_device) {  // a foot that widens, and a turret with a dome from which the links come
    const double r = kOmniReach_m * size, seam_m = height_m - 0.118 * r;
    add(0, Finish::Trim, roundedRod(0.0, 0.026 * r, 0.205 * r, 0.011 * r));
    add(0, Finish::Shell,
        {{0.0, 0.022 * r},
         {0.184 * r, 0.022 * r},
         {0.181 * r, 0.034 * r},
         {0.158 * r, 0.048 * r},
         {0.128 * r, 0.068 * r},
         {0.108 * r, 0.100 * r},
         {0.099 * r, 0.150 * r},
         {0.096 * r, seam_m - 0.007 * r},
         {0.090 * r, seam_m},
         {0.0, seam_m}});
    add(1, Finish::Trim, roundedRod(seam_m - 0.004 * r, seam_m + 0.012 * r, 0.085 * r, 0.002 * r));
    std::vector<Ring> dome{{0.0, seam_m + 0.008 * r}, {0.094 * r, seam_m + 0.008 * r}, {0.101 * r, seam_m + 0.020 * r}};
    for (int step = 0; step <= 10; ++step) {
      const double angle_rad = 0.5 * kPi * step / 10;
      dome.push_back(
          {step == 10 ? 0.0 : 0.103 * r * std::cos(angle_rad), height_m - 0.02 * r + 0.098 * r * std::sin(angle_rad)});
    }
    add(1, Finish::Shell, std::move(dome));
    return;
  }
  const double plate_m = 0.35 * radius_m;
  add(0, Finish::Trim, roundedRod(0.0, plate_m, 2.0 * radius_m, 0.2 * plate_m));
  const bool is_upright = first.type == chain::JointType::Revolute && std::abs(first.axis_W.dot(up_W)) > kUpright;
  const double top_m = is_upright ? height_m - kColumnEnd * radius_m : height_m;
  if (top_m > plate_m) {
    add(0, Finish::Shell,
        {{0.0, 0.5 * plate_m},
         {1.5 * radius_m, 0.5 * plate_m},
         {1.5 * radius_m, plate_m},
         {1.18 * radius_m, plate_m + 0.3 * radius_m},
         {1.04 * radius_m, std::max(top_m, plate_m + 0.35 * radius_m)},
         {0.0, std::max(top_m, plate_m + 0.35 * radius_m)}});
  }
}

}  // namespace underact::gui
