#include "core/record/session.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <utility>

#include "core/base/translate.h"
#include "core/base/units.h"
#include "core/record/state_bytes.h"
#include "core/scene/read.h"

namespace underact::record {
namespace {

constexpr std::int64_t kBytesAtOnce = 8LL << 20;  // at least one block
constexpr std::int64_t kBlocksAtOnce = 64;
constexpr std::int64_t kRowsAtOnce = 4096;  // of a small table
constexpr std::int64_t kMaxLate = 1'000'000;
constexpr std::int64_t kMaxGaps = 100'000;  // damaged blocks, adjacent or not

Problems damagedAt(const std::string& path, Sentence what) {
  return {{std::move(what), {path}}};
}

/// Texts are adjacent in their table, so all together are no longer than it; one that is not within it is dropped.
/// left: the bytes that remain for later ones.
void keepWithin(std::int64_t all, std::int64_t longest, std::int64_t& left, Words& words) {
  const bool is_within = words.bytes >= 0 && words.bytes <= longest && words.at >= 0 && words.at <= all &&
                         words.bytes <= all - words.at && words.bytes <= left;
  if (is_within) {
    left -= words.bytes;
  } else {
    words = {-1, -1};
  }
}

/// The number of a tick, which is the first column.
std::int64_t tickOf(const Block& ticks, std::size_t row) {
  std::int64_t tick = 0;
  std::memcpy(&tick, &ticks.bytes[row * sizeof tick], sizeof tick);
  return tick;
}

bool isAnyDamaged(const std::vector<Block>& blocks) {
  return std::any_of(blocks.begin(), blocks.end(), [](const Block& block) { return block.bytes.empty(); });
}

/// Whether there are blocks: a file that has shrunk may give none.
bool areThere(const std::vector<Block>& blocks) {
  return !blocks.empty() && !isAnyDamaged(blocks);
}

}  // namespace

Result<Session> Session::open(const std::string& path) {
  Result<UntrustedInput> input = UntrustedInput::open(path);
  if (!input) return input.problems();
  return open(std::make_shared<const UntrustedInput>(std::move(input).value()));
}

Result<Session> Session::open(std::shared_ptr<const UntrustedInput> input, std::int64_t at_least) {
  const std::string path = input->path();
  const std::array tables = sessionTables(1000);  // the rows of a block of ticks are read from the file
  Result<UntrustedFile> file = UntrustedFile::open(std::move(input), tables, at_least);
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
    return {{phrase(TRANSLATE_NOOP("problem", "This is an HDF5 file, but not a session of Underact.")), {path}}};
  if (version > kSessionVersion)
    return {{phrase(TRANSLATE_NOOP(
                 "problem", "This session was recorded by a newer version of Underact. This version reads layout 1.")),
             {path}}};
  info_.path = path;
  info_.program_version = file_.text("program_version");
  SessionHeader& header = info_.header;
  for (const auto& [name, text] : kMetadata) header.words.*text = file_.text(name);
  header.scene_title = file_.text("scene_title");
  header.arm = file_.text("arm");
  header.arm_file = file_.text("arm_file");
  header.device = file_.text("device");
  header.scheduling = file_.text("scheduling");
  header.started_unix_ns = file_.integer("started_unix_ns", 0);
  header.rate_hz = file_.integer("rate_hz", 0);
  header.frozen_s = file_.real("frozen_s", 0.0);
  if (!(header.frozen_s >= 0.0 && std::isfinite(header.frozen_s))) header.frozen_s = 0.0;
  header.max_late = static_cast<int>(std::clamp<std::int64_t>(file_.integer("max_late", 20), 0, kMaxLate));
  header.force_share = file_.real("force_share", 1.0);
  if (!(header.force_share >= 0.0 && header.force_share <= 1.0)) header.force_share = 1.0;
  header.session_id = file_.text("session_id");
  header.details = file_.rows(kTruth) > 0 || file_.rows(kConstraints) > 0;
  header.gate_time = file_.text("gate_time") == kServosTime ? GateTime::Servo : GateTime::Arm;
  if (header.rate_hz < 1 || header.rate_hz > 1'000'000)
    return {
        {phrase(TRANSLATE_NOOP("problem", "This session does not state the rate of the servo: the file is damaged.")),
         {path}}};
  return {};
}

Problem Session::unreadable(TableIndex table) const {
  return {
      phrase(TRANSLATE_NOOP("problem", "The table \"%1\" of this session cannot be read: the file is damaged there."),
             {std::string(sessionTables(1000)[table].name)}),
      {info_.path}};
}

template <class Row>
std::vector<Row> Session::rowsOf(TableIndex table) {
  std::vector<Row> rows;
  for (std::int64_t at = 0;; at += kRowsAtOnce) {
    Result<std::vector<Block>> blocks = file_.read(table, at, kRowsAtOnce);
    const bool are_too_many = at >= kSessionLimits.rowsOf(table) && blocks && !blocks.value().empty();
    if (!blocks || are_too_many || isAnyDamaged(blocks.value())) {
      info_.damage.push_back(unreadable(table));
    }
    if (!blocks || are_too_many || blocks.value().empty()) return rows;
    for (const Block& block : blocks.value()) {
      if (block.bytes.empty()) continue;
      const std::vector<Row> more = unpack<Row>(block);
      rows.insert(rows.end(), more.begin(), more.end());
    }
  }
}

void Session::readSmallTables() {
  info_.damage.clear();
  info_.ticks = std::min(file_.rows(kTicks), kSessionLimits.ticks);
  if (info_.ticks < file_.rows(kTicks)) info_.damage.push_back(unreadable(kTicks));
  std::error_code error;
  const auto bytes = std::filesystem::file_size(info_.path, error);
  info_.bytes = error ? 0 : static_cast<std::int64_t>(bytes);
  const std::int64_t all_words = file_.rows(kText);
  std::int64_t words_left = all_words;
  changes_ = rowsOf<ChangeRow>(kChanges);
  for (ChangeRow& change : changes_) keepWithin(all_words, kSessionLimits.text_bytes, words_left, change.scene);
  faults_ = rowsOf<servo::FaultMark>(kFaults);
  readSteering();
  findJoints();
  provenance_ = rowsOf<ProvenanceRow>(kProvenance);
  for (ProvenanceRow& row : provenance_) keepWithin(all_words, kSessionLimits.text_bytes, words_left, row.json);
  clock_ = rowsOf<ClockRow>(kClock);
  markers_.clear();
  words_left = std::min(words_left, kSessionLimits.all_label_bytes);
  for (MarkerRow& row : rowsOf<MarkerRow>(kMarkers)) {
    keepWithin(all_words, kSessionLimits.label_bytes, words_left, row.label);
    Result<std::string> label = words(row.label);
    if (!label) info_.damage.push_back(label.problems().front());
    markers_.push_back({row.tick, label ? label.value() : std::string("?")});
  }
  const std::vector<EndRow> end = rowsOf<EndRow>(kEnd);
  info_.end = end.empty() ? std::nullopt : std::optional(end.back());
  info_.dropped = end.empty() ? 0 : end.back().dropped;
  info_.duration_s = 0.0;
  if (info_.ticks == 0) return;
  const Result<std::vector<Block>> first = readTicks(0, 1), last = readTicks(blocks() - 1, 1);
  const double by_count_s = static_cast<double>(info_.ticks - 1) / static_cast<double>(info_.header.rate_hz);
  info_.duration_s = by_count_s;
  if (!first || !last || !areThere(first.value()) || !areThere(last.value())) return;
  const double by_clock_s =
      kSecondPerNanosecond * (static_cast<double>(unpackTicks(last.value().back()).back().time_ns) -
                              static_cast<double>(unpackTicks(first.value().front()).front().time_ns));
  if (by_clock_s > by_count_s) info_.duration_s = by_clock_s;  // it is less where an arm was reopened
}

/// A number that no servo makes counts as none: what is run again differs then, and says so.
void Session::readSteering() {
  pushes_.clear();
  for (const SteeringRow& row : rowsOf<SteeringRow>(kSteering)) {
    if (row.ticks < 0 || !row.f_T_W.allFinite()) continue;
    if (row.kind == Steering::Push) {
      pushes_.push_back({row.tick, row.f_T_W, row.ticks});
      continue;
    }
    const auto moved = std::find_if(changes_.begin(), changes_.end(),
                                    [&row](const ChangeRow& change) { return change.revision == row.revision; });
    if (moved != changes_.end()) moved->over_ticks = row.ticks;
  }
}

/// The bytes of a table. Problems: some of them are damaged.
Result<std::vector<std::byte>> Session::bytesOf(TableIndex table, std::int64_t begin, std::int64_t end) {
  std::vector<std::byte> bytes;
  const std::int64_t block_rows = file_.blockRows(table), from = begin / block_rows;
  for (std::int64_t at = from; at * block_rows < end; at += kRowsAtOnce) {
    const std::int64_t blocks = std::min(kRowsAtOnce, (end - at * block_rows + block_rows - 1) / block_rows);
    Result<std::vector<Block>> read = file_.read(table, at, blocks);
    if (!read) return read.problems();
    if (!areThere(read.value()))
      return damagedAt(info_.path,
                       phrase(TRANSLATE_NOOP("problem", "The file is damaged, and the rest cannot be read.")));
    for (const Block& block : read.value()) bytes.insert(bytes.end(), block.bytes.begin(), block.bytes.end());
  }
  const auto skip = static_cast<std::size_t>(begin - from * block_rows), count = static_cast<std::size_t>(end - begin);
  if (bytes.size() < skip || bytes.size() - skip < count)
    return damagedAt(info_.path,
                     phrase(TRANSLATE_NOOP("problem", "The file is damaged, and the rest cannot be read.")));
  const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(skip);
  return std::vector<std::byte>(first, first + static_cast<std::ptrdiff_t>(count));
}

Result<std::string> Session::words(const Words& words) {
  if (words.bytes == 0) return std::string();
  Result<std::vector<std::byte>> bytes = Problems{};
  if (words.at >= 0 && words.bytes > 0) bytes = bytesOf(kText, words.at, words.at + words.bytes);
  if (!bytes)
    return damagedAt(
        info_.path,
        phrase(TRANSLATE_NOOP("problem", "The texts of this session cannot be read: the file is damaged there.")));
  return std::string(reinterpret_cast<const char*>(bytes.value().data()), bytes.value().size());
}

Result<std::string> Session::sceneText(const ChangeRow& change) {
  return words(change.scene);
}

Result<std::string> Session::provenanceText(const ProvenanceRow& row) {
  return words(row.json);
}

Result<json::Value> Session::provenanceOf(const ProvenanceRow& row) {
  const Result<std::string> text = words(row.json);
  if (!text) return text.problems();
  return json::parse(text.value(), info_.path);
}

Result<scene::Description> Session::scene(const ChangeRow& change) {
  Result<std::string> text = words(change.scene);
  if (!text) return text.problems();
  if (text.value().empty()) return scene::Description{};
  return scene::readScene(text.value(), info_.path, scene::NamedFiles::Closed);
}

Result<tick::TickState> Session::start(const tick::TickProgram& program) {
  if (file_.text("start_layout") != stateLayout())
    return Problems{
        {phrase(TRANSLATE_NOOP(
             "problem", "The servo's state at the beginning was recorded by a version with a different layout.")),
         {info_.path}}};
  const std::int64_t all = file_.rows(kStart);
  const Result<std::vector<std::byte>> bytes =
      all <= kSessionLimits.start_bytes ? bytesOf(kStart, 0, all) : Result<std::vector<std::byte>>(Problems{});
  if (!bytes)
    return damagedAt(
        info_.path,
        phrase(TRANSLATE_NOOP(
            "problem",
            "The servo's state at the beginning of this session cannot be read: the file is damaged there.")));
  Result<tick::TickState> state = stateOfBytes(bytes.value(), program);
  if (!state) return damagedAt(info_.path, state.problems().front().sentence);
  return state;
}

/// Where /joints begins.
void Session::findJoints() {
  joints_from_ = 0;
  const std::int64_t block_rows = file_.blockRows(kJoints);
  if (!hasMoreJoints() || (file_.rows(kJoints) + block_rows - 1) / block_rows >= blocks()) return;
  const Result<std::vector<Block>> first = file_.read(kJoints, 0, 1);
  if (!first || !areThere(first.value())) return;
  // Its rows begin with the block of ticks in which such an arm came.
  const std::int64_t tick = unpack<JointsRow>(first.value().front()).front().tick;
  for (std::int64_t count = blocks(); count > 0;) {
    const std::int64_t half = count / 2, block = joints_from_ + half;
    const Result<std::vector<Block>> ticks = file_.read(kTicks, block, 1);
    if (!ticks || !areThere(ticks.value()) || tickOf(ticks.value().front(), 0) < tick) {
      joints_from_ = block + 1;
      count -= half + 1;
    } else {
      count = half;
    }
  }
}

/// Joints 7 and 8 of blocks of ticks, as one more column; NaN where they cannot be read.
void Session::addJoints(std::int64_t first_block, std::vector<Block>& ticks) {
  std::int64_t block = first_block - 1;
  for (Block& of_ticks : ticks) {
    if (++block < joints_from_ || of_ticks.bytes.empty()) continue;
    const Result<std::vector<Block>> read = file_.read(kJoints, block - joints_from_, 1);
    std::vector<JointsRow> rows;
    if (read && areThere(read.value())) rows = unpack<JointsRow>(read.value().front());
    rows.resize(static_cast<std::size_t>(of_ticks.rows), {0, {kNotANumber, kNotANumber}});
    for (std::size_t row = 0; row < rows.size(); ++row) {
      if (rows[row].tick != tickOf(of_ticks, row)) rows[row].q.fill(kNotANumber);  // no recorder does that
      const auto q = std::as_bytes(std::span(rows[row].q));
      of_ticks.bytes.insert(of_ticks.bytes.end(), q.begin(), q.end());
    }
  }
}

Result<std::vector<Block>> Session::readTicks(std::int64_t first_block, std::int64_t count) {
  Result<std::vector<Block>> read = file_.read(kTicks, first_block, count);
  if (!read || !hasMoreJoints()) return read;
  std::vector<Block> ticks = std::move(read).value();
  addJoints(first_block, ticks);
  return ticks;
}

Problems Session::eachBlock(const std::function<bool(const Block&, std::int64_t)>& visit,
                            const std::function<void(const Gap&)>& damaged,
                            const std::function<void(double)>& progress) {
  const std::int64_t all = blocks();
  const std::int64_t block_bytes = blockRows() * static_cast<std::int64_t>(rowBytes(sessionTables(1000)[kTicks]));
  const std::int64_t at_once = std::clamp<std::int64_t>(kBytesAtOnce / block_bytes, 1, kBlocksAtOnce);
  std::int64_t gaps = 0;
  for (std::int64_t first = 0; first < all; first += at_once) {
    Result<std::vector<Block>> read = readTicks(first, at_once);
    if (!read) return read.problems();
    std::int64_t row = first * blockRows();
    for (const Block& block : read.value()) {
      if (block.bytes.empty()) {
        if (++gaps > kMaxGaps)
          return damagedAt(info_.path,
                           phrase(TRANSLATE_NOOP("problem", "The file is damaged, and the rest cannot be read.")));
        damaged({row, block.rows});
      } else if (!visit(block, row)) {
        return {};
      }
      row += block.rows;
    }
    if (progress) progress(std::min(1.0, static_cast<double>(first + at_once) / static_cast<double>(all)));
  }
  return {};
}

void Session::refresh() {
  file_.refresh();
  readSmallTables();
}

}  // namespace underact::record
