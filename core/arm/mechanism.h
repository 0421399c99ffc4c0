#pragma once
#include <array>
#include <vector>

#include "core/arm/preset.h"
#include "core/arm/sample.h"
#include "core/base/real_time.h"
#include "core/base/types.h"
#include "core/chain/kinematics.h"

namespace underact::arm {

/// The mass that a joint carries along, up to the next joint; with all joints at 0, in W.
struct LinkMass {
  double mass_kg = 0.0;
  Vec3 p_WC = Vec3::Zero();             // its centre of mass
  Mat3 inertia_W_kg_m2 = Mat3::Zero();  // about that
};

/// An arm of a scene: any chain of 1 to 8 joints, and its motors. Its joint values are rad, or m where a joint slides;
/// those beyond its joints are 0.
struct Mechanism {
  chain::Chain chain;
  std::array<bool, kMaxJoints> driven{};        // by a motor
  std::vector<LinkMass> masses;                 // as many as joints, or none
  Pose X_WB = Pose::Identity();                 // frame 0 of the table
  JointAngles rest{};                           // within the limits: where it is when nobody has moved it
  bool renders_moment = false;                  // rendersMoment()
  double max_moment_N_m = 0.0;                  // if it does
  std::array<double, kMaxJoints> max_torque{};  // of each joint, N m, or N where it slides; 0: not stated
};
/// Whether both are the same arm, to the bit.
bool operator==(const Mechanism& a, const Mechanism& b) noexcept UNDERACT_REAL_TIME;

/// The joints that the gate watches, with their stops and their motors' heat: those that are driven. joint[i]: 0 to 7.
struct Watched {
  std::array<std::size_t, kMaxJoints> joint{};
  std::size_t count = 0;
  std::array<bool, kMaxJoints> slides{};  // of each joint that is watched
  bool push_freely = false;               // they render any force on the tip, which no other joint moves
  bool turn = false;                      // they render a moment about it, too
};
/// As many as there are; of lengths alone the first three joints. Cost: constant.
Watched watchedJoints(const Geometry& geometry) noexcept UNDERACT_REAL_TIME;

/// Whether the joint slides; false beyond its joints.
bool slides(const Geometry& geometry, std::size_t joint) noexcept UNDERACT_REAL_TIME;

/// The columns of J that move the tip, of the first three watched joints; 0 beyond. m/rad, or 1 where the joint slides.
Mat3 watchedColumns(const Watched& watched, const chain::Jacobian& J) noexcept UNDERACT_REAL_TIME;

/// The part of a force on the tip that the motors can render, as a matrix: f -> P f. An undriven joint passes no torque
/// on, so its column of J and a force that it carries are at right angles; and where no joint moves the tip in a
/// direction, no motor pushes in it. P projects onto what is left. A joint that moves the tip less than kMinLever_m
/// (of the other joints: beyond what they do) fades out, so that P is continuous. Symmetric, gains within 0 and 1 to 16
/// ulp. Source: statics, tau = J^T f with tau = 0 at the undriven joints.
Mat3 renderable(const Mechanism& arm, const chain::Jacobian& J) noexcept UNDERACT_REAL_TIME;

/// The part of a force and a moment together that the motors can render, scaled as (kMomentArm_m f, m), of an arm all
/// of whose joints are driven: in a direction in which no joint moves the tip, no motor pushes or turns.
Mat6 renderableWrench(const chain::Jacobian& J, double moment_arm_m) noexcept UNDERACT_REAL_TIME;

/// Whether its motors render a moment about the tip beside a force: all its joints are driven, and at its rest they
/// move and turn the tip in all six directions. A joint without a motor would have to pass on a torque of the moment.
bool rendersMoment(const Mechanism& arm);

inline constexpr double kMinLever_m = 1e-3;

}  // namespace underact::arm
