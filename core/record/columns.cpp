#include "core/record/columns.h"

namespace underact::record {
namespace {

/// Takes the types of a tick's numbers; empty: that of the column.
struct Types {
  std::vector<std::string_view> found;
  void integer(auto) { found.emplace_back(); }
  void number(double) { found.emplace_back("float64"); }
  void word(FaultKind) { found.emplace_back("string"); }
};

std::vector<CsvField> everyField() {
  Types types;
  fillAll({}, arm::findPreset(arm::kDefaultArm)->geometry, types);
  std::vector<CsvField> fields;
  for (const std::size_t index : kFieldOrder) {
    const Column& column = tickColumns(true)[index];
    const std::vector<std::string_view> csv = csvNamesOf(column);
    const std::vector<std::string> names =
        csv.empty() ? partsOf(column) : std::vector<std::string>(csv.begin(), csv.end());
    for (std::size_t part = 0; part < names.size(); ++part) {
      const std::string_view type = types.found[fields.size()];
      fields.push_back(
          {names[part], &column, part, isTime(column) ? "s" : column.unit, type.empty() ? typeWord(column) : type});
    }
  }
  return fields;
}

}  // namespace

std::span<const CsvField> allFields() {
  static const std::vector<CsvField> kAll = everyField();
  return kAll;
}

std::span<const CsvField> csvFields(bool more_joints) {
  return allFields().first(more_joints ? kCsvNumbers : kCsvNumbers - kMoreJoints.column.width);
}

}  // namespace underact::record
