#include "app/cli/session_table.h"

#include <algorithm>
#include <iomanip>
#include <ostream>

#include "app/cli/json_object.h"
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

}  // namespace

void printAsJson(record::Session& session, std::ostream& out) {
  const record::SessionInfo& info = session.info();
  JsonObject object;
  object.addText("file", info.path);
  object.addText("name", info.header.words.name);
  object.addText("notes", info.header.words.notes);
  object.addText("tags", info.header.words.tags);
  object.addText("subject", info.header.words.subject);
  object.addText("consent", info.header.words.consent);
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
  object.addText("scheduling", info.header.scheduling);
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
  out << object.text() << '\n';
}

void printAsTable(record::Session& session, std::ostream& out) {
  const record::SessionInfo& info = session.info();
  const auto row = [&out](const char* what) -> std::ostream& { return out << std::left << std::setw(14) << what; };
  const auto words = [&](const char* what, const std::string& text) {
    if (!text.empty()) row(what) << text << '\n';
  };
  words("name", info.header.words.name);
  words("notes", info.header.words.notes);
  words("tags", info.header.words.tags);
  words("subject", info.header.words.subject);
  row("consent") << (info.header.words.consent.empty() ? "not recorded" : info.header.words.consent) << '\n';
  row("started") << startedAt(info) << '\n';
  row("ticks") << info.ticks << " at " << info.header.rate_hz << " Hz\n";
  row("duration") << info.duration_s << " s\n";
  row("closed") << (info.isComplete() ? record::name(info.end->reason)
                                      : "no: being recorded, or killed; see log recover")
                << '\n';
  if (info.dropped > 0) row("dropped") << info.dropped << " ticks\n";
  row("scene") << info.header.scene_title << ", "
               << session.changes().size() - std::min<std::size_t>(session.changes().size(), 1) << " edits\n";
  row("arm") << info.header.arm << '\n';
  row("device") << info.header.device << '\n';
  row("scheduling") << info.header.scheduling << '\n';
  row("version") << info.program_version << '\n';
  row("size") << info.bytes << " bytes\n";
  for (const servo::FaultMark& mark : stops(session)) {
    row("fault") << "tick " << mark.tick << ": " << whatHappened(mark.fault) << '\n';
  }
  for (const record::Marker& marker : session.markers())
    row("marker") << "tick " << marker.tick << ": " << marker.label << '\n';
}

}  // namespace underact::cli
