#pragma once
#include <array>
#include <string_view>

#include "core/base/units.h"
#include "core/servo/snapshot.h"

namespace underact::record {

/// The columns of a tick, in the order of a CSV recording: lengths mm, angles rad, forces N, time s.
inline constexpr std::array<std::string_view, 34> kColumns{
    "tick",
    "time_s",
    "q1_rad",
    "q2_rad",
    "q3_rad",
    "q4_rad",
    "q5_rad",
    "q6_rad",
    "x_mm",
    "y_mm",
    "z_mm",
    "target_x_mm",
    "target_y_mm",
    "target_z_mm",
    "error_mm",
    "force_asked_x_N",
    "force_asked_y_N",
    "force_asked_z_N",
    "force_sent_x_N",
    "force_sent_y_N",
    "force_sent_z_N",
    "gate_level",
    "cut_N",
    "fault",
    "alpha_rad",
    "beta_rad",
    "theta_rad",
    "lateness_us",
    "tick_us",
    "buttons",
    "revision",
    "limits",
    "energy_mJ",
    "passive_N",
};

/// Passes the fields of a tick to a row in the order of kColumns, by row.integer(), row.number() or row.word().
template <class Row>
void fillRow(const servo::TickRecord& record, Row& row) {
  constexpr double kMicrosecondPerNanosecond = 1e-3;
  const auto vector = [&row](const Vec3& value) {
    for (const double coordinate : value) row.number(coordinate);
  };
  row.integer(record.tick);
  row.number(kSecondPerNanosecond * static_cast<double>(record.time_ns));
  for (const double angle_rad : record.q_rad) row.number(angle_rad);
  vector(kMillimetrePerMetre * record.p_WT);
  vector(kMillimetrePerMetre * record.p_WP);
  row.number(kMillimetrePerMetre * record.error_m);
  vector(record.f_asked_T_W);
  vector(record.f_sent_T_W);
  row.number(record.level);
  row.number(record.cut_N);
  row.word(name(record.fault));
  row.number(record.angles.alpha_rad);
  row.number(record.angles.beta_rad);
  row.number(record.angles.theta_rad);
  row.number(kMicrosecondPerNanosecond * static_cast<double>(record.lateness_ns));
  row.number(kMicrosecondPerNanosecond * static_cast<double>(record.tick_ns));
  row.integer(record.buttons);
  row.integer(record.revision);
  row.integer(record.limits);
  row.number(1e3 * record.energy_J);
  row.number(record.passive_N);
}

}  // namespace underact::record
