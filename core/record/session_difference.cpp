#include "core/record/session_difference.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "core/record/replay.h"

namespace underact::record {
namespace {

/// Paths with their values, in the order in which the sessions say them.
class Facts {
 public:
  void add(const std::string& path, std::string value) {
    if (values_.emplace(path, std::move(value)).second) order_.push_back(path);
  }
  void add(const std::string& path, const json::Value& value) {
    switch (value.kind) {
      case json::JsonKind::Object:
        for (std::size_t index = 0; index < value.items.size(); ++index)
          add(path.empty() ? value.keys[index] : path + "." + value.keys[index], value.items[index]);
        return;
      case json::JsonKind::Array:
        return addList(path, value);
      default:
        return add(path, textOf(value));
    }
  }
  const std::vector<std::string>& order() const { return order_; }
  std::string at(const std::string& path) const {
    const auto found = values_.find(path);
    return found == values_.end() ? std::string() : found->second;
  }

 private:
  static std::string textOf(const json::Value& value) {
    switch (value.kind) {
      case json::JsonKind::Bool:
        return value.boolean ? "true" : "false";
      case json::JsonKind::Number:
        return json::numberText(value.number);
      case json::JsonKind::String:
        return json::quotedText(value.text);
      default:
        return "null";
    }
  }
  /// Numbers stay together; objects go by their names, so that one more library does not shift all that follow.
  void addList(const std::string& path, const json::Value& list) {
    const bool is_plain = std::all_of(list.items.begin(), list.items.end(), [](const json::Value& one) {
      return one.kind != json::JsonKind::Object && one.kind != json::JsonKind::Array;
    });
    if (is_plain) {
      std::string text;
      for (const json::Value& one : list.items) text += (text.empty() ? "" : ", ") + textOf(one);
      return add(path, "[" + text + "]");
    }
    for (std::size_t index = 0; index < list.items.size(); ++index) {
      const json::Value* name = list.items[index].find("name");
      if (name == nullptr) name = list.items[index].find("constraint");
      const bool is_named = name != nullptr && name->kind == json::JsonKind::String;
      add(path + "[" + (is_named ? name->text : std::to_string(index)) + "]", list.items[index]);
    }
  }
  std::map<std::string, std::string> values_;
  std::vector<std::string> order_;
};

/// What tells two recordings of the same run apart and was not run.
bool isIdentity(const std::string& path) {
  static const std::set<std::string> kPaths{"session", "rerun_of", "rerun_by"};
  return kPaths.count(path) > 0;
}

Problems addProvenance(Session& session, Facts& facts) {
  Problems problems;
  std::size_t later = 0;
  for (const ProvenanceRow& row : session.provenance()) {
    const Result<json::Value> value = session.provenanceOf(row);
    if (!value) return value.problems();
    if (&row == &session.provenance().front()) {
      const json::Value* const original = value.value().find("original");  // of a run made from its input
      facts.add("", original != nullptr ? *original : value.value());
      continue;
    }
    const std::string path = "later[" + std::to_string(later++) + "]";
    facts.add(path, value.value());
  }
  return problems;
}

Problems addScenes(Session& session, Facts& facts) {
  for (std::size_t index = 0; index < session.changes().size(); ++index) {
    const ChangeRow& change = session.changes()[index];
    const Result<std::string> text = session.sceneText(change);
    if (!text) return text.problems();
    const std::string path = index == 0 ? "scene" : "changes[" + std::to_string(index) + "].scene";
    if (index > 0) facts.add("changes[" + std::to_string(index) + "].tick", std::to_string(change.tick));
    if (text.value().empty()) continue;
    const Result<json::Value> scene = json::parse(text.value(), session.info().path);
    if (!scene) return scene.problems();
    facts.add(path, scene.value());
  }
  return {};
}

void addHeader(const Session& session, Facts& facts) {
  const SessionInfo& info = session.info();
  const SessionHeader& header = info.header;
  facts.add("program_version", json::quotedText(info.program_version));
  facts.add("subject", json::quotedText(header.words.subject));
  facts.add("consent", json::quotedText(header.words.consent));
  facts.add("arm", json::quotedText(header.arm));
  facts.add("device", json::quotedText(header.device));
  facts.add("rate_hz", std::to_string(header.rate_hz));
  facts.add("frozen_s", json::numberText(header.frozen_s));
  facts.add("max_late", std::to_string(header.max_late));
  facts.add("force_share", json::numberText(header.force_share));
  facts.add("gate_time", header.gate_time == GateTime::Servo ? "\"servo\"" : "\"arm\"");
  facts.add("ticks", std::to_string(info.ticks));
  facts.add("first_tick", session.changes().empty() ? "" : std::to_string(session.changes().front().tick));
  facts.add("faults", std::to_string(session.faults().size()));
}

/// The whole of what a session says of its run. by_provenance: one of an earlier version says nothing beyond its header
/// and scenes, and is compared by these.
Result<Facts> factsOf(Session& session, bool by_provenance) {
  Facts facts;
  Problems problems = by_provenance ? addProvenance(session, facts) : Problems{};
  if (problems.empty()) problems = addScenes(session, facts);
  if (!problems.empty()) return problems;
  addHeader(session, facts);
  return facts;
}

/// Rows of a session one after the other, across its blocks.
class Rows {
 public:
  explicit Rows(Session& session) : session_(session) {}
  /// The next one; none: the end, or a damaged block.
  std::optional<servo::TickRecord> next() {
    if (at_ == rows_.size()) {
      const Result<std::vector<Block>> blocks = session_.readTicks(block_++, 1);
      if (!blocks || blocks.value().empty() || blocks.value().front().bytes.empty()) return {};
      rows_ = unpackTicks(blocks.value().front());
      at_ = 0;
    }
    return rows_[at_++];
  }

