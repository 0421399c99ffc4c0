#include "app/gui/view/kinematics_picture.h"

#include <vtkProperty.h>

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "app/gui/model/kinematics_now.h"
#include "app/gui/view/hand_picture.h"
#include "core/arm/sample.h"
#include "core/base/units.h"

namespace underact::gui {
namespace {

// Frames 1 and 2 share their origin, and so do 4, 5 and 6: each a little smaller than the one before.
constexpr std::array<double, arm::kMaxJoints> kAxis_mm{30.0, 24.0, 24.0, 30.0, 24.0, 18.0, 18.0, 18.0};
constexpr double kBeyond_mm = 5.0;   // of a label
constexpr double kFacing_mm = 18.0;  // a ghost's turret: the way it faces
constexpr double kBend_mm = 14.0;    // a ghost's wrist: its axis 5
constexpr double kStylus_mm = 84.0;
constexpr double kApart_mm = 2.4;  // between the lines of two solutions with the same links
constexpr double kSamePlace_mm = 0.5;
constexpr int kEllipseParts = 72;
constexpr double kEllipsoidOpacity = 0.3, kFlattest_mm = 0.05;

/// Shoulder, elbow and tip of the arm at q_rad, mm, which way its turret faces and its wrist's axis 5 points.
struct Figure {
  Vec3 shoulder_mm, elbow_mm, tip_mm, facing_W, bend_W;
};

Figure figureOf(const arm::Model& model, const arm::Geometry& geometry, const arm::JointAngles& q_rad) {
  const arm::Skeleton skeleton = arm::skeleton(geometry, q_rad);
  const std::array<Pose, arm::kMaxJoints> frames = arm::linkFrames(model, q_rad);
  return {kMillimetrePerMetre * skeleton.p_WShoulder, kMillimetrePerMetre * skeleton.p_WElbow,
          kMillimetrePerMetre * skeleton.p_WTip, frames[0].linear().col(0), frames[4].linear().col(2)};
}

}  // namespace

std::size_t placeAmong(std::vector<Vec3>& places_mm, const Vec3& p_mm) {
  std::size_t place = 0;
  while (place < places_mm.size() && (places_mm[place] - p_mm).norm() > kSamePlace_mm) ++place;
  if (place == places_mm.size()) places_mm.push_back(p_mm);
  return place;
}

void addDashes(Lines& lines, const Vec3& a_mm, const Vec3& b_mm, double dash_mm, const QColor& colour) {
  const Vec3 travel_mm = b_mm - a_mm;
  const int pieces = std::max(1, static_cast<int>(travel_mm.norm() / (2.0 * dash_mm)));
  for (int piece = 0; piece < pieces; ++piece) {
    lines.segment(a_mm + travel_mm * ((piece + 0.25) / pieces), a_mm + travel_mm * ((piece + 0.75) / pieces), colour);
  }
}

KinematicsPicture::KinematicsPicture()
    : thin_actor_(makeActor(thin_.data(), PieceKind::Line)),
      frame_actor_(makeActor(frame_.data(), PieceKind::Mark)),
      mark_actor_(makeActor(mark_.data(), PieceKind::Mark)),
      motion_actor_(makeActor(unitSphere(40, 20), PieceKind::Tint)),
      force_actor_(makeActor(unitSphere(40, 20), PieceKind::Tint)) {
  for (vtkActor* actor : {motion_actor_.Get(), force_actor_.Get()}) {
    actor->SetVisibility(false);
    actor->GetProperty()->SetOpacity(kEllipsoidOpacity);
  }
  others_.setOrder(1);
  setArm(*arm::findPreset(arm::kDefaultArm), *arm::findModel(arm::kDefaultArm));
}

void KinematicsPicture::setTheme(const Theme& theme) {
  theme_ = theme;
  for (GhostArm* ghost : {&ghost_, &others_}) ghost->setColour(theme.virtual_robot);
}

void KinematicsPicture::setArm(const arm::Preset& preset, const arm::Model& model) {
  torque_N_m_ = ellipsoidTorque_N_m(preset, model);
  geometry_ = preset.geometry;
  model_ = model;
  finder_ = SolutionFinder(model);
  solutions_.reset();
  ghost_.setArm(model);
  others_.setArm(model);
}

void KinematicsPicture::setLineWidth(double scale) {
  thin_actor_->GetProperty()->SetLineWidth(static_cast<float>(1.5 * scale));
  frame_actor_->GetProperty()->SetLineWidth(static_cast<float>(2.0 * scale));
  mark_actor_->GetProperty()->SetLineWidth(static_cast<float>(3.0 * scale));
}

void KinematicsPicture::show(bool link_frames, bool ghosts, bool motion_ellipsoid, bool force_ellipsoid) {
  frames_ = link_frames;
  ghosts_ = ghosts;
  motion_ = motion_ellipsoid;
  force_ = force_ellipsoid;
}

void KinematicsPicture::present(const arm::JointAngles& q_rad) {
  if (!std::all_of(q_rad.begin(), q_rad.end(), [](double angle) { return std::isfinite(angle); })) return;
  q_rad_ = q_rad;
  X_WT_ = arm::tipPose(geometry_, q_rad);
  solutions_.reset();
  known_ = true;
}

const NumberedSolutions& KinematicsPicture::solutions() const {
  if (!solutions_) solutions_ = finder_.at(X_WT_);
  return *solutions_;
}

std::optional<arm::JointAngles> KinematicsPicture::chosen_rad() const {
  const NumberedSolution* const found = known_ && chosen_ > 0 ? solutions().find(chosen_) : nullptr;
  if (found == nullptr) return {};
  return arm::interpolated(q_rad_, found->q, share_);
}

std::vector<Vec3> KinematicsPicture::extent_mm() const {
  std::vector<Vec3> points;
  if (!known_ || !ghosts_) return points;
  for (const NumberedSolution& solution : solutions().all) {
    if (!shareLinks()) {
      const std::vector<Vec3> of_arm = skeletonExtent_mm(solution.q);
      points.insert(points.end(), of_arm.begin(), of_arm.end());
      continue;
    }
    const Vec3 elbow_mm = kMillimetrePerMetre * arm::skeleton(geometry_, solution.q).p_WElbow;
    points.push_back(elbow_mm + kNumber_mm * outwards(elbow_mm));
  }
  return points;
}

std::vector<Vec3> KinematicsPicture::chosenExtent_mm() const {
  const std::optional<arm::JointAngles> at_rad = chosen_rad();
  if (!at_rad) return {};
  if (!shareLinks()) return skeletonExtent_mm(*at_rad);
  const Figure at = figureOf(model_, geometry_, *at_rad);
  return {at.shoulder_mm, at.elbow_mm, at.tip_mm,
          at.tip_mm + kStylus_mm * arm::tipPose(geometry_, *at_rad).linear().col(2)};
}

void KinematicsPicture::update(const OrbitCamera& camera) {
  thin_.clear();
  frame_.clear();
  mark_.clear();
  labels_.clear();
  ghost_.hide();
  others_.hide();
  motion_actor_->SetVisibility(false);
  force_actor_->SetVisibility(false);
  if (known_) {
    if (ghosts_) shareLinks() ? addSolutions() : addArms();
    addEllipsoids();
    if (frames_) addFrames();
    if (const std::optional<arm::JointAngles> at_rad = chosen_rad()) {
      shareLinks() ? addChosen(*at_rad, camera) : addChosenArm(*at_rad, camera);
      ghost_.presentAll({*at_rad});
    }
  }
  thin_.done();
  frame_.done();
  mark_.done();
}

void KinematicsPicture::addFrames() {
  const std::array<QColor, 3> colours{theme_.x_axis, theme_.y_axis, theme_.z_axis};
  const double scale = shareLinks() ? 1.0 : others_.size();
  const std::array<Pose, arm::kMaxJoints> frames = arm::linkFrames(model_, q_rad_);
  for (std::size_t index = 0; index < std::min(frames.size(), model_.rows.size()); ++index) {
    const Vec3 origin_mm = kMillimetrePerMetre * frames[index].translation();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Vec3 direction = frames[index].linear().col(static_cast<Eigen::Index>(axis));
      frame_.segment(origin_mm, origin_mm + scale * kAxis_mm[index] * direction, colours[axis]);
    }
    const Vec3 z_W = frames[index].linear().col(2);  // the axis of the joint
    // The last frame stands in the stylus, along it: its name at the stylus' end.
    const double name_mm = kBeyond_mm + (index + 1 == model_.rows.size() ? kStylus_mm : kAxis_mm[index]);
    labels_.push_back({QString("{%1}").arg(index + 1), origin_mm + scale * name_mm * z_W, theme_.ink, true});
  }
}

