#include "core/record/session_writer.h"

#include <underact/version.h>

#include <array>
#include <memory>
#include <utility>

#include "core/arm/model.h"
#include "core/record/provenance.h"
#include "core/record/state_bytes.h"
#include "core/record/untrusted_file.h"
#include "core/scene/load_meshes.h"
#include "core/scene/scene_arm.h"
#include "core/scene/write.h"

namespace underact::record {
namespace {

std::vector<Attribute> attributesOf(const SessionHeader& header) {
  return {{"underact_session", kSessionVersion},
          {"program_version", std::string(kVersion)},
          {"name", header.words.name},
          {"notes", header.words.notes},
          {"tags", header.words.tags},
          {"subject", header.words.subject},
          {"consent", header.words.consent},
          {"scene_title", header.scene_title},
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
          {"start_layout", stateLayout()}};
}

void keep(Problems& problems, const Problems& more) {
  problems.insert(problems.end(), more.begin(), more.end());
}

/// Whether it is a continuation byte of UTF-8.
bool isWithinLetter(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

}  // namespace

SessionWriter::SessionWriter(Hdf5File file, const SessionHeader& header)
    : file_(std::move(file)),
      geometry_(scene::armOf({}).geometry),
      block_rows_(sessionTables(header.rate_hz, header.block_s)[kTicks].block_rows),
      packer_(tickColumns()),
      truths_(sessionTables(header.rate_hz)[kTruth].columns),
      constraints_(sessionTables(header.rate_hz)[kConstraints].columns),
      joints_(jointColumns()),
      provenance_(header.provenance) {
  packer_.begin(block_rows_);
  truths_.begin(block_rows_);
  constraints_.begin(block_rows_);
  joints_.begin(block_rows_);
}

Result<SessionWriter> SessionWriter::create(const std::string& path, const SessionHeader& header,
                                            system::Existing existing) {
  std::array tables = sessionTables(header.rate_hz, header.block_s);
  tables[kTruth].is_made = tables[kConstraints].is_made = header.details;
  Result<Hdf5File> file = Hdf5File::create(path, attributesOf(header), tables, existing);
  if (!file) return file.problems();
  return SessionWriter(std::move(file).value(), header);
}

Words SessionWriter::addText(std::string_view text, Problems& problems) {
  const Words words{text_bytes_, static_cast<std::int64_t>(text.size())};
  const Block block = textBlock(text);
  keep(problems, file_.append(kText, block));
  text_bytes_ += block.rows;
  return words;
}

Problems SessionWriter::addScene(std::int64_t tick, std::uint64_t revision, tick::Carry carry,
                                 const scene::Description& scene) {
  Problems problems;
  const Words words =
      addText(scene.constraints.empty() ? std::string() : scene::writeScene(scene::withoutFolders(scene)), problems);
  keep(problems, file_.append(kChanges, blockOf(ChangeRow{tick, revision, carry, words})));
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
  keep(problems, file_.append(kProvenance, blockOf(ProvenanceRow{tick, words})));
  return problems;
}

/// Writes the rows of a packer once it is full.
Problems SessionWriter::writeFull(Packer& packer, TableIndex table) {
  if (!packer.isFull()) return {};
  Problems problems = file_.append(table, packer.block());
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
  return file_.append(kClock, blockOf(row));
}

Problems SessionWriter::begin(std::int64_t tick, std::uint64_t revision, const tick::TickState& state,
                              const scene::Description& scene) {
  Block start{0, bytesOfState(state)};
  start.rows = static_cast<std::int64_t>(start.bytes.size());
  Problems problems = file_.append(kStart, start);
  keep(problems, addScene(tick, revision, tick::Carry::Arm, scene));
  keep(problems, file_.flush());
  return problems;
}

Problems SessionWriter::add(const servo::Change& change, const scene::Description& scene) {
  Problems problems;
  if (change.over_ticks > 0)
    problems = file_.append(
        kSteering, blockOf(SteeringRow{change.tick, Steering::Move, change.revision, change.over_ticks, Vec3::Zero()}));
  keep(problems, addScene(change.tick, change.revision, change.carry, scene));
  return problems;
}

/// From the first tick of an arm of more than six joints on, /joints has a row for each tick, and its blocks are those
/// of /ticks.
void SessionWriter::addMoreJoints(const servo::TickRecord& record) {
  if (!has_joints_ && record.joints <= 6) return;
  if (!std::exchange(has_joints_, true)) {
    for (const servo::TickRecord& before : unpackTicks(packer_.block())) packMoreJoints(before, joints_);
  }
  packMoreJoints(record, joints_);
}

Problems SessionWriter::add(const servo::TickRecord& record) {
  for (; !arms_.empty() && arms_.front().first <= record.tick; arms_.pop_front()) geometry_ = arms_.front().second;
  addMoreJoints(record);
  pack(record, geometry_, packer_);
  last_tick_ = record.tick;
  ++ticks_;
  return packer_.isFull() ? writeTicks() : Problems{};
}

Problems SessionWriter::add(const servo::FaultMark& fault) {
  return file_.append(kFaults, blockOf(fault));
}

Problems SessionWriter::add(const servo::Push& push) {
  return file_.append(kSteering, blockOf(SteeringRow{push.tick, Steering::Push, 0, push.ticks, push.f_T_W}));
}

Problems SessionWriter::mark(std::int64_t tick, std::string_view label) {
  Problems problems;
  if (label.size() > kLongestLabel) {
    auto end = static_cast<std::size_t>(kLongestLabel);
    while (end > 0 && isWithinLetter(label[end])) --end;
    label = label.substr(0, end);
  }
  const Words words = addText(label, problems);
  keep(problems, file_.append(kMarkers, blockOf(MarkerRow{tick, words})));
  return problems;
}

Problems SessionWriter::writeTicks() {
  Problems problems = file_.append(kJoints, joints_.block());  // first: a tick without its joints cannot be replayed
  joints_.begin(block_rows_);
  keep(problems, file_.append(kTicks, packer_.block()));
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
    keep(problems, file_.append(kTruth, truths_.block()));
    keep(problems, file_.append(kConstraints, constraints_.block()));
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
  for (const auto& [name, text] :
       {std::pair{"name", &words.name}, std::pair{"notes", &words.notes}, std::pair{"tags", &words.tags},
        std::pair{"subject", &words.subject}, std::pair{"consent", &words.consent}}) {
    keep(problems, file.value().set({name, *text}));
  }
  keep(problems, file.value().close());
  return problems;
}

}  // namespace underact::record
