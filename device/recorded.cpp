#include "device/recorded.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/base/translate.h"
#include "core/record/tick_table.h"
#include "core/scene/load_meshes.h"

namespace underact::device {
namespace {

// A file whose tick numbers are damaged must not claim all memory: four hours at 10 kHz at most. Nor much more than it
// holds: missing ticks are shown as that many rows, up to the number of ticks in the file plus a minute at 10 kHz.
constexpr std::int64_t kMaxRows = 144'000'000;
constexpr std::int64_t kMaxMissing = 600'000;
constexpr std::int64_t kReserved = 1 << 20;
constexpr std::size_t kMaxDamage = 1000;  // sentences

bool isFinite(const arm::JointAngles& q_rad) {
  return std::all_of(q_rad.begin(), q_rad.end(), [](double angle_rad) { return std::isfinite(angle_rad); });
}

/// From one tick to another, as far as rows go: the difference of any two numbers.
std::int64_t ticksFrom(std::int64_t first, std::int64_t tick) {
  if (tick <= first) return 0;
  const std::uint64_t ticks = static_cast<std::uint64_t>(tick) - static_cast<std::uint64_t>(first);
  return static_cast<std::int64_t>(std::min(ticks, static_cast<std::uint64_t>(kMaxRows)));
}

/// Rows in the order of the file, with one for each missing tick.
class Rows {
 public:
  /// max_missing: rows for missing ticks.
  Rows(std::vector<RecordedRow>& rows, std::int64_t max_missing) : rows_(rows), missing_left_(max_missing) {}

  std::int64_t firstTick() const { return first_tick_; }
  /// Returns the row of this tick.
  std::int64_t add(const servo::TickRecord& record) {
    if (rows_.empty()) first_tick_ = record.tick;
    const std::int64_t missing =
        std::clamp<std::int64_t>(ticksFrom(first_tick_, record.tick) - size(), 0, missing_left_);
    missing_left_ -= missing;
    for (std::int64_t row = 0; row < missing && size() > 0; ++row) repeat();
    RecordedRow row;
    const bool has_sample = (record.input & servo::kHadSample) != 0 && isFinite(record.q_rad);
    if (has_sample) q_rad_ = record.q_rad;
    if (has_sample && !had_one_) fillBefore();
    row.q_rad = q_rad_;
    row.force_N = static_cast<float>(record.f_sent_T_W.norm());
    row.error_m = static_cast<float>(record.error_m);
    row.buttons = record.buttons;
    row.is_full = record.level >= 1.0 && record.fault == FaultKind::None;
    const bool faults = record.fault != FaultKind::None && fault_ == FaultKind::None;
    row.begins_anew =
        missing > 0 || faults || (record.input & servo::kRestarted) != 0 || (size() > 0 && record.time_ns < time_ns_);
    fault_ = record.fault;
    time_ns_ = record.time_ns;
    rows_.push_back(row);
    return size() - 1;
  }

 private:
  std::int64_t size() const { return static_cast<std::int64_t>(rows_.size()); }
  void repeat() {
    RecordedRow row;
    row.q_rad = q_rad_;
    rows_.push_back(row);
  }
  void fillBefore() {
    had_one_ = true;
    for (RecordedRow& row : rows_) row.q_rad = q_rad_;
  }

