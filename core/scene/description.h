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
#include "core/target/target.h"
#include "core/tick/program.h"

namespace underact::scene {

// A scene as people write it: the numbers of the file, in the file's units (mm, N/mm), so that saving writes back what
// was read. contracts: the scene reference in resources/guide. compile() turns it into SI and into a tick program.

struct Point {
  Vec3 position_mm = Vec3::Zero();
  bool operator==(const Point&) const = default;
};
struct Sphere {
  Vec3 center_mm = Vec3::Zero();
  double radius_mm = 0.0;
  bool operator==(const Sphere&) const = default;
};
struct Line {
  Vec3 point_mm = Vec3::Zero();
  Vec3 direction = Vec3::UnitX();
  bool operator==(const Line&) const = default;
};
struct Plane {
  Vec3 point_mm = Vec3::Zero();
  Vec3 normal = Vec3::UnitY();
  bool operator==(const Plane&) const = default;
};
struct Circle {
  Vec3 center_mm = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();
  double radius_mm = 0.0;
  bool operator==(const Circle&) const = default;
};
struct Cylinder {
  Vec3 point_mm = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();
  double radius_mm = 0.0;
  bool operator==(const Cylinder&) const = default;
};
struct Box {
  Vec3 center_mm = Vec3::Zero();
  Vec3 size_mm = Vec3::Zero();
  Mat3 R_WB = Mat3::Identity();
  bool operator==(const Box&) const = default;
};

/// A joint at home. Values of revolute joints in rad, of prismatic ones in mm.
struct Joint {
  chain::JointType type = chain::JointType::Revolute;
  Vec3 axis = Vec3::UnitZ();
  Vec3 point_mm = Vec3::Zero();  // on the axis; revolute only
  std::optional<double> min = {};
  std::optional<double> max = {};
  double stiffness = 0.0;  // of the joint's own spring, N mm/rad or N/mm; 0: it moves freely
  double rest = 0.0;       // where that spring pulls nowhere
  bool operator==(const Joint&) const = default;
};

/// Which way the joints are found.
enum class SolverMethod : std::uint8_t { Auto, ClosedForm, Iterative };
struct Solver {
  SolverMethod method = SolverMethod::Auto;
  int max_steps = 20;
  double tolerance = 1e-10;
  bool operator==(const Solver&) const = default;
};

/// A robot that exists only in software; the stylus is held to its tip.
struct VirtualManipulator {
  std::vector<Joint> joints;
  Eigen::Matrix4d X_WV_home = Eigen::Matrix4d::Identity();  // translation in mm
  manipulator::Orientation orientation = manipulator::Orientation::None;
  double ko_N_mm_per_rad = 0.0;
  Solver solver;
  manipulator::ForceLaw force_law = manipulator::ForceLaw::Energy;
  bool operator==(const VirtualManipulator&) const = default;
};

inline constexpr double kMostSmooth_deg = 45.0;  // sharper bends are edges that one wants to feel

/// A mesh from a file, that stands in the workspace.
struct Mesh {
  std::string file;  // as the scene says it: relative to the scene's own folder, or absolute
  double scale_mm_per_unit = 1.0;
  Eigen::Matrix4d X_WM = Eigen::Matrix4d::Identity();  // translation in mm
  mesh::Search search = mesh::Search::Hybrid;
  double smooth_deg = 0.0;    // how far the force may lean from the faces' own normals, so that bends feel round
  std::string checksum = {};  // of the file's content, where the scene says it (recorded ones do)
  std::shared_ptr<const mesh::Surface> surface = {};   // what loadMeshes() found in the file; null before
  std::string loaded_checksum = {};                    // of what was found there
  std::shared_ptr<const mesh_file::Facts> facts = {};  // that were found about it
  /// What the scene says; what was found in the file does not count.
  bool operator==(const Mesh& other) const;
};

/// How a curve leads the hand along it.
struct CurveGuide {
  double t = 0.0;               // 0: to the guide alone, 1: to the nearest point alone
  double speed_mm_per_s = 0.0;  // of the guide; below 0: backwards
  double lead_mm = 10.0;        // how far ahead of the hand it goes at most
  bool operator==(const CurveGuide&) const = default;
};

/// A path through the points of a file.
struct Curve {
  std::string file;  // as of a mesh
  double scale_mm_per_unit = 1.0;
  Eigen::Matrix4d X_WM = Eigen::Matrix4d::Identity();  // translation in mm
  curve::Kind kind = curve::Kind::Spline;
  bool closed = false;
  Search search = Search::Hybrid;
  std::optional<CurveGuide> guide = {};                  // none: to the nearest point
  std::shared_ptr<const std::vector<Vec3>> points = {};  // of the file, in its units; null before loadMeshes()
  /// As of a mesh.
  bool operator==(const Curve& other) const;
};

using Shape = std::variant<Point, Sphere, Line, Plane, Circle, Cylinder, Box, VirtualManipulator, Mesh, Curve>;

/// The word of a scene file for the shape's type: "point", "sphere", ...
const char* typeName(const Shape& shape);

enum class LawType : std::uint8_t { P, PD, PID };
/// Which nearest point unequal gains mean.
enum class Anisotropy : std::uint8_t { Weighted, Euclidean };

/// Per axis of W: x, y, z.
struct Gains {
  Vec3 kp_N_per_mm = Vec3::Constant(0.5);
  Vec3 kd_N_s_per_mm = Vec3::Zero();
  Vec3 ki_N_per_mm_s = Vec3::Zero();
  bool operator==(const Gains&) const = default;
};

// How the rate of the error is found, with the settings of each filter. The usual one is the first; the guide's page
// velocity.md has the measurements that chose it and its numbers.
struct KalmanFilter {
  double noise_mm = 0.016;
  double acceleration_mm_per_s2 = 8000.0;
  bool operator==(const KalmanFilter&) const = default;
};
struct LowPassFilter {
  double time_constant_ms = 1.6;
  bool operator==(const LowPassFilter&) const = default;
};
struct AdaptiveWindowFilter {
  double window = 8.0;  // ticks, a whole number
  double noise_mm = 0.11;
  bool operator==(const AdaptiveWindowFilter&) const = default;
};
struct RawFilter {
  bool operator==(const RawFilter&) const = default;
};
using Velocity = std::variant<KalmanFilter, LowPassFilter, AdaptiveWindowFilter, RawFilter>;

struct Control {
  LawType law = LawType::P;
  Gains gains;
  Anisotropy anisotropy = Anisotropy::Weighted;
  tick::Space space = tick::Space::Cartesian;
  Velocity velocity = {};
  control::Passivity passivity = control::Passivity::Observe;
  bool operator==(const Control&) const = default;
};

/// How much of the stylus's turn goes into the target; circle, cylinder and sphere.
enum class StylusAxis : std::uint8_t { PlusZ, MinusZ };
struct Influence {
  double t = 0.5;  // 0: orientation only, 1: position only
  StylusAxis stylus_axis = StylusAxis::PlusZ;
  double blend_deg = 5.0;
  bool operator==(const Influence&) const = default;
};

/// Shares of the force across the surface: of a shape or a mesh.
struct Friction {
  double static_share = 0.0, dynamic_share = 0.0;
  bool operator==(const Friction&) const = default;
};

struct Constraint {
  std::string name;  // unique in the scene; made up from type and number where the file gives none
  Shape shape;
  target::Side side = target::Side::Both;
  std::optional<Control> control;           // its own; else the scene's
  Place place = {};                         // of the constraint in its file
  std::optional<Influence> influence = {};  // none: position only
  std::optional<Friction> friction = {};    // none: smooth
};

/// How the simulated arm, where there is no other, is integrated.
struct Simulation {
  Integrator integrator = Integrator::Trapezoidal;
  double substep_us = 1e-3 * kSubstep_ns;
  bool operator==(const Simulation&) const = default;
};
inline constexpr double kShortestSubstep_us = 5.0, kLongestSubstep_us = 10'000.0;

Integration integrationOf(const Simulation& simulation);

struct Description {
  std::string title;
  std::string about;
  std::string arm = "omni-thesis";
  Control control;
  tick::Combine combine = tick::Combine::Sum;
  Simulation simulation;
  std::vector<Constraint> constraints;
  std::string file;  // where it was read from; empty: nowhere
};

/// The control that holds for the constraint at index: its own or the scene's.
const Control& controlOf(const Description& scene, std::size_t index);

}  // namespace underact::scene