void KinematicsPicture::addSolutions() {
  // Solutions outside the limits first, so that a line shared with one inside is drawn solid.
  const std::vector<double> aside = aside_mm();
  for (const bool within : {false, true}) {
    for (std::size_t index = 0; index < aside.size(); ++index) {
      const NumberedSolution& solution = solutions().all[index];
      if (solution.within_limits == within) addSolution(solution, aside[index]);
    }
  }
  // The eight share two elbows (a turret that faces away reaches the same position with the other elbow), two ways to
  // face and two to bend the wrist: three numbers name each of them.
  const auto elbow = [this](const NumberedSolution& one) {
    return Vec3(kMillimetrePerMetre * arm::skeleton(geometry_, one.q).p_WElbow);
  };
  addNumbers(elbow, [this](const Vec3& place_mm) { return Vec3(place_mm + kNumber_mm * outwards(place_mm)); });
  const auto facing = [this](const NumberedSolution& one) {
    const Figure at = figureOf(model_, geometry_, one.q);
    return Vec3(at.shoulder_mm + (kFacing_mm + kBeyond_mm) * at.facing_W);
  };
  const auto bend = [this](const NumberedSolution& one) {
    const Figure at = figureOf(model_, geometry_, one.q);
    return Vec3(at.tip_mm + (kBend_mm + kBeyond_mm) * at.bend_W);
  };
  const auto there = [](const Vec3& place_mm) { return place_mm; };
  addNumbers(facing, there);
  addNumbers(bend, there);
}