  std::vector<RecordedRow>& rows_;
  arm::JointAngles q_rad_{};
  bool had_one_ = false;
  std::int64_t first_tick_ = 0, time_ns_ = 0;
  FaultKind fault_ = FaultKind::None;
  std::int64_t missing_left_;
};

std::vector<RecordedMark> referencePointsOf(const record::Session& session, std::int64_t first_tick,
                                            std::int64_t rows) {
  const auto rowOf = [&](std::int64_t tick) { return std::min(ticksFrom(first_tick, tick), rows - 1); };
  std::vector<RecordedMark> marks;
  for (const record::Marker& marker : session.markers()) marks.push_back({rowOf(marker.tick), marker.label, false});
  for (const servo::FaultMark& fault : session.faults())
    marks.push_back({rowOf(fault.tick), describe(fault.fault), true});
  std::stable_sort(marks.begin(), marks.end(), [](const auto& a, const auto& b) { return a.row < b.row; });
  return marks;
}

/// A scene whose mesh is missing is kept, and reports it when it is run.
void loadMeshes(scene::Description& scene, const LoadWatch& load, Problems& damage) {
  TaskMonitor watch;
  watch.cancelled = load.cancelled;
  const Problems problems = scene::loadRecordedMeshes(scene, load.files_in, watch);
  damage.insert(damage.end(), problems.begin(), problems.end());
}

void readScenes(record::Session& session, std::int64_t first_tick, const LoadWatch& watch, Recorded& recorded) {
  for (const record::ChangeRow& change : session.changes()) {
    Result<scene::Description> scene = session.scene(change);
    if (!scene) {
      recorded.damage.insert(recorded.damage.end(), scene.problems().begin(), scene.problems().end());
      continue;
    }
    if (scene.value().constraints.empty()) continue;
    loadMeshes(scene.value(), watch, recorded.damage);
    recorded.scenes.push_back({ticksFrom(first_tick, change.tick), std::move(scene).value()});
  }
  std::stable_sort(recorded.scenes.begin(), recorded.scenes.end(),
                   [](const auto& a, const auto& b) { return a.row < b.row; });
}

}  // namespace

const RecordedScene* Recorded::sceneAt(std::int64_t row) const {
  const RecordedScene* found = nullptr;
  for (const RecordedScene& scene : scenes) {
    if (scene.row <= row) found = &scene;
  }
  return found != nullptr || scenes.empty() ? found : &scenes.front();
}

Result<std::shared_ptr<const Recorded>> loadRecorded(const std::string& path, const LoadWatch& watch) {
  Result<record::Session> opened = record::Session::open(path);
  if (!opened) return opened.problems();
  return loadRecorded(opened.value(), watch);
}

Result<std::shared_ptr<const Recorded>> loadRecorded(record::Session& session, const LoadWatch& watch) {
  const std::string& path = session.info().path;
  auto recorded = std::make_shared<Recorded>();
  const record::SessionHeader& header = session.info().header;
  recorded->name = header.words.name.empty() ? std::filesystem::path(path).stem().string() : header.words.name;
  recorded->path = path;
  recorded->rate_hz = static_cast<int>(header.rate_hz);
  recorded->frozen_s = header.frozen_s;
  recorded->arm = header.arm;
  recorded->damage = session.info().damage;
  const std::int64_t ticks = std::min(session.info().ticks, kMaxRows);
  recorded->rows.reserve(static_cast<std::size_t>(std::min(ticks, kReserved)));
  Rows rows(recorded->rows, ticks + kMaxMissing);
  bool is_cancelled = false, is_full = false;
  const Problems problems = session.eachBlock(
      [&](const record::Block& block, std::int64_t) {
        for (const servo::TickRecord& record : record::unpackTicks(block)) {
          is_full = is_full || static_cast<std::int64_t>(recorded->rows.size()) >= kMaxRows;
          if (is_full) break;
          const std::int64_t row = rows.add(record);
          if (watch.row) watch.row(row, record);
        }
        is_cancelled = watch.cancelled != nullptr && watch.cancelled->load();
        return !is_cancelled && !is_full;
      },
      [&](const record::Gap& gap) {
        if (recorded->damage.size() >= kMaxDamage) return;
        recorded->damage.push_back(
            {phrase(
                 TRANSLATE_NOOP("problem", "Ticks %1 to %2 of this session are damaged; the arm stands still there."),
                 {std::to_string(gap.first_row), std::to_string(gap.first_row + gap.rows - 1)}),
             {path}});
      },
      watch.progress);
  if (!problems.empty()) return problems;
  if (is_cancelled)
    return Problems{
        {phrase(TRANSLATE_NOOP("problem", "Opening was cancelled before the whole session was read.")), {path}}};
  if (recorded->rows.empty())
    return Problems{
        {phrase(TRANSLATE_NOOP("problem", "This session contains no ticks, so there is nothing to replay.")), {path}}};
  recorded->marks = referencePointsOf(session, rows.firstTick(), static_cast<std::int64_t>(recorded->rows.size()));
  readScenes(session, rows.firstTick(), watch, *recorded);
  return std::shared_ptr<const Recorded>(std::move(recorded));
}

}  // namespace underact::device
