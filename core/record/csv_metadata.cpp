#include "core/record/csv_metadata.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <span>
#include <utility>

#include "core/base/translate.h"
#include "core/json/object_text.h"
#include "core/record/columns.h"
#include "core/system/file.h"
#include "core/system/private_file.h"

namespace underact::record {
namespace {

using json::ObjectText;

std::string datatypeOf(std::string_view type) {
  if (type == "float64") return "double";
  return type == "string" ? "string" : "integer";
}

/// A text of the session as JSON; null where it is not.
void addWhereJson(ObjectText& object, const char* key, const Result<std::string>& text) {
  const bool is_json = text && !text.value().empty() && json::parse(text.value(), "");
  is_json ? object.addJson(key, text.value()) : object.addNull(key);
}

void addRun(Session& session, ObjectText& notes) {
  const SessionInfo& info = session.info();
  const SessionHeader& header = info.header;
  notes.addText("session_id", header.session_id);
  notes.addText("program_version", info.program_version);
  for (const auto& [key, text] : kMetadata) notes.addText(key, header.words.*text);
  notes.addText("scene_title", header.scene_title);
  notes.addText("arm", header.arm);
  notes.addText("device", header.device);
  notes.addInteger("started_unix_ns", header.started_unix_ns);
  notes.addInteger("rate_hz", header.rate_hz);
  if (!session.changes().empty()) addWhereJson(notes, "scene", session.sceneText(session.changes().front()));
  std::vector<ObjectText> later, anchors;
  for (const ProvenanceRow& row : session.provenance()) {
    if (&row == &session.provenance().front()) {
      addWhereJson(notes, "provenance", session.provenanceText(row));
      continue;
    }
    ObjectText& change = later.emplace_back();
    change.addInteger("tick", row.tick);
    addWhereJson(change, "changed", session.provenanceText(row));
  }
  notes.addList("provenance_changes", later);
  for (const ClockRow& row : session.clock()) {
    ObjectText& anchor = anchors.emplace_back();
    anchor.addInteger("tick", row.tick);
    anchor.addInteger("time_ns", row.time_ns);
    anchor.addInteger("monotonic_ns", row.monotonic_ns);
    anchor.addInteger("unix_ns", row.unix_ns);
  }
  notes.addList("clock", anchors);
}

std::string metadataPath(const std::string& csv_path) {
  return csv_path + "-metadata.json";
}

}  // namespace

Result<std::string> csvMetadata(Session& session, const std::string& file_name) {
  std::vector<ObjectText> columns;
  ObjectText frames, schema, notes, all;
  for (const CsvField& field : csvFields(session.hasMoreJoints())) {
    ObjectText& column = columns.emplace_back();
    column.addText("name", field.name);
    column.addText("titles", field.name);
    column.addText("datatype", datatypeOf(field.type));
    column.addText("null", "");
    column.addText("dc:description", field.column->meaning);
    column.addText("schema:unitText", field.unit);
    frames.addText(field.name, field.column->frame);
  }
  schema.addList("columns", columns);
  notes.addObject("frames", frames);
  addRun(session, notes);
  all.addText("@context", "http://www.w3.org/ns/csvw");
  all.addText("url", file_name);
  all.addObject("tableSchema", schema);
  all.addList("notes", std::vector<ObjectText>{notes});
  return all.text() + "\n";
}

Problems checkCsvNames(const std::string& session_path, const std::string& csv_path) {
  const std::string beside = metadataPath(csv_path);
  for (const std::string& path : {csv_path, beside}) {
    if (Problems problems = system::checkNew(path, system::Existing::ReplaceFile); !problems.empty()) return problems;
    if (system::isSameFile(system::statusOf(session_path), system::statusOf(path)))
      return {
          {phrase(TRANSLATE_NOOP("problem", "This is the session itself, which is not replaced. Give another name.")),
           {path}}};
  }
  return {};
}

Problems writeCsvMetadata(Session& session, const std::string& csv_path) {
  const Result<std::string> text = csvMetadata(session, std::filesystem::path(csv_path).filename().string());
  if (!text) return text.problems();
  const std::string path = metadataPath(csv_path);
  if (Problems problems = system::checkNew(path, system::Existing::ReplaceFile); !problems.empty()) return problems;
  system::Descriptor file = system::makeNew(path, system::Existing::ReplaceFile);
  int reason = file.isOpen() ? system::writeAll(file.number(), std::as_bytes(std::span(text.value()))) : errno;
  if (const int late = file.close(); reason == 0) reason = late;
  if (reason == 0) return {};
  return {{phrase(TRANSLATE_NOOP("problem", "The recording is incomplete: %1."), {std::strerror(reason)}), {path}}};
}

}  // namespace underact::record
