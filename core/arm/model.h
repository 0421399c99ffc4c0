#pragma once
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/arm/preset.h"
#include "core/base/result.h"
#include "core/chain/chain.h"

namespace underact::arm {

/// The data of an arm that is a haptic device.
struct DeviceFigures {
  EncoderCounts counts_per_turn{};
  double continuous_force_N = 0.0;
};

/// An arm of six joints as in its file: resources/arms/NAME.json, or a user's file.
struct Model {
  std::string name;
  std::string title;
  std::string provenance;
  std::array<chain::DhRow, 6> rows{};  // modified (Craig) convention
  JointLimits limits;
  bool limits_wrist_size = false;  // those of joint 5 are of its absolute value
  Pose X_WB = Pose::Identity();    // frame 0 of the table in the workspace
  Pose X_6T = Pose::Identity();    // the tool in frame 6
  std::optional<DeviceFigures> device;
};

/// An arm from JSON text. Problems: all at once. Keys: the guide, "Arm files".
Result<Model> readArm(std::string_view text, const std::string& file_name);
/// The same of a file. Problems, too: it cannot be read.
Result<Model> readArmFile(const std::string& path);

/// The models that ship with the program, read once.
std::span<const Model> models();
/// The shipped model of that name, or null; it lives as long as the program.
const Model* findModel(std::string_view name);

/// The file (JSON) that the shipped model of that name was read from; empty: there is none.
std::string_view fileOf(std::string_view name);

/// The lengths of an arm whose table has the form of table 3.1 of the thesis (a shoulder about the vertical, two links,
/// a wrist at the end of the second), in the workspace of eq. 3.1; none for any other arm. Such arms have kinematics in
/// closed form.
std::optional<Geometry> omniGeometry(const Model& model);

/// The same arm as a product of exponentials.
chain::Chain chainOf(const Model& model);

/// The frames 1 to 6 of the table in W.
std::array<Pose, 6> linkFrames(const Model& model, const JointAngles& q_rad) noexcept;

}  // namespace underact::arm
