#include "core/servo/snapshot.h"

#include <cmath>

namespace underact::servo {

TickRecord recordOf(const Snapshot& snapshot) noexcept {
  const tick::TickReport& report = snapshot.report;
  TickRecord record;
  record.tick = snapshot.ticks;
  record.time_ns = report.sample.time_ns;
  record.q_rad = report.sample.q_rad;
  record.joints = report.joints;
  record.buttons = report.sample.buttons;
  record.p_WT = report.p_WT;
  record.p_WP.setConstant(kNotANumber);
  for (const tick::ConstraintReport& held : report.held) {
    if (!held.acts || held.status != target::Status::Unique) continue;
    record.p_WP = held.p_WP;
    break;
  }
  for (const tick::ConstraintReport& held : report.held) {
    if (!held.acts || !std::isfinite(held.angles.theta_rad)) continue;
    record.angles = held.angles;
    break;
  }
  record.v_WT = report.v_WT;
  record.error_m = tick::errorOf(report);
  record.f_asked_T_W = report.f_T_W;
  record.f_sent_T_W = report.force.f_T_W();
  record.m_sent_T_W = report.force.m_T_W();
  record.level = report.level;
  record.cut_N = report.cut_N;
  record.heat = report.heat;
  record.limits = safety::bitsOf(report.cuts);
  Vec3 passive_T_W = Vec3::Zero();
  for (const tick::ConstraintReport& held : report.held) {
    record.energy_J += held.energy_J;
    passive_T_W += held.f_passive_T_W;
  }
  record.passive_N = passive_T_W.norm();
  record.fault = report.fault.kind;
  record.branch_changes = report.branch_changes;
  record.out_of_reach = report.out_of_reach;
  record.revision = snapshot.revision;
  record.input = snapshot.input;
  record.orders = snapshot.orders;
  record.mode = snapshot.mode;
  record.lateness_ns = snapshot.lateness_ns;
  record.tick_ns = snapshot.tick_ns;
  return record;
}

}  // namespace underact::servo
