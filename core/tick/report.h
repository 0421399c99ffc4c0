#pragma once
#include <array>
#include <cstddef>

#include "core/arm/sample.h"
#include "core/safety/gate.h"
#include "core/target/constraint.h"
#include "core/tick/program.h"

namespace underact::tick {

/// The result for one constraint in a tick.
struct ConstraintReport : target::Details {
  Vec3 p_WP = Vec3::Zero();   // the target; the tip itself unless status is Unique
  Vec3 f_T_W = Vec3::Zero();  // its own force, before the gate
  target::Status status = target::Status::Free;
  double distance_m = 0.0;
  bool acts = false;                  // it contributes to the force (not where it is free or another is nearer)
  double energy_J = 0.0;              // net energy that the stylus has put into it; below 0: it is active
  Vec3 f_passive_T_W = Vec3::Zero();  // what the passivity controller adds; part of f_T_W
};

/// Up to kMaxConstraints of them, in place; a copy copies only those in use.
class ConstraintReports {
 public:
  ConstraintReports() = default;
  /// Copies those in use alone; what lies beyond stays as it was.
  ConstraintReports(const ConstraintReports& other) noexcept UNDERACT_REAL_TIME { *this = other; }
  /// Assigns those in use alone, as the copy does.
  ConstraintReports& operator=(const ConstraintReports& other) noexcept UNDERACT_REAL_TIME {
    resize(other.size_);
    for (std::size_t index = 0; index < size_; ++index) held_[index] = other.held_[index];
    return *this;
  }
  ~ConstraintReports() = default;
  std::size_t size() const noexcept UNDERACT_REAL_TIME { return size_; }
  /// Held to kMaxConstraints; entries that come into use are as they were left.
  void resize(std::size_t size) noexcept UNDERACT_REAL_TIME { size_ = size < kMaxConstraints ? size : kMaxConstraints; }
  /// index: below size(), not checked.
  ConstraintReport& operator[](std::size_t index) noexcept UNDERACT_REAL_TIME { return held_[index]; }
  const ConstraintReport& operator[](std::size_t index) const noexcept UNDERACT_REAL_TIME { return held_[index]; }
  /// Those in use, for a loop over them.
  const ConstraintReport* begin() const noexcept UNDERACT_REAL_TIME { return held_.data(); }
  /// Behind the last of them.
  const ConstraintReport* end() const noexcept UNDERACT_REAL_TIME { return held_.data() + size_; }

 private:
  std::size_t size_ = 0;
  std::array<ConstraintReport, kMaxConstraints> held_{};
};

/// All results of a tick, for view, plots and recorder.
struct TickReport {
  arm::Sample sample;
  int joints = 6;                // of the arm, if it has more than six; their values: sample
  Vec3 p_WT = Vec3::Zero();      // the tip
  Mat3 R_WT = Mat3::Identity();  // its orientation; the identity where the program does not need it
  Vec3 stylus_W = Vec3::Zero();  // its direction, z of frame 6; zero where the program does not need it
  ConstraintReports held;        // in the order of the scene
  Vec3 f_T_W = Vec3::Zero();     // asked, before the gate
  Vec3 m_T_W = Vec3::Zero();     // asked beside it, about the tip, N m; only of an arm whose motors render a moment
  safety::GatedForce force;      // sent
  double level = 0.0;            // share that the ramps let through
  safety::Cuts cuts;             // which limits act
  double cut_N = 0.0;            // what they took off in all
  Vec3 v_WT = Vec3::Zero();      // the tip's velocity, filtered by the gate
  Vec3 heat = Vec3::Zero();      // of motors 1 to 3; 1: at their continuous torque
  Fault fault;                   // why the force is zero, if a fault is why
  int branch_changes = 0;        // space joint: targets whose joints changed to another branch of the arm
  bool out_of_reach = false;     // space joint: a target is out of reach; its joints are the nearest ones
  double damping_m = 0.0;        // space joint: how far torques were damped near a singularity; 0: exact
};

/// The distance between tip and target over the constraints that act: root of the sum of squares, m. 0 where none does.
double errorOf(const TickReport& report) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::tick
