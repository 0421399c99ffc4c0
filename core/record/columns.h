#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/base/units.h"
#include "core/record/table.h"
#include "core/servo/snapshot.h"

namespace underact::record {

/// One number of a tick as CSV recordings, live data and fault files have it.
struct CsvField {
  std::string_view name;
  const Column* column;   // of /ticks; lives as long as the program
  std::size_t part;       // which of its numbers
  std::string_view unit;  // in CSV: s where the column has ns
  std::string_view type;  // in CSV: a word where the column has a number for it
};

/// The numbers of a tick in the order of a CSV recording, by the table of a session's columns: lengths mm, angles rad,
/// forces N, time s. more_joints: with those beyond the sixth, at the end.
const std::vector<CsvField>& csvFields(bool more_joints = false);

/// Passes the fields of a tick to a row in the order of csvFields(more_joints), by row.integer(), row.number() or
/// row.word().
template <class Row>
void fillRow(const servo::TickRecord& record, Row& row, bool more_joints = false) {
  constexpr double kMicrosecondPerNanosecond = 1e-3;
  const auto vector = [&row](const Vec3& value) {
    for (const double coordinate : value) row.number(coordinate);
  };
  row.integer(record.tick);
  row.number(kSecondPerNanosecond * static_cast<double>(record.time_ns));
  for (const double angle_rad : arm::firstSix(record.q_rad)) row.number(angle_rad);
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
  if (!more_joints) return;
  for (const double angle_rad : arm::beyondSix(record.q_rad)) row.number(angle_rad);
}

}  // namespace underact::record
