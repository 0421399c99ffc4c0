#pragma once
#include <cstdint>

#include "core/servo/late.h"
#include "core/tick/report.h"

namespace underact::servo {

/// Idle: no force is asked for. Running: the servo pushes. Stopping: the force is ramping to zero. Faulted: it stopped
/// by itself; report.fault says why.
enum class Mode : std::uint8_t { Idle, Running, Stopping, Faulted };

/// The input of a tick besides the sample; bits of Snapshot::input.
enum InputBit : unsigned {
  kHadSample = 1,  // the arm gave one
  kEngaged = 2,    // the servo was to push
  kRestarted = 4,  // it was started in this tick
  kLate = 8,       // the tick started a whole period late
};

/// The state of the servo for other threads: the last tick, and the loop's own state.
struct Snapshot {
  tick::TickReport report;
  std::int64_t ticks = 0;      // since the loop was made
  std::uint64_t revision = 0;  // of the program in effect; counts the loads and edits of the Host
  Mode mode = Mode::Idle;
  unsigned input = 0;            // InputBit
  std::uint64_t orders = 0;      // that the Host gave and the servo has taken up, see Host::orders()
  std::int64_t lateness_ns = 0;  // of this tick's start
  std::int64_t tick_ns = 0;      // that the last tick took
  std::int64_t dropped = 0;      // records lost because they were not drained in time
  LateTicks late;
  bool waits_for_button = false;  // hold to run: the servo would push if the stylus button were held
};

/// One tick as a row: what plots and recorders keep. Lengths m, forces N.
struct TickRecord {
  std::int64_t tick = 0;
  std::int64_t time_ns = 0;
  arm::JointAngles q_rad{};
  int joints = 6;  // that count of these; an arm of fewer has 0 in the rest
  std::uint32_t buttons = 0;
  Vec3 p_WT = Vec3::Zero();
  Vec3 p_WP = Vec3::Zero();  // of the first constraint that acts; NaN where none does
  Vec3 v_WT = Vec3::Zero();  // the tip's velocity, filtered by the gate
  double error_m = 0.0;      // over all that act
  target::Angles angles;     // of the first influenced target that acts; NaN where none does
  Vec3 f_asked_T_W = Vec3::Zero();
  Vec3 f_sent_T_W = Vec3::Zero();
  Vec3 m_sent_T_W = Vec3::Zero();  // the moment beside it, N m, of an arm that renders one; sessions do not hold it
  double level = 0.0;
  double cut_N = 0.0;
  Vec3 heat = Vec3::Zero();  // see tick::TickReport
  unsigned limits = 0;       // which of the gate's limits acted: safety::CutBit
  double energy_J = 0.0;     // that the stylus has put into all constraints and not got back
  double passive_N = 0.0;    // what the passivity controllers add
  FaultKind fault = FaultKind::None;
  int branch_changes = 0;     // see tick::TickReport
  bool out_of_reach = false;  // see tick::TickReport
  std::uint64_t revision = 0;
  unsigned input = 0;        // InputBit
  std::uint64_t orders = 0;  // see Snapshot
  Mode mode = Mode::Idle;
  std::int64_t lateness_ns = 0;
  std::int64_t tick_ns = 0;
};

/// The row of a tick.
TickRecord recordOf(const Snapshot& snapshot) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::servo