 private:
  Session& session_;
  std::int64_t block_ = 0;
  std::vector<servo::TickRecord> rows_;
  std::size_t at_ = 0;
};

Block packedTick(const servo::TickRecord& record) {
  static const arm::Geometry kGeometry = arm::findPreset(arm::kDefaultArm)->geometry;  // the joints say the same
  Packer packer(tickColumns(true));
  packer.begin(1);
  pack(record, kGeometry, packer, true);
  return packer.block();
}

/// The first tick that differs, by its column.
void addTicks(Session& a, Session& b, std::vector<SessionDifference>& found) {
  Rows rows_a(a), rows_b(b);
  for (;;) {
    const std::optional<servo::TickRecord> one = rows_a.next(), other = rows_b.next();
    if (!one || !other) return;  // how many there are is told already
    const auto difference = differenceOf(packedTick(*one), packedTick(*other));
    if (!difference) continue;
    found.push_back({"ticks." + difference->column, "first differs at tick " + std::to_string(one->tick),
                     "first differs at tick " + std::to_string(other->tick)});
    return;
  }
}

}  // namespace

Result<std::vector<SessionDifference>> differencesBetween(Session& a, Session& b) {
  const bool has_a = !a.provenance().empty(), has_b = !b.provenance().empty();
  const Result<Facts> facts_a = factsOf(a, has_a && has_b), facts_b = factsOf(b, has_a && has_b);
  if (!facts_a) return facts_a.problems();
  if (!facts_b) return facts_b.problems();
  std::vector<std::string> order = facts_a.value().order();
  for (const std::string& path : facts_b.value().order()) {
    if (facts_a.value().at(path).empty()) order.push_back(path);
  }
  std::vector<SessionDifference> found;
  if (has_a != has_b) found.push_back({"provenance", has_a ? "recorded" : "", has_b ? "recorded" : ""});
  for (const std::string& path : order) {
    std::string one = facts_a.value().at(path), other = facts_b.value().at(path);
    if (one != other && !isIdentity(path)) found.push_back({path, std::move(one), std::move(other)});
  }
  addTicks(a, b, found);
  return found;
}

}  // namespace underact::record
