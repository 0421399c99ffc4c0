#include "core/record/session.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "core/base/translate.h"
#include "core/base/units.h"
#include "core/record/state_bytes.h"
#include "core/scene/read.h"

namespace underact::record {
namespace {

constexpr std::int64_t kBlocksAtOnce = 64;
constexpr std::int64_t kRowsAtOnce = 4096;          // of a small table
constexpr std::int64_t kLongestWords = 64LL << 20;  // bytes of one text

Problems damagedAt(const std::string& path, Sentence what) {
  return {{std::move(what), {path}}};
}

std::string textOf(const std::vector<Block>& blocks, std::size_t skip, std::size_t bytes) {
  std::string text;
  for (const Block& block : blocks) {
    for (const std::byte one : block.bytes) text.push_back(static_cast<char>(one));
  }
  return skip < text.size() ? text.substr(skip, bytes) : std::string();
}

bool isAnyDamaged(const std::vector<Block>& blocks) {
  return std::any_of(blocks.begin(), blocks.end(), [](const Block& block) { return block.bytes.empty(); });
}

}  // namespace

Result<Session> Session::open(const std::string& path) {
  const std::array tables = sessionTables(1000);  // how many rows a block has is read from the file
  Result<Hdf5File> file = Hdf5File::open(path, tables);
  if (!file) return file.problems();
  Session session(std::move(file).value());
  Problems problems = session.readInfo(path);
  if (!problems.empty()) return problems;
  session.readSmallTables();
  return session;
}

Problems Session::readInfo(const std::string& path) {
  const std::int64_t version = file_.integer("underact_session", 0);
  if (version < 1)
    return {{said(QT_TRANSLATE_NOOP("problem", "This is an HDF5 file, and no session of Underact.")), {path}}};
  if (version > kSessionVersion)
    return {{said(QT_TRANSLATE_NOOP(
                 "problem", "This session was recorded by a newer version of Underact. This one reads layout 1.")),
             {path}}};
  info_.path = path;
  info_.program_version = file_.text("program_version");
  SessionHeader& header = info_.header;
  header.words = {file_.text("name"), file_.text("notes"), file_.text("tags"), file_.text("subject"),
                  file_.text("consent")};
  header.scene_title = file_.text("scene_title");
  header.arm = file_.text("arm");
  header.device = file_.text("device");
  header.scheduling = file_.text("scheduling");
  header.started_unix_ns = file_.integer("started_unix_ns", 0);
  header.rate_hz = file_.integer("rate_hz", 0);
  header.frozen_s = file_.real("frozen_s", 0.0);
  header.max_late = static_cast<int>(file_.integer("max_late", 20));
  header.gate_time = file_.text("gate_time") == kServosTime ? GateTime::Servo : GateTime::Arm;
  if (header.rate_hz < 1 || header.rate_hz > 1'000'000)
    return {
        {said(QT_TRANSLATE_NOOP("problem", "This session does not say how fast the servo was: the file is damaged.")),
         {path}}};
  return {};
}

template <class Row>
std::vector<Row> Session::rowsOf(TableIndex table, std::vector<Row> (*unpack)(const Block&)) {
  std::vector<Row> rows;
  for (std::int64_t at = 0;; at += kRowsAtOnce) {
    Result<std::vector<Block>> blocks = file_.read(table, at, kRowsAtOnce);
    if (!blocks || isAnyDamaged(blocks.value())) {
      const Problems problems =
          damagedAt(info_.path,
                    said(QT_TRANSLATE_NOOP(
                             "problem", "The table \"%1\" of this session cannot be read: the file is damaged there."),
                         {std::string(sessionTables(1000)[table].name)}));
      info_.damage.insert(info_.damage.end(), problems.begin(), problems.end());
    }
    if (!blocks || blocks.value().empty()) return rows;
    for (const Block& block : blocks.value()) {
      if (block.bytes.empty()) continue;
      const std::vector<Row> more = unpack(block);
      rows.insert(rows.end(), more.begin(), more.end());
    }
  }
}

void Session::readSmallTables() {
  info_.damage.clear();
  info_.ticks = file_.rows(kTicks);
  std::error_code error;
  const auto bytes = std::filesystem::file_size(info_.path, error);
  info_.bytes = error ? 0 : static_cast<std::int64_t>(bytes);
  changes_ = rowsOf(kChanges, unpackChanges);
  faults_ = rowsOf(kFaults, unpackFaults);
  markers_.clear();
  for (const MarkerRow& row : rowsOf(kMarkers, unpackMarkers)) {
    Result<std::string> label = words(row.label);
    if (!label) info_.damage.push_back(label.problems().front());
    markers_.push_back({row.tick, label ? label.value() : std::string("?")});
  }
  const std::vector<EndRow> end = rowsOf(kEnd, unpackEnd);
  info_.end = end.empty() ? std::nullopt : std::optional(end.back());
  info_.dropped = end.empty() ? 0 : end.back().dropped;
  info_.duration_s = 0.0;
  if (info_.ticks == 0) return;
  const Result<std::vector<Block>> first = readTicks(0, 1), last = readTicks(blocks() - 1, 1);
  const double by_count_s = static_cast<double>(info_.ticks - 1) / static_cast<double>(info_.header.rate_hz);
  info_.duration_s = by_count_s;
  if (!first || !last || isAnyDamaged(first.value()) || isAnyDamaged(last.value())) return;
  const double by_clock_s =
      kSecondPerNanosecond * static_cast<double>(unpackTicks(last.value().back()).back().time_ns -
                                                 unpackTicks(first.value().front()).front().time_ns);
  if (by_clock_s > by_count_s) info_.duration_s = by_clock_s;  // it is less where an arm was opened anew
}

Result<std::string> Session::words(const Words& words) {
  const auto damaged = [this] {
    return damagedAt(
        info_.path,
        said(QT_TRANSLATE_NOOP("problem", "The words of this session cannot be read: the file is damaged there.")));
  };
  if (words.bytes == 0) return std::string();
  if (words.at < 0 || words.bytes < 0 || words.bytes > kLongestWords || words.at > file_.rows(kText)) return damaged();
  const std::int64_t first = words.at / kTextBlock;
  const std::int64_t last = (words.at + words.bytes - 1) / kTextBlock;
  Result<std::vector<Block>> blocks = file_.read(kText, first, last - first + 1);
  if (!blocks || isAnyDamaged(blocks.value())) return damaged();
  std::string text = textOf(blocks.value(), static_cast<std::size_t>(words.at - first * kTextBlock),
                            static_cast<std::size_t>(words.bytes));
  if (text.size() != static_cast<std::size_t>(words.bytes)) return damaged();
  return text;
}

Result<std::string> Session::sceneText(const ChangeRow& change) {
  return words(change.scene);
}

Result<scene::Description> Session::scene(const ChangeRow& change) {
  Result<std::string> text = words(change.scene);
  if (!text) return text.problems();
  if (text.value().empty()) return scene::Description{};
  return scene::readScene(text.value(), info_.path);
}

Result<tick::TickState> Session::start(const tick::TickProgram& program) {
  if (file_.text("start_layout") != stateLayout())
    return Problems{
        {said(QT_TRANSLATE_NOOP(
             "problem",
             "The servo's memory at the beginning was recorded by a version that lays it out in another way.")),
         {info_.path}}};
  const std::int64_t all = (file_.rows(kStart) + kStartBlock - 1) / kStartBlock;
  Result<std::vector<Block>> blocks = file_.read(kStart, 0, all);
  if (!blocks || isAnyDamaged(blocks.value()))
    return damagedAt(
        info_.path,
        said(QT_TRANSLATE_NOOP(
            "problem",
            "The servo's memory at the beginning of this session cannot be read: the file is damaged there.")));
  std::vector<std::byte> bytes;
  for (const Block& block : blocks.value()) bytes.insert(bytes.end(), block.bytes.begin(), block.bytes.end());
  return stateOfBytes(bytes, program);
}

Result<std::vector<Block>> Session::readTicks(std::int64_t first_block, std::int64_t count) {
  return file_.read(kTicks, first_block, count);
}

Problems Session::eachBlock(const std::function<bool(const Block&, std::int64_t)>& visit,
                            const std::function<void(const Gap&)>& damaged,
                            const std::function<void(double)>& progress) {
  const std::int64_t all = blocks();
  for (std::int64_t first = 0; first < all; first += kBlocksAtOnce) {
    Result<std::vector<Block>> read = readTicks(first, kBlocksAtOnce);
    if (!read) return read.problems();
    std::int64_t row = first * blockRows();
    for (const Block& block : read.value()) {
      if (block.bytes.empty()) {
        damaged({row, block.rows});
      } else if (!visit(block, row)) {
        return {};
      }
      row += block.rows;
    }
    if (progress) progress(std::min(1.0, static_cast<double>(first + kBlocksAtOnce) / static_cast<double>(all)));
  }
  return {};
}

void Session::refresh() {
  file_.refresh();
  readSmallTables();
}

}  // namespace underact::record
