#include "core/arm/model.h"

#include <underact/arm_files.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/arm/forward.h"
#include "core/base/axis_geometry.h"
#include "core/base/units.h"

namespace underact::arm {
namespace {

std::vector<Model> readShipped() {
  std::vector<Model> all;
  for (const std::string_view text : kArmFiles) {
    Result<Model> model = readArm(text, "resources/arms");
    if (model) all.push_back(std::move(model).value());  // that each can be read is tested
  }
  return all;
}

bool isNear(double a, double b) {
  return std::abs(a - b) <= 1e-12;
}

}  // namespace

std::span<const Model> models() {
  static const std::vector<Model> kAll = readShipped();
  return kAll;
}

const Model* findModel(std::string_view name) {
  const std::span<const Model> all = models();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Model& model) { return model.name == name; });
  return found == all.end() ? nullptr : &*found;
}

std::string_view fileOf(std::string_view name) {
  const Model* const model = findModel(name);
  return model == nullptr ? std::string_view() : kArmFiles[model - models().data()];
}

std::optional<Geometry> omniGeometry(const Model& model) {
  constexpr std::array<double, 6> kTwists_deg{0, 90, 0, 90, -90, 90};
  if (model.rows.size() != 6) return {};
  for (std::size_t row = 0; row < 6; ++row) {
    const chain::DhRow& one = model.rows[row];
    const bool fits = one.type == chain::JointType::Revolute &&
                      isNear(one.alpha_rad, kRadPerDegree * kTwists_deg[row]) && isNear(one.theta_rad, 0.0) &&
                      (row == 2 || one.a_m == 0.0) && (row == 3 || one.d_m == 0.0);
    if (!fits) return {};
  }
  const Geometry geometry{model.rows[2].a_m, model.rows[3].d_m, model.X_WB.translation()};
  const bool in_place =
      (model.X_WB.linear() - workspaceFromBase()).isZero(1e-12) && model.X_NT.matrix().isIdentity(1e-12);
  if (!in_place || !(geometry.upper_m > 0.0 && geometry.fore_m > 0.0)) return {};
  return geometry;
}

JointLimits limitsOf(const Model& model) {
  JointLimits limits = kNoJointLimits;
  for (std::size_t joint = 0; joint < std::min(kMaxJoints, model.rows.size()); ++joint) {
    limits.min_rad[joint] = model.rows[joint].min;
    limits.max_rad[joint] = model.rows[joint].max;
  }
  return limits;
}

bool isWithinLimits(const Model& model, std::span<const double> q) {
  for (std::size_t joint = 0; joint < std::min(q.size(), model.rows.size()); ++joint) {
    const double value = model.limits_wrist_size && joint == 4 ? std::abs(q[joint]) : q[joint];
    if (!(value >= model.rows[joint].min && value <= model.rows[joint].max)) return false;
  }
  return true;
}

void turnIntoLimits(const Model& model, std::span<double> q, std::span<const double> near) {
  constexpr double kTurn = 2.0 * kPi;
  constexpr double kRounding = 1e-12;  // rad; a joint that a pose was computed from at its limit comes back beside it
  for (std::size_t joint = 0; joint < std::min(q.size(), model.rows.size()); ++joint) {
    const chain::DhRow& row = model.rows[joint];
    if (row.type != chain::JointType::Revolute || (model.limits_wrist_size && joint == 4)) continue;
    const double own = wrapped(q[joint]);
    const double min = std::ceil((row.min - kRounding - own) / kTurn);
    const double max = std::floor((row.max + kRounding - own) / kTurn);
    double turns = joint < near.size() ? std::round((near[joint] - own) / kTurn) : 0.0;
    if (min <= max) turns = std::clamp(turns, min, max);
    q[joint] = turns == 0.0 ? own : own + turns * kTurn;
    if (min <= max) q[joint] = std::clamp(q[joint], row.min, row.max);
  }
}

std::array<Pose, kMaxJoints> linkFrames(const Model& model, const JointAngles& q_rad) noexcept {
  std::array<Pose, kMaxJoints> frames;
  frames.fill(Pose::Identity());
  chain::framesOf(model.rows, model.X_WB, q_rad, frames);
  return frames;
}

}  // namespace underact::arm
