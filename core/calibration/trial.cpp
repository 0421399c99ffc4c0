#include "core/calibration/trial.h"

#include <algorithm>
#include <utility>

#include "core/base/axis_geometry.h"
#include "core/base/random.h"
#include "core/base/translate.h"
#include "core/base/units.h"

namespace underact::calibration {
namespace {

using scene::VirtualManipulator;

/// The position of its tip, mm.
Vec3 tipOf(const VirtualManipulator& beam) {
  return beam.X_WV_home.topRightCorner<3, 1>();
}

/// The squared lever arm of the tip about its joint, mm^2.
double squaredLever(const VirtualManipulator& beam) {
  return perpendicularPart(beam.joints[0].axis.normalized(), tipOf(beam) - beam.joints[0].point_mm).squaredNorm();
}

bool isBeam(const scene::Constraint& constraint) {
  const auto* robot = std::get_if<VirtualManipulator>(&constraint.shape);
  return robot != nullptr && robot->joints.size() == 1 && robot->joints[0].type == chain::JointType::Revolute &&
         robot->joints[0].stiffness > 0.0 && squaredLever(*robot) > 0.0;
}

}  // namespace

Trial drawTrial(const Staircase& staircase, double reference_N_per_mm, std::uint64_t& random) {
  Trial trial{nextShare(random) < 0.5 ? Beam::Left : Beam::Right, staircase.difference, reference_N_per_mm,
              reference_N_per_mm};
  (trial.stiffer == Beam::Left ? trial.left_N_per_mm : trial.right_N_per_mm) *= 1.0 + trial.difference;
  return trial;
}

Result<std::array<std::size_t, 2>> beamsOf(const scene::Description& scene) {
  std::vector<std::size_t> beams;
  for (std::size_t index = 0; index < scene.constraints.size(); ++index) {
    if (isBeam(scene.constraints[index])) beams.push_back(index);
  }
  if (beams.size() != 2 || scene.constraints.size() != 2) {
    return Problems{
        {phrase(TRANSLATE_NOOP("problem",
                               "A threshold measurement needs a scene with two beams: two virtual robots, each with "
                               "one revolute joint and a spring. Open the scene \"Two beams, one softer\".")),
         {scene.file, 0, 0, "constraints"}}};
  }
  const auto x_of = [&](std::size_t index) {
    return tipOf(std::get<VirtualManipulator>(scene.constraints[index].shape)).x();
  };
  if (x_of(beams[1]) < x_of(beams[0])) std::swap(beams[0], beams[1]);
  return std::array<std::size_t, 2>{beams[0], beams[1]};
}

Result<scene::Description> withStiffness(scene::Description scene, const Trial& trial) {
  const auto beams = beamsOf(scene);
  if (!beams) return beams.problems();
  for (const Beam side : {Beam::Left, Beam::Right}) {
    auto& beam = std::get<VirtualManipulator>(scene.constraints[beams.value()[static_cast<std::size_t>(side)]].shape);
    const double stiffness_N_per_mm = side == Beam::Left ? trial.left_N_per_mm : trial.right_N_per_mm;
    beam.joints[0].stiffness = stiffness_N_per_mm * squaredLever(beam);
  }
  return scene;
}

Result<double> softerOf(const scene::Description& scene) {
  const auto beams = beamsOf(scene);
  if (!beams) return beams.problems();
  double softest = kInfinity;
  for (const std::size_t index : beams.value()) {
    const auto& beam = std::get<VirtualManipulator>(scene.constraints[index].shape);
    softest = std::min(softest, beam.joints[0].stiffness / squaredLever(beam));
  }
  return softest;
}

Vec3 tipOf(const scene::Description& scene, Beam beam) {
  const auto beams = beamsOf(scene);
  if (!beams) return Vec3::Zero();
  return kMetrePerMillimetre *
         tipOf(std::get<VirtualManipulator>(scene.constraints[beams.value()[static_cast<std::size_t>(beam)]].shape));
}

const char* name(Beam beam) {
  return beam == Beam::Left ? "left" : "right";
}

}  // namespace underact::calibration