/// How far each solution is drawn beside its true place, so that those with the same links lie apart.
std::vector<double> KinematicsPicture::aside_mm() const {
  std::vector<Vec3> elbows_mm;
  std::vector<int> places, order, count;
  for (const NumberedSolution& solution : solutions().all) {
    const Vec3 elbow_mm = kMillimetrePerMetre * arm::skeleton(geometry_, solution.q).p_WElbow;
    const std::size_t place = placeAmong(elbows_mm, elbow_mm);
    count.resize(elbows_mm.size());
    places.push_back(static_cast<int>(place));
    order.push_back(count[place]++);
  }
  std::vector<double> aside;
  for (std::size_t index = 0; index < places.size(); ++index)
    aside.push_back(kApart_mm * (order[index] - 0.5 * (count[static_cast<std::size_t>(places[index])] - 1)));
  return aside;
}

void KinematicsPicture::addSolution(const NumberedSolution& solution, double aside_mm) {
  const Figure at = figureOf(model_, geometry_, solution.q);
  // Aside within the plane of the arm, where it is seen from the side; an arm that is stretched has no plane.
  const Vec3 normal = (at.elbow_mm - at.shoulder_mm).cross(at.tip_mm - at.elbow_mm);
  const auto beside = [&](const Vec3& from_mm, const Vec3& to_mm) {
    const Vec3 heading = normal.cross(to_mm - from_mm);
    return heading.norm() > 1e-6 ? Vec3(aside_mm * heading.normalized()) : Vec3(Vec3::Zero());
  };
  const Vec3 upper_mm = beside(at.shoulder_mm, at.elbow_mm), fore_mm = beside(at.elbow_mm, at.tip_mm);
  const std::array<std::array<Vec3, 2>, 4> strokes{{{at.shoulder_mm + upper_mm, at.elbow_mm + upper_mm},
                                                    {at.elbow_mm + fore_mm, at.tip_mm + fore_mm},
                                                    {at.shoulder_mm, at.shoulder_mm + kFacing_mm * at.facing_W},
                                                    {at.tip_mm, at.tip_mm + kBend_mm * at.bend_W}}};
  const QColor faint = mixed(theme_.background, theme_.virtual_robot, 0.75);
  for (const auto& [a_mm, b_mm] : strokes) {
    if (solution.within_limits)
      thin_.segment(a_mm, b_mm, theme_.virtual_robot);
    else
      addDashes(thin_, a_mm, b_mm, kDash_mm, faint);
  }
}

void KinematicsPicture::addNumbers(const std::function<Vec3(const NumberedSolution&)>& place_mm,
                                   const std::function<Vec3(const Vec3& place_mm)>& label_mm) {
  std::vector<Vec3> places_mm;
  std::vector<QStringList> numbers;
  for (const NumberedSolution& solution : solutions().all) {
    const std::size_t place = placeAmong(places_mm, place_mm(solution));
    numbers.resize(places_mm.size());
    numbers[place] << QString::number(solution.number);
  }
  for (std::size_t place = 0; place < places_mm.size(); ++place) {
    labels_.push_back({QCoreApplication::translate("SceneView", "no. ") + numbers[place].join(QLatin1Char(' ')),
                       label_mm(places_mm[place]), mixed(theme_.virtual_robot, theme_.ink, 0.35), false});
  }
}

