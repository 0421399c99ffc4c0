#include "core/record/session_writer.h"

#include <underact/version.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <utility>

#include "core/arm/model.h"
#include "core/base/translate.h"
#include "core/record/provenance.h"
#include "core/record/state_bytes.h"
#include "core/record/untrusted_file.h"
#include "core/scene/load_meshes.h"
#include "core/scene/scene_arm.h"
#include "core/scene/write.h"

namespace underact::record {
namespace {

constexpr std::int64_t kUntilALaterRow = std::int64_t{1} << 40;  // ticks

/// Whether it is a continuation byte of UTF-8.
bool isWithinLetter(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

/// At most so many bytes of a text, up to the end of a character.
std::string_view beginningOf(std::string_view text, std::int64_t max_bytes) {
  auto end = static_cast<std::size_t>(max_bytes);
  if (text.size() <= end) return text;
  while (end > 0 && isWithinLetter(text[end])) --end;
  return text.substr(0, end);
}

std::vector<Attribute> attributesOf(const SessionHeader& header) {
  std::vector<Attribute> all{{"underact_session", kSessionVersion}, {"program_version", std::string(kVersion)}};
  for (const auto& [name, text] : kMetadata) all.push_back({name, header.words.*text});
  all.insert(all.end(), {{"scene_title", header.scene_title},
                         {"arm", header.arm},
                         {"arm_file", header.arm_file},
                         {"device", header.device},
                         {"scheduling", header.scheduling},
                         {"started_unix_ns", header.started_unix_ns},
                         {"rate_hz", header.rate_hz},
                         {"frozen_s", header.frozen_s},
                         {"max_late", std::int64_t{header.max_late}},
                         {"gate_time", std::string(header.gate_time == GateTime::Servo ? kServosTime : kArmsTime)},
                         {"force_share", header.force_share},
                         {"session_id", header.session_id},
                         {"start_layout", stateLayout()}});
  for (Attribute& one : all) {
    if (auto* const text = std::get_if<std::string>(&one.value))
      text->resize(beginningOf(*text, kSessionLimits.attribute_bytes).size());
  }
  return all;
}

void keep(Problems& problems, const Problems& more) {
  problems.insert(problems.end(), more.begin(), more.end());
}

/// The first tick without it; a session that is run again may hold any two numbers.
std::int64_t endOf(const servo::Push& push) {
  return push.tick > 0 && push.ticks > INT64_MAX - push.tick ? INT64_MAX : push.tick + push.ticks;
}

bool isSameForce(const Vec3& a, const Vec3& b) {
  return std::memcmp(a.data(), b.data(), sizeof(double) * 3) == 0;  // to the bit, as a replay has it
}

}  // namespace

SessionWriter::SessionWriter(Hdf5File file, const SessionHeader& header, const SessionLimits& limits)
    : file_(std::move(file)),
      geometry_(scene::armOf({}).geometry),
      block_rows_(sessionTables(header.rate_hz, header.block_s)[kTicks].block_rows),
      packer_(tickColumns()),
      truths_(kColumns<servo::TruthRow>),
      constraints_(kColumns<servo::ConstraintRow>),
      joints_(kColumns<JointsRow>),
      provenance_(header.provenance),
      limits_(limits) {
  packer_.begin(block_rows_);
  truths_.begin(block_rows_);
  constraints_.begin(block_rows_);
  joints_.begin(block_rows_);
}

Result<SessionWriter> SessionWriter::create(const std::string& path, const SessionHeader& header,
                                            system::Existing existing, const SessionLimits& limits) {
  std::array tables = sessionTables(header.rate_hz, header.block_s);
  tables[kTruth].is_made = tables[kConstraints].is_made = header.details;
  Result<Hdf5File> file = Hdf5File::create(path, attributesOf(header), tables, existing);
  if (!file) return file.problems();
  return SessionWriter(std::move(file).value(), header, limits);
}

Problems SessionWriter::limitMet(TableIndex table) {
  is_at_limit_ = true;
  return {{phrase(TRANSLATE_NOOP("problem",
                                 "The recording was stopped: its table \"%1\" is as long as that of a session may be. "
                                 "Everything up to then was saved."),
                  {std::string(sessionTables(1000)[table].name)}),
           {}}};
}

Problems SessionWriter::append(TableIndex table, const Block& block) {
  if (block.rows > limits_.rowsOf(table) - rows_[table]) return limitMet(table);
  Problems problems = file_.append(table, block);
  if (problems.empty()) rows_[table] += block.rows;
  return problems;
}

double SessionWriter::fill() const {
  const auto share = [](std::int64_t part, std::int64_t all) {
    return static_cast<double>(part) / static_cast<double>(all);
  };
  double max = std::max(share(label_bytes_, limits_.all_label_bytes), share(ticks_, limits_.ticks));
  for (std::size_t table = 0; table < kTables; ++table) {
    if (table != kEnd && table != kStart)
      max = std::max(max, share(rows_[table], limits_.rowsOf(static_cast<TableIndex>(table))));
  }
  return max;
}

bool SessionWriter::hasRoomFor(std::string_view label) const {
  return rows_[kMarkers] < limits_.markers &&
         static_cast<std::int64_t>(cut(label).size()) <= limits_.all_label_bytes - label_bytes_;
}

std::string_view SessionWriter::cut(std::string_view label) const {
  return beginningOf(label, limits_.label_bytes);
}

Words SessionWriter::addText(std::string_view text, Problems& problems) {
  if (static_cast<std::int64_t>(text.size()) > limits_.text_bytes) problems = limitMet(kText);
  if (is_at_limit_) text = {};
  const Words words{text_bytes_, static_cast<std::int64_t>(text.size())};
  const Block block = textBlock(text);
  keep(problems, append(kText, block));
  text_bytes_ += block.rows;
  return words;
}

Problems SessionWriter::addScene(std::int64_t tick, std::uint64_t revision, tick::Carry carry,
                                 const scene::Description& scene) {
  Problems problems;
  const Words words =
      addText(scene.constraints.empty() ? std::string() : scene::writeScene(scene::withoutFolders(scene)), problems);
  keep(problems, append(kChanges, blockOf(ChangeRow{tick, revision, carry, words})));
  if (!scene.constraints.empty()) arms_.emplace_back(tick, scene::armOf(scene).geometry);
  const json::ObjectText by_scene = sceneProvenance(scene);
  if (std::exchange(by_scene_, by_scene.text()) == by_scene.text()) return problems;
  json::ObjectText all = std::exchange(provenance_, {});  // all of it with the first scene
  all.addAll(by_scene);
  keep(problems, addProvenance(tick, all));
  return problems;
}

Problems SessionWriter::addProvenance(std::int64_t tick, const json::ObjectText& changed) {
  Problems problems;
  const Words words = addText(changed.text(), problems);
  keep(problems, append(kProvenance, blockOf(ProvenanceRow{tick, words})));
  return problems;
}

/// Writes the rows of a packer once it is full.
Problems SessionWriter::writeFull(Packer& packer, TableIndex table) {
  if (!packer.isFull()) return {};
  Problems problems = append(table, packer.block());
  packer.begin(block_rows_);
  return problems;
}

Problems SessionWriter::add(const servo::TruthRow& row) {
  pack(row, truths_);
  return writeFull(truths_, kTruth);
}

Problems SessionWriter::add(const servo::ConstraintRow& row) {
  pack(row, constraints_);
  return writeFull(constraints_, kConstraints);
}

Problems SessionWriter::add(const ClockRow& row) {
  return append(kClock, blockOf(row));
}

Problems SessionWriter::begin(std::int64_t tick, std::uint64_t revision, const tick::TickState& state,
                              const scene::Description& scene) {
  Block start{0, bytesOfState(state)};
  start.rows = static_cast<std::int64_t>(start.bytes.size());
  Problems problems = append(kStart, start);
  keep(problems, addScene(tick, revision, tick::Carry::Arm, scene));
  keep(problems, file_.flush());
  return problems;
}

Problems SessionWriter::add(const servo::Change& change, const scene::Description& scene) {
  Problems problems;
  if (change.over_ticks > 0)
    problems = append(
        kSteering, blockOf(SteeringRow{change.tick, Steering::Move, change.revision, change.over_ticks, Vec3::Zero()}));
  keep(problems, addScene(change.tick, change.revision, change.carry, scene));
  return problems;
}

/// From the first tick of an arm of more than six joints on, /joints has a row for each tick, and its blocks are those
/// of /ticks.
void SessionWriter::addMoreJoints(const servo::TickRecord& record) {
  if (!has_joints_ && record.joints <= 6) return;
  if (!std::exchange(has_joints_, true)) {
    for (const servo::TickRecord& before : unpackTicks(packer_.block())) pack(JointsRow{before.tick}, joints_);
  }
  JointsRow row{record.tick};
  std::copy(record.q_rad.begin() + kJointsOfTicks, record.q_rad.end(), row.q.begin());
  pack(row, joints_);
}

Problems SessionWriter::add(const servo::TickRecord& record) {
  Problems problems = endPush(record.tick);
  for (; !arms_.empty() && arms_.front().first <= record.tick; arms_.pop_front()) geometry_ = arms_.front().second;
  addMoreJoints(record);
  pack(record, geometry_, packer_);
  last_tick_ = record.tick;
  ++ticks_;
  if (packer_.isFull()) keep(problems, writeTicks());
  return problems;
}

Problems SessionWriter::add(const servo::FaultMark& fault) {
  return append(kFaults, blockOf(fault));
}

/// Ends a force whose row does not say when, once the ticks get there.
Problems SessionWriter::endPush(std::int64_t tick) {
  if (written_push_ends_ == push_ends_ || push_ends_ > tick) return {};
  return addPush({push_ends_, Vec3::Zero(), 0});
}

Problems SessionWriter::add(const servo::Push& push) {
  Problems problems;
  if (push_ends_ < push.tick) problems = endPush(push.tick);
  const bool acts = push_ends_ >= push.tick;  // up to this tick at least
  if (push.ticks == 0 && push_ends_ <= push.tick && written_push_ends_ == push_ends_) return problems;
  if (!acts || push.ticks == 0 || !isSameForce(push.f_T_W, push_.f_T_W)) {
    keep(problems, addPush(push));
    return problems;
  }
  const std::int64_t ends = endOf(push);
  if (written_push_ends_ < ends) keep(problems, addPush({push.tick, push.f_T_W, kUntilALaterRow}));
  push_ends_ = ends;
  return problems;
}

Problems SessionWriter::addPush(const servo::Push& push) {
  push_ = push;
  push_ends_ = written_push_ends_ = endOf(push);
  return append(kSteering, blockOf(SteeringRow{push.tick, Steering::Push, 0, push.ticks, push.f_T_W}));
}

Problems SessionWriter::mark(std::int64_t tick, std::string_view label) {
  if (!hasRoomFor(label)) return limitMet(kMarkers);
  Problems problems;
  label = cut(label);
  label_bytes_ += static_cast<std::int64_t>(label.size());
  const Words words = addText(label, problems);
  keep(problems, append(kMarkers, blockOf(MarkerRow{tick, words})));
  return problems;
}

Problems SessionWriter::writeTicks() {
  Problems problems = append(kJoints, joints_.block());  // first: a tick without its joints cannot be replayed
  joints_.begin(block_rows_);
  keep(problems, append(kTicks, packer_.block()));
  packer_.begin(block_rows_);
  unflushed_ = true;
  return problems;
}

Problems SessionWriter::flush() {
  return std::exchange(unflushed_, false) ? file_.flush() : Problems{};
}

Problems SessionWriter::end(const EndRow& row) {
  Problems problems;
  if (!file_.isFull()) {
    keep(problems, append(kTruth, truths_.block()));
    keep(problems, append(kConstraints, constraints_.block()));
    keep(problems, writeTicks());
  }
  EndRow last = row;
  last.tick = last_tick_;
  keep(problems, file_.appendLast(kEnd, blockOf(last)));
  keep(problems, file_.close());
  return problems;
}

Problems rewriteMetadata(const std::string& path, const SessionMetadata& words) {
  // The file may come from anybody: it is checked in the sealed reader first, and then exactly that file is changed.
  Result<UntrustedInput> opened = UntrustedInput::open(path, false);
  if (!opened) return opened.problems();
  const auto input = std::make_shared<const UntrustedInput>(std::move(opened).value());
  const std::array tables = sessionTables(1000);
  {
    const Result<UntrustedFile> checked = UntrustedFile::open(input, tables);
    if (!checked) return checked.problems();
  }
  input->unlock();
  Result<Hdf5File> file = Hdf5File::reopen(path, {}, false, input->fd());
  if (!file) return file.problems();
  Problems problems;
  for (const auto& [name, text] : kMetadata) keep(problems, file.value().set({name, words.*text}));
  keep(problems, file.value().close());
  return problems;
}

}  // namespace underact::record
