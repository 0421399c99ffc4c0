#pragma once
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/base/integration.h"
#include "core/base/result.h"
#include "core/base/types.h"
#include "core/mesh_file/facts.h"
#include "core/scene/shapes.h"
#include "core/target/target.h"
#include "core/tick/program.h"

namespace underact::scene {

// A scene as people write it: the numbers of the file, in the file's units (mm, N/mm), so that saving writes back what
// was read. Keys and ranges: the scene reference in resources/guide. compile() makes a tick program in SI of it.

/// A joint in the home pose. Values of revolute joints in rad, of prismatic ones in mm.
struct Joint {
  chain::JointType type = chain::JointType::Revolute;
  Vec3 axis = Vec3::UnitZ();
  Vec3 point_mm = Vec3::Zero();  // on the axis; revolute only
  std::optional<double> min = {};
  std::optional<double> max = {};
  double stiffness = 0.0;  // of the joint's own spring, N mm/rad or N/mm; 0: it moves freely
  double rest = 0.0;       // where that spring is relaxed
  bool operator==(const Joint&) const = default;
};

/// The method by which the joints are found.
enum class SolverMethod : std::uint8_t { Auto, ClosedForm, Iterative };
/// How a virtual robot's joints of least energy are found.
struct Solver {
  SolverMethod method = SolverMethod::Auto;
  int max_steps = 20;
  double tolerance = 1e-10;
  bool operator==(const Solver&) const = default;
};

/// A virtual robot; the stylus is held to its end effector.
struct VirtualManipulator {
  std::vector<Joint> joints;
  Eigen::Matrix4d X_WV_home = Eigen::Matrix4d::Identity();  // translation in mm
  manipulator::Orientation orientation = manipulator::Orientation::None;
  double ko_N_mm_per_rad = 0.0;
  Solver solver;
  manipulator::ForceLaw force_law = manipulator::ForceLaw::Energy;
  bool operator==(const VirtualManipulator&) const = default;
};

inline constexpr double kMaxSmooth_deg = 45.0;  // sharper bends are meant to be felt as edges

/// A mesh from a file, placed in the workspace.
struct Mesh {
  std::string file;  // as written in the scene: relative to the scene's folder, or absolute
  double scale_mm_per_unit = 1.0;
  Eigen::Matrix4d X_WM = Eigen::Matrix4d::Identity();  // translation in mm
  mesh::Search search = mesh::Search::Hybrid;
  double smooth_deg = 0.0;    // how far the force may lean from the faces' own normals, so that bends feel round
  std::string checksum = {};  // of the file's content, where the scene says it (recorded ones do)
  std::shared_ptr<const mesh::Surface> surface = {};   // what loadMeshes() found in the file; null before
  std::string loaded_checksum = {};                    // of what was found there
  std::shared_ptr<const mesh_file::Facts> facts = {};  // what was found about it
  /// Equal by what the scene file states; the loaded surface and its facts do not count.
  bool operator==(const Mesh& other) const;
};

/// Guidance along a curve.
struct CurveGuidance {
  double t = 0.0;               // 0: guide only, 1: nearest point only
  double speed_mm_per_s = 0.0;  // of the guide; below 0: backwards
  double lead_mm = 10.0;        // how far ahead of the hand it goes at most
  bool operator==(const CurveGuidance&) const = default;
};

/// A path through the points of a file.
struct Curve {
  std::string file;  // as in Mesh
  double scale_mm_per_unit = 1.0;
  Eigen::Matrix4d X_WM = Eigen::Matrix4d::Identity();  // translation in mm
  curve::CurveKind kind = curve::CurveKind::Spline;
  bool closed = false;
  Search search = Search::Hybrid;
  std::optional<CurveGuidance> guide = {};               // none: the target is the nearest point
  std::string checksum = {};                             // as in Mesh
  std::shared_ptr<const std::vector<Vec3>> points = {};  // of the file, in its units; null before loadMeshes()
  std::string loaded_checksum = {};                      // as in Mesh
  Sentence note = {};                                    // on the form of the file; empty: none
  /// As in Mesh.
  bool operator==(const Curve& other) const;
};

/// What a constraint can be.
using Shape = ShapesAnd<std::variant, VirtualManipulator, Mesh, Curve>;

/// The word for the shape's type in a scene file: "point", "sphere", ...
const char* typeName(const Shape& shape);

/// The control law; each uses the gains of the one before it, too.
enum class LawType : std::uint8_t { P, PD, PID };
/// The metric of the nearest point with unequal gains.
enum class Anisotropy : std::uint8_t { Weighted, Euclidean };

/// Per axis of W: x, y, z.
struct Gains {
  Vec3 kp_N_per_mm = Vec3::Constant(0.5);
  Vec3 kd_N_s_per_mm = Vec3::Zero();
  Vec3 ki_N_per_mm_s = Vec3::Zero();
  bool operator==(const Gains&) const = default;
};

// The filters of the error's rate, with their settings. The first is the default; the guide's page velocity.md has the
// measurements from which it and its numbers were chosen.
struct KalmanFilter {
  double noise_mm = 0.016;
  double acceleration_mm_per_s2 = 8000.0;
  bool operator==(const KalmanFilter&) const = default;
};
/// A first-order filter.
struct LowPassFilter {
  double time_constant_ms = 1.6;
  bool operator==(const LowPassFilter&) const = default;
};
/// The slope over a window that adapts to the motion.
struct AdaptiveWindowFilter {
  double window = 8.0;  // ticks, a whole number
  double noise_mm = 0.11;
  bool operator==(const AdaptiveWindowFilter&) const = default;
};
/// The last difference, unfiltered.
struct RawFilter {
  bool operator==(const RawFilter&) const = default;
};
/// The filter of the error's rate; the first is the default.
using Velocity = std::variant<KalmanFilter, LowPassFilter, AdaptiveWindowFilter, RawFilter>;

/// How an error becomes a force.
struct Control {
  LawType law = LawType::P;
  Gains gains;
  Anisotropy anisotropy = Anisotropy::Weighted;
  tick::Space space = tick::Space::Cartesian;
  Velocity velocity = {};
  control::Passivity passivity = control::Passivity::Observe;
  bool operator==(const Control&) const = default;
};

/// The direction along the stylus's z axis that counts. PlusZ: from the tip to the hand.
enum class StylusAxis : std::uint8_t { PlusZ, MinusZ };
/// How position and orientation of the stylus are weighed in the target; of a circle, a cylinder or a sphere.
struct Influence {
  double t = 0.5;  // 0: orientation only, 1: position only
  StylusAxis stylus_axis = StylusAxis::PlusZ;
  double blend_deg = 5.0;
  bool operator==(const Influence&) const = default;
};

/// Coefficients of friction, tangential over normal force; of a shape or a mesh.
struct Friction {
  double static_share = 0.0, dynamic_share = 0.0;
  bool operator==(const Friction&) const = default;
};

/// One thing that the stylus is held to, or kept out of.
struct Constraint {
  std::string name;  // unique in the scene; type and number where the file gives none
  Shape shape;
  target::Side side = target::Side::Both;
  std::optional<Control> control;           // its own; else the scene's
  SourceLocation place = {};                // of the constraint in its file
  std::optional<Influence> influence = {};  // none: position only
  std::optional<Friction> friction = {};    // none: smooth
};

/// How the simulated arm is integrated.
struct Simulation {
  Integrator integrator = Integrator::Trapezoidal;
  double substep_us = 1e-3 * kSubstep_ns;
  bool operator==(const Simulation&) const = default;
};
inline constexpr double kShortestSubstep_us = 5.0, kLongestSubstep_us = 10'000.0;

/// In core's unit, rounded to whole nanoseconds.
Integration integrationOf(const Simulation& simulation);

struct ArmFile;

/// A whole scene. Which arm it has: scene_arm.h.
struct Description {
  std::string title;
  std::string about;
  std::string arm = "omni-thesis";  // a name, or a file as in Mesh
  Control control;
  tick::Combine combine = tick::Combine::Sum;
  Simulation simulation;
  std::vector<Constraint> constraints;
  std::string file;                              // where it was read from; empty: not from a file
  std::string arm_text = {};                     // of the arm's file, where the scene says it (recorded ones do)
  std::shared_ptr<const ArmFile> arm_file = {};  // what was read of the arm's file; null: the arm is none of a file
};

/// The control of the constraint at index: its own or the scene's.
const Control& controlOf(const Description& scene, std::size_t index);

}  // namespace underact::scene