Vec3 KinematicsPicture::outwards(const Vec3& elbow_mm) const {
  const Vec3 away_mm = elbow_mm - 0.5 * kMillimetrePerMetre * (geometry_.p_WB + X_WT_.translation());
  return away_mm.norm() > 1e-6 ? Vec3(away_mm.normalized()) : Vec3::UnitY();
}

void KinematicsPicture::addChosen(const arm::JointAngles& q_rad, const OrbitCamera& camera) {
  const Figure at = figureOf(model_, geometry_, q_rad);
  const QColor colour = theme_.virtual_robot;
  const auto link = [&](const Vec3& a_mm, const Vec3& b_mm) {  // up to the rims of its hollow joints
    const Vec3 travel_mm = b_mm - a_mm;
    if (travel_mm.norm() < 2.0 * kHollow_mm) return;
    const Vec3 rim_mm = kHollow_mm * travel_mm.normalized();
    mark_.segment(a_mm + rim_mm, b_mm - rim_mm, colour);
  };
  link(at.shoulder_mm, at.elbow_mm);
  link(at.elbow_mm, at.tip_mm);
  for (const Vec3& joint_mm : {at.shoulder_mm, at.elbow_mm, at.tip_mm}) {
    mark_.circle(joint_mm, camera.right_W(), camera.up_W(), kHollow_mm, colour);
  }
  const Vec3 along_W = arm::tipPose(geometry_, q_rad).linear().col(2);
  mark_.segment(at.tip_mm + kHollow_mm * along_W, at.tip_mm + kStylus_mm * along_W, colour);
  mark_.segment(at.shoulder_mm + kHollow_mm * at.facing_W, at.shoulder_mm + kFacing_mm * at.facing_W, colour);
  mark_.segment(at.tip_mm + kHollow_mm * at.bend_W, at.tip_mm + kBend_mm * at.bend_W, colour);
}

void KinematicsPicture::addEllipsoids() {
  if (!motion_ && !force_) return;
  const arm::Dexterity dexterity = arm::dexterityOf(geometry_, q_rad_);
  if (motion_) {
    const QColor colour = theme_.dark ? theme_.motion : mixed(theme_.motion, theme_.ink, 0.25);
    addEllipsoid(*motion_actor_, dexterity, kMillimetrePerMetre * kTurn_rad * dexterity.gain_m, colour,
                 QStringLiteral("v"));
  }
  if (force_ && force_limit_N_ > 0.0) {
    const double size = shareLinks() ? 1.0 : others_.size();
    const double scale_mm = torque_N_m_ * size * HandPicture::kArrow_mm / force_limit_N_;
    Vec3 half_mm;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const double gain_m = dexterity.gain_m[axis];
      half_mm[axis] = gain_m * size * kLongest_mm > scale_mm ? scale_mm / gain_m : size * kLongest_mm;
    }
    addEllipsoid(*force_actor_, dexterity, half_mm, theme_.force, QStringLiteral("f"));
  }
}

void KinematicsPicture::addEllipsoid(vtkActor& surface, const arm::Dexterity& dexterity, const Vec3& half_mm,
                                     const QColor& colour, const QString& letter) {
  const Vec3 tip_mm = kMillimetrePerMetre * X_WT_.translation();
  Eigen::Matrix4d X = Eigen::Matrix4d::Identity();
  X.block<3, 3>(0, 0) = dexterity.axes_W * half_mm.cwiseMax(kFlattest_mm).asDiagonal();
  if (X.block<3, 3>(0, 0).determinant() < 0.0) X.col(2) *= -1.0;  // its outside stays outside
  X.block<3, 1>(0, 3) = tip_mm;
  place(surface, X);
  setColour(surface, colour);
  surface.SetVisibility(true);
  std::array<Vec3, kEllipseParts> points;
  for (int axis = 0; axis < 3; ++axis) {  // the ellipse in the plane of the other two
    const int one = (axis + 1) % 3, other = (axis + 2) % 3;
    for (int part = 0; part < kEllipseParts; ++part) {
      const double angle = 2.0 * kPi * part / kEllipseParts;
      points[static_cast<std::size_t>(part)] = tip_mm + half_mm[one] * std::cos(angle) * dexterity.axes_W.col(one) +
                                               half_mm[other] * std::sin(angle) * dexterity.axes_W.col(other);
    }
    thin_.chain(points, colour, true);
  }
  Eigen::Index longest = 0;
  half_mm.maxCoeff(&longest);
  const Vec3 end_mm = tip_mm + (half_mm[longest] + kBeyond_mm) * dexterity.axes_W.col(longest);
  labels_.push_back({letter, end_mm, colour, true});
}

}  // namespace underact::gui
