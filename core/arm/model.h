#pragma once
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/arm/mechanism.h"
#include "core/arm/preset.h"
#include "core/arm/solid.h"
#include "core/base/result.h"
#include "core/chain/chain.h"
#include "core/chain/dh.h"

namespace underact::arm {

/// The data of an arm that is a haptic device, or simulated as one.
struct DeviceFigures {
  EncoderCounts counts_per_turn{};  // of a joint that slides: steps per mm; 0: not stated, its values are exact
  double continuous_force_N = 0.0;
  double continuous_moment_N_m = 0.0;  // 0: not stated
};

/// What a file says of a joint besides its geometry.
struct JointFacts {
  std::string name;
  bool driven = true;                     // by a motor: it can render a force
  bool sensed = true;                     // its value is measured
  std::optional<double> rest;             // rad or m, within the limits: where it is when nobody has moved it
  std::optional<double> max_torque = {};  // N m, or N where it slides: the most that its motor gives
};

/// The form in which a file gives the geometry.
enum class ArmForm { ModifiedDh, ClassicDh, Exponentials, Urdf };

/// An arm of 1 to kMaxJoints joints as in its file: resources/arms/NAME.json, or a user's file.
struct Model {
  std::string name;
  std::string title;
  std::string provenance;
  ArmForm form = ArmForm::ModifiedDh;
  chain::Chain chain;              // to the tool
  std::vector<chain::DhRow> rows;  // the same as a table in modified (Craig) convention, whatever the file's form
  Pose X_WB = Pose::Identity();    // frame 0 of the table in the workspace
  Pose X_NT = Pose::Identity();    // the tool in the last frame
  std::vector<JointFacts> joints;  // as many as rows
  std::vector<LinkMass> masses;    // as many as rows, 0 where the file says nothing; empty: it has none
  std::vector<LinkSolid> solids;   // what it looks like; empty: the file says nothing, and it is drawn by formula
  Problems notes = {};             // what reading the file chose or left out
  std::string folder;  // of the file on this disk that it was read from; empty: of none, and no mesh of it is opened
  bool limits_wrist_size = false;  // those of joint 5 are of its absolute value
  std::optional<DeviceFigures> device;
};

/// The two links of a robot between which the arm lies. Empty: its root, and the link that LinkFamily::tip() chooses.
struct UrdfEnds {
  std::string base;
  std::string tip;
};

/// An arm from JSON text. Problems: all at once. Keys: the guide, "Arm files".
Result<Model> readArm(std::string_view text, const std::string& file_name);
/// An arm from text, JSON or URDF, whichever it is. ends: of URDF. Problems: those of readArm() or readUrdf(); ends of
/// an arm in JSON.
Result<Model> readArmText(std::string_view text, const std::string& file_name, const UrdfEnds& ends = {});

/// Reads an arm's file, whose folder the model keeps. Problems, too: it cannot be read.
Result<Model> readArmFile(const std::string& path, const UrdfEnds& ends = {});

/// The models that ship with the program, read once.
std::span<const Model> models();
/// The shipped model of that name, or null; it lives as long as the program.
const Model* findModel(std::string_view name);

/// The file (JSON) that the shipped model of that name was read from; empty: there is none.
std::string_view fileOf(std::string_view name);

/// The lengths of an arm whose table has the form of table 3.1 of the thesis (a shoulder about the vertical, two links,
/// a wrist at the end of the second), in the workspace of eq. 3.1; none for any other arm. Such arms solvesInTick().
std::optional<Geometry> omniGeometry(const Model& model);

/// What a scene needs of its arm. Problems: a haptic device of omniGeometry() without its figures; a joint that is not
/// sensed, so that nobody would know where the tip is. The sentences have no place.
Result<Preset> presetOf(const Model& model);

/// The limits of its joints, rad or m; of joints that it does not have: none.
JointLimits limitsOf(const Model& model);

/// Whether each joint is within its limits as it stands. q: one value for each joint, rad or m.
bool isWithinLimits(const Model& model, std::span<const double> q);

/// Moves each joint that turns by full turns to the value nearest to that of near that its limits allow, if they allow
/// any, and without it to the value nearest to its own in (-pi, pi]. near: as q, or empty.
void turnIntoLimits(const Model& model, std::span<double> q, std::span<const double> near = {});

/// The frames of the rows of the table in W, as many as there are.
std::array<Pose, kMaxJoints> linkFrames(const Model& model, const JointAngles& q_rad) noexcept;

}  // namespace underact::arm
