#include "app/cli/session_table.h"

#include <algorithm>
#include <initializer_list>
#include <iomanip>
#include <ostream>

#include "app/cli/json_object.h"
#include "core/base/printed.h"
#include "core/record/fault_file.h"

namespace underact::cli {
namespace {

std::string startedAt(const record::SessionInfo& info) {
  return record::isoTime(info.header.started_unix_ns / 1'000'000'000);
}

/// The faults that stopped the servo; those reported in ticks lead to one of them.
std::vector<servo::FaultMark> stops(const record::Session& session) {
  std::vector<servo::FaultMark> found;
  std::copy_if(session.faults().begin(), session.faults().end(), std::back_inserter(found),
               [](const servo::FaultMark& fault) { return !fault.from_servo; });
  return found;
}

JsonObject faultObject(const servo::FaultMark& mark) {
  const record::FaultWords words = record::wordsOf(mark.fault);
  JsonObject object;
  object.addInteger("tick", mark.tick);
  object.addText("kind", words.kind);
  object.addText("what", words.what);
  object.addText("what_to_do", words.what_to_do);
  return object;
}

/// What was run, from then on, as it stands in the file; a text that is not JSON is damage and null.
void addProvenance(record::Session& session, JsonObject& object) {
  const std::vector<record::ProvenanceRow>& rows = session.provenance();
  std::vector<JsonObject> later;
  bool has_first = false;
  for (const record::ProvenanceRow& row : rows) {
    const Result<std::string> text = session.provenanceText(row);
    const bool is_json = text && json::parse(text.value(), "");
    if (&row == &rows.front()) {
      has_first = is_json;
      if (is_json) object.addJson("provenance", text.value());
      continue;
    }
    JsonObject& change = later.emplace_back();
    change.addInteger("tick", row.tick);
    if (is_json) change.addJson("changed", text.value());
  }
  if (!has_first) object.addNull("provenance");
  object.addList("provenance_changes", later);
}

void addClock(const record::Session& session, JsonObject& object) {
  std::vector<JsonObject> anchors;
  for (const record::ClockRow& row : session.clock()) {
    JsonObject& anchor = anchors.emplace_back();
    anchor.addInteger("tick", row.tick);
    anchor.addInteger("time_ns", row.time_ns);
    anchor.addInteger("monotonic_ns", row.monotonic_ns);
    anchor.addInteger("unix_ns", row.unix_ns);
    anchor.addInteger("between_ns", row.between_ns);
  }
  object.addList("clock", anchors);
}

/// The scheduling as noted last: at the beginning the servo may not have had it yet.
std::string schedulingOf(record::Session& session) {
  std::string words = session.info().header.scheduling;
  for (const record::ProvenanceRow& row : session.provenance()) {
    const Result<json::Value> value = session.provenanceOf(row);
    const json::Value* found = value ? value.value().find("servo") : nullptr;
    for (const char* key : {"scheduling", "granted"}) found = found != nullptr ? found->find(key) : nullptr;
    if (found != nullptr && found->kind == json::JsonKind::String) words = found->text;
  }
  return words;
}

/// A member of what was run, in a word or a few; empty: the session does not say it.
std::string runWord(record::Session& session, std::initializer_list<const char*> keys) {
  if (session.provenance().empty()) return {};
  const Result<json::Value> value = session.provenanceOf(session.provenance().front());
  if (!value) return {};
  const json::Value* found = &value.value();
  for (const char* key : keys) found = found != nullptr ? found->find(key) : nullptr;
  if (found == nullptr) return {};
  if (found->kind == json::JsonKind::String) return found->text;
  return found->kind == json::JsonKind::Number ? json::numberText(found->number) : std::string();
}

}  // namespace

void printAsJson(record::Session& session, std::ostream& out) {
  const record::SessionInfo& info = session.info();
  JsonObject object;
  object.addText("file", info.path);
  for (const auto& [name, text] : record::kMetadata) object.addText(name, info.header.words.*text);
  object.addText("started_utc", startedAt(info));
  object.addInteger("ticks", info.ticks);
  object.addNumber("duration_s", info.duration_s);
  object.addInteger("rate_hz", info.header.rate_hz);
  object.addBool("complete", info.isComplete());
  if (info.isComplete()) {
    object.addText("ended", record::name(info.end->reason));
    object.addInteger("dropped", info.dropped);
  } else {
    object.addNull("ended");
    object.addNull("dropped");
  }
  object.addText("scene", info.header.scene_title);
  object.addInteger("changes", session.changes().size());
  object.addText("arm", info.header.arm);
  object.addText("device", info.header.device);
  object.addText("scheduling", schedulingOf(session));
  object.addText("version", info.program_version);
  object.addInteger("bytes", info.bytes);
  std::vector<JsonObject> faults, markers;
  for (const servo::FaultMark& mark : stops(session)) faults.push_back(faultObject(mark));
  for (const record::Marker& marker : session.markers()) {
    JsonObject& one = markers.emplace_back();
    one.addInteger("tick", marker.tick);
    one.addText("label", marker.label);
  }
  object.addList("faults", faults);
  object.addList("markers", markers);
  object.addText("session_id", info.header.session_id);
  object.addNumber("force_share", info.header.force_share);
  addProvenance(session, object);
  addClock(session, object);
  out << object.text() << '\n';
}

void printDifferences(const std::vector<record::SessionDifference>& found, std::ostream& out) {
  constexpr std::size_t kLongest = 60;
  const auto shortened = [](const std::string& text) {
    if (text.empty()) return std::string("not said");
    if (text.size() <= kLongest) return text;
    std::size_t end = kLongest;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;  // whole letters of UTF-8
    return text.substr(0, end) + "... (" + std::to_string(text.size()) + " bytes)";
  };
  for (const record::SessionDifference& one : found)
    out << printed(one.what + ": " + shortened(one.a) + " | " + shortened(one.b)) << '\n';
  if (found.empty()) out << "Nothing that was run differs.\n";
}

void printDifferencesAsJson(const std::vector<record::SessionDifference>& found, std::ostream& out) {
  JsonObject object;
  object.addBool("identical", found.empty());
  std::vector<JsonObject> differences;
  for (const record::SessionDifference& one : found) {
    JsonObject& difference = differences.emplace_back();
    difference.addText("what", one.what);
    difference.addText("a", one.a);
    difference.addText("b", one.b);
  }
  object.addList("differences", differences);
  out << object.text() << '\n';
}

void printAsTable(record::Session& session, std::ostream& out) {
  const record::SessionInfo& info = session.info();
  const auto row = [&out](const char* what) -> std::ostream& { return out << std::left << std::setw(14) << what; };
  const auto words = [&](const char* what, const std::string& text) {
    if (!text.empty()) row(what) << printed(text) << '\n';
  };
  words("name", info.header.words.name);
  words("notes", info.header.words.notes);
  words("tags", info.header.words.tags);
  words("subject", info.header.words.subject);
  words("consent", info.header.words.consent.empty() ? "not recorded" : info.header.words.consent);
  row("started") << startedAt(info) << '\n';
  row("ticks") << info.ticks << " at " << info.header.rate_hz << " Hz\n";
  row("duration") << info.duration_s << " s\n";
  row("closed") << (info.isComplete() ? record::name(info.end->reason)
                                      : "no: being recorded, or killed; see log recover")
                << '\n';
  if (info.dropped > 0) row("dropped") << info.dropped << " ticks\n";
  row("scene") << printed(info.header.scene_title) << ", "
               << session.changes().size() - std::min<std::size_t>(session.changes().size(), 1) << " edits\n";
  row("arm") << printed(info.header.arm) << '\n';
  row("device") << printed(info.header.device) << '\n';
  words("hand", runWord(session, {"run", "hand", "name"}));
  words("seed", runWord(session, {"run", "seed"}));
  words("arm model", runWord(session, {"run", "arm_model", "name"}));
  row("scheduling") << printed(schedulingOf(session)) << '\n';
  row("version") << printed(info.program_version) << '\n';
  words("build", runWord(session, {"program", "build_id"}));
  row("size") << info.bytes << " bytes\n";
  for (const servo::FaultMark& mark : stops(session)) {
    row("fault") << "tick " << mark.tick << ": " << whatHappened(mark.fault) << '\n';
  }
  for (const record::Marker& marker : session.markers())
    row("marker") << "tick " << marker.tick << ": " << printed(marker.label) << '\n';
}

}  // namespace underact::cli
