#include "core/record/columns.h"

#include <algorithm>
#include <array>

#include "core/record/session_tables.h"

namespace underact::record {
namespace {

// A CSV recording has had its numbers in this order since before a session had all of them; new ones go to the end.
constexpr std::array<std::string_view, 19> kCsvOrder{
    "tick",          "time_ns",      "q_rad",      "p_WT_mm",  "p_WP_mm", "error_mm",
    "force_asked_N", "force_sent_N", "gate_level", "cut_N",    "fault",   "alpha_beta_theta_rad",
    "lateness_us",   "tick_us",      "buttons",    "revision", "limits",  "energy_mJ",
    "passive_N"};

const Column* columnOf(std::string_view name) {
  const std::span<const Column> columns = tickColumns();
  const auto found =
      std::find_if(columns.begin(), columns.end(), [&](const Column& column) { return column.name == name; });
  return found == columns.end() ? nullptr : &*found;
}

std::vector<CsvField> fieldsWith(bool more_joints) {
  std::vector<CsvField> fields;
  for (const std::string_view name : kCsvOrder) {
    const Column* const column = columnOf(name);
    if (column == nullptr) continue;
    const std::vector<std::string_view> names = csvNamesOf(*column);
    for (std::size_t part = 0; part < names.size(); ++part) {
      const bool is_time = names[part] == "time_s", is_word = names[part] == "fault";
      fields.push_back({names[part], column, part, is_time ? "s" : column->unit,
                        is_time   ? "float64"
                        : is_word ? "string"
                                  : typeWord(*column)});
    }
  }
  if (!more_joints) return fields;
  const Column& joints = jointColumns().back();
  const std::vector<std::string_view> names = csvNamesOf(joints);
  for (std::size_t part = 0; part < names.size(); ++part)
    fields.push_back({names[part], &joints, part, joints.unit, typeWord(joints)});
  return fields;
}

}  // namespace

const std::vector<CsvField>& csvFields(bool more_joints) {
  static const std::vector<CsvField> kSix = fieldsWith(false), kMore = fieldsWith(true);
  return more_joints ? kMore : kSix;
}

}  // namespace underact::record
