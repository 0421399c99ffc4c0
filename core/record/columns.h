#pragma once
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "core/record/tick_table.h"

namespace underact::record {

/// One number of a tick as CSV recordings, live data, fault files and plots have it.
struct CsvField {
  std::string name;
  const Column* column;   // of a tick; lives as long as the program
  std::size_t part;       // which of its numbers
  std::string_view unit;  // s where the column has ns
  std::string_view type;  // of a fault, a word: "string"
};

/// The numbers of a tick in the order of a CSV recording: lengths mm, angles rad, forces N, time s. more_joints: with
/// those beyond the sixth, at the end.
std::span<const CsvField> csvFields(bool more_joints = false);
/// Those with more_joints, and then those that CSV does not have, by their names in Parquet.
std::span<const CsvField> allFields();

/// The indices in kTickFields in the order of allFields().
inline constexpr std::array kFieldOrder = [] {
  std::array<std::size_t, std::tuple_size_v<decltype(kTickFields)>> order{};
  for (std::size_t index = 0; index < order.size(); ++index) order[index] = index;
  const auto columns = std::apply([](const auto&... field) { return std::array{field.column...}; }, kTickFields);
  std::sort(order.begin(), order.end(), [&columns](std::size_t a, std::size_t b) {
    const auto rank = [&](std::size_t at) { return std::tuple(columns[at].csv.empty(), columns[at].csv_since, at); };
    return rank(a) < rank(b);
  });
  return order;
}();
/// How many columns CSV has, and how many numbers, with the joints beyond the sixth.
inline constexpr std::size_t kCsvColumns = std::apply(
    [](const auto&... field) { return (std::size_t{0} + ... + (field.column.csv.empty() ? 0 : 1)); }, kTickFields);
inline constexpr std::size_t kCsvNumbers = std::apply(
    [](const auto&... field) {
      return (std::size_t{0} + ... + static_cast<std::size_t>(field.column.csv.empty() ? 0 : field.column.width));
    },
    kTickFields);

/// Whether CSV has it in s.
constexpr bool isTime(const Column& column) {
  return column.unit == "ns";
}

/// Passes the numbers of a field to row.integer(), row.number() or row.word(), in the units of a CsvField.
template <class Row, class Access>
void fillField(const Field<Access>& field, const servo::TickRecord& record, Row& row, const auto&... geometry) {
  const auto fill = [&]<class Number>(Number number) {
    if constexpr (std::is_same_v<Number, FaultKind>) {
      row.word(number);
    } else {
      if constexpr (std::is_integral_v<Number>) {
        if (field.column.kind != NumberKind::Real && !isTime(field.column)) return row.integer(+number);
      }
      row.number(isTime(field.column) ? kSecondPerNanosecond * static_cast<double>(number) : scaled(field, number));
    }
  };
  eachNumber(field, record, fill, geometry...);
}

/// Passes those of the first fields in the order of allFields().
template <std::size_t kCount, class Row>
void fillFirst(const servo::TickRecord& record, Row& row, const auto&... geometry) {
  [&]<std::size_t... kIndices>(std::index_sequence<kIndices...>) {
    (fillField(std::get<kFieldOrder[kIndices]>(kTickFields), record, row, geometry...), ...);
  }
  (std::make_index_sequence<kCount>());
}

/// Passes the numbers of a tick to a row in the order of csvFields(more_joints), by row.integer(), row.number() or
/// row.word().
template <class Row>
void fillRow(const servo::TickRecord& record, Row& row, bool more_joints = false) {
  more_joints ? fillFirst<kCsvColumns>(record, row) : fillFirst<kCsvColumns - 1>(record, row);
}

/// Passes the numbers of a tick in the order of allFields(). geometry: see turnOf().
template <class Row>
void fillAll(const servo::TickRecord& record, const arm::Geometry& geometry, Row& row) {
  fillFirst<kFieldOrder.size()>(record, row, geometry);
}

}  // namespace underact::record
