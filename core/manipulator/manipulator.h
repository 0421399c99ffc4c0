#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "core/chain/chain.h"

namespace underact::manipulator {

inline constexpr std::size_t kMaxJoints = 8;

/// One number for each joint, rad or m (or of their stiffness); what is beyond the chain's joints is 0.
using Values = std::array<double, kMaxJoints>;

/// What of the stylus's orientation the end effector V follows. Axis: the direction of z. Angle: the angle of z about
/// the axis of the one revolute joint, as in the thesis. Full: all of it.
enum class Orientation : std::uint8_t { None, Axis, Angle, Full };

/// How the joints of least energy are found. ClosedForm: see ClosedForm. Iterative: by damped Newton steps.
enum class Method : std::uint8_t { ClosedForm, Iterative };

/// Energy: F = K e at the joints of least energy. Thesis52: code 5.2 as corrected, for comparison.
enum class ForceLaw : std::uint8_t { Energy, Thesis52 };

/// The chains whose joints of least energy are known in closed form.
enum class ClosedFormKind : std::uint8_t { Circle, Sphere, Cylinder, Line, Plane };

/// The geometry of a closed form: centre C (a point on the axis), axis a, and for a rotating end effector its position
/// (u_W) and the direction of its z (z_W) at home, relative to the axis.
struct ClosedForm {
  ClosedFormKind kind = ClosedFormKind::Line;
  std::size_t turning = 0;  // the revolute joint (Circle, Cylinder)
  std::size_t sliding = 0;  // and the prismatic one
  Vec3 p_WC = Vec3::Zero();
  Vec3 axis_W = Vec3::UnitZ();
  Vec3 radial_W = Vec3::UnitX();  // from C to the tip at home, m, across the axis
  Vec3 z_W = Vec3::Zero();        // the tip's z at home, across the axis (Sphere: its part along radial_W)
};

/// How far the iteration goes in a tick.
struct Options {
  Method method = Method::Iterative;
  int max_steps = 20;        // a tick, 1 to 100
  double tolerance = 1e-10;  // of the joints: rad, and of the reach
  bool second_order = true;  // false: Gauss and Newton's approximation, for comparison
};

/// A virtual robot: a serial chain to whose end effector V the stylus is pulled. Made by makeManipulator().
/// Its energy: V = 1/2 e^T K e + 1/2 sum k_i (theta_i - rest_i)^2 with e = (p_V - p_T; e_o), K = diag(kp, ko); the
/// stylus is drawn to the tip at the joints of least energy. Source: Beckman 2007, section 5.2; errata section 6.
struct Manipulator {
  chain::Chain chain;  // 1 to kMaxJoints joints, V its tip
  Orientation orientation = Orientation::None;
  Vec3 kp_N_per_m = Vec3::Constant(500.0);
  double ko_N_m_per_rad = 0.0;
  Values spring{};  // of each joint, N m/rad or N/m; 0: it moves freely
  Values rest{};    // where the spring pulls nowhere
  ForceLaw law = ForceLaw::Energy;
  Options options;
  std::optional<ClosedForm> closed;  // the closed form that is used
  double reach_m = 1.0;              // scale of a sliding joint's steps
  bool bends = false;                // some joint has a spring
  std::size_t turning = 0;           // Orientation::Angle: the revolute joint
  double home_rad = 0.0;             // Orientation::Angle: where z of V points at home, about its axis
};

/// The input of makeManipulator(); members as those of Manipulator. method none: a closed form where there is one.
struct Wanted {
  chain::Chain chain;
  Orientation orientation = Orientation::None;
  Vec3 kp_N_per_m = Vec3::Constant(500.0);
  double ko_N_m_per_rad = 0.0;
  Values spring{};
  Values rest{};
  ForceLaw law = ForceLaw::Energy;
  std::optional<Method> method = {};
  int max_steps = 20;
  double tolerance = 1e-10;
};

/// Problems: more than kMaxJoints joints; a gain below 0 or not finite; orientation Angle (and the thesis's law, which
/// takes one joint alone) without exactly one revolute joint, or with z of V along its axis; Method::ClosedForm where
/// there is none.
Result<Manipulator> makeManipulator(Wanted wanted, const SourceLocation& place);

/// The closed form of a chain with equal gains and no springs: one joint or two, as 1R (circle), 2R with crossing axes
/// at right angles and without limits (sphere), RP along one axis (cylinder), P (line), PP at right angles (plane).
/// None for others, nor for an orientation that the form does not know.
std::optional<ClosedForm> closedFormOf(const Manipulator& manipulator);

}  // namespace underact::manipulator
