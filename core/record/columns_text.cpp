#include "core/record/columns_text.h"

#include <array>

#include "core/json/object_text.h"
#include "core/record/columns.h"
#include "core/record/session_tables.h"

namespace underact::record {
namespace {

json::ObjectText objectOf(const Column& column) {
  json::ObjectText object;
  object.addText("name", column.name);
  object.addText("unit", column.unit);
  object.addText("frame", column.frame);
  object.addText("type", typeWord(column));
  object.addInteger("width", column.width);
  object.addText("meaning", column.meaning);
  const std::vector<std::string_view> csv = csvNamesOf(column);
  object.addTexts("parts", partsOf(column));
  object.addTexts("csv", {csv.begin(), csv.end()});
  return object;
}

const char* presenceWord(Presence presence) {
  switch (presence) {
    case Presence::Always:
      return "always";
    case Presence::Later:
      return "later";
    case Presence::OnRequest:
      return "on request";
  }
  return "";
}

/// A cell of a table of the guide: in code where it is a name.
std::string cell(std::string_view text, bool is_code) {
  if (text.empty()) return "";
  return is_code ? "`" + std::string(text) + "`" : std::string(text);
}

std::string joined(const auto& names) {
  std::string list;
  for (const std::string_view name : names) list += (list.empty() ? "" : " ") + cell(name, true);
  return list;
}

}  // namespace

std::string columnsJson() {
  json::ObjectText all;
  all.addInteger("underact_columns", 1);
  std::vector<json::ObjectText> tables, fields;
  const std::array described = sessionTables(1000);
  for (std::size_t index = 0; index < described.size(); ++index) {
    const Table& table = described[index];
    json::ObjectText& object = tables.emplace_back();
    object.addText("name", table.name);
    object.addText("about", table.about);
    object.addText("presence", presenceWord(table.presence));
    object.addInteger("block_rows", table.block_rows);
    object.addInteger("chunk_rows", table.chunk_rows);
    object.addInteger("most_block_rows", table.max_block_rows);
    const std::int64_t max_rows = kSessionLimits.rowsOf(static_cast<TableIndex>(index));
    max_rows == INT64_MAX ? object.addNull("most_rows") : object.addInteger("most_rows", max_rows);
    std::vector<json::ObjectText> columns;
    for (const Column& column : table.columns) columns.push_back(objectOf(column));
    object.addList("columns", columns);
  }
  for (const CsvField& field : csvFields()) {
    json::ObjectText& object = fields.emplace_back();
    object.addText("name", field.name);
    object.addText("unit", field.unit);
    object.addText("type", field.type);
    object.addText("column", field.column->name);
    object.addInteger("part", field.part);
  }
  json::ObjectText limits;
  limits.addInteger("label_bytes", kSessionLimits.label_bytes);
  limits.addInteger("all_label_bytes", kSessionLimits.all_label_bytes);
  limits.addInteger("text_bytes", kSessionLimits.text_bytes);
  limits.addInteger("attribute_bytes", kSessionLimits.attribute_bytes);
  all.addObject("limits", limits);
  all.addList("tables", tables);
  all.addList("csv", fields);
  return all.text();
}

std::string columnsPage() {
  std::string page =
      "# The columns of a session\n\n"
      "All columns of a [session file](session_file.md), by table: a page made from the one table that recorder, "
      "readers, exports, plots and\n"
      "[live data](live_data.md) use. `underact-cli log columns` prints it as JSON.\n\n"
      "Frame W is the workspace: x to the right, y up, z towards you. In the column of parts are the names in Parquet "
      "and in a DataFrame, where each number\n"
      "has a column of its own; in the last column the names in CSV, live data and fault files, where `time_s` is in "
      "seconds and `fault` a word. HDF5, MCAP and\n"
      "Python have all columns. Parquet keeps unit, frame and meaning as metadata of each field, an exported CSV file "
      "in `NAME-metadata.json` beside it.\n";
  for (const Table& table : sessionTables(1000)) {
    page += "\n## /" + std::string(table.name) + "\n\nOne row is " + std::string(table.about);
    if (table.presence == Presence::Later) page += "; sessions of earlier versions do not have this table";
    if (table.presence == Presence::OnRequest) page += "; only where it was asked for (`run --record-details`)";
    page += ".\n\n| column | unit | frame | type | meaning | parts | CSV |\n|---|---|---|---|---|---|---|\n";
    for (const Column& column : table.columns) {
      const std::string type =
          std::string(typeWord(column)) + (column.width > 1 ? " x " + std::to_string(column.width) : std::string());
      page += "| " + cell(column.name, true) + " | " + cell(column.unit, false) + " | " + cell(column.frame, false) +
              " | " + type + " | " + cell(column.meaning, false) + " | " +
              (column.width == 1 ? "" : joined(partsOf(column))) + " | " + joined(csvNamesOf(column)) + " |\n";
    }
  }
  return page;
}

}  // namespace underact::record
