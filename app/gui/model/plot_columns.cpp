#include "app/gui/model/plot_columns.h"

#include <algorithm>
#include <limits>

#include "core/record/columns.h"
#include "core/record/session.h"
#include "core/scene/scene_arm.h"
#include "device/recorded.h"

namespace underact::gui {
namespace {

/// Takes the fields of a tick as numbers.
struct Numbers {
  std::span<float> values;
  std::size_t next = 0;
  void number(double value) {
    if (next < values.size()) values[next++] = static_cast<float>(value);
  }
  template <class Integer>
  void integer(Integer value) {
    number(static_cast<double>(value));
  }
  void word(FaultKind fault) { integer(fault); }
};

QString text(std::string_view view) {
  return QString::fromUtf8(view.data(), static_cast<qsizetype>(view.size()));
}

}  // namespace

const std::vector<PlotColumn>& plotColumns() {
  static const std::vector<PlotColumn> kAll = [] {
    std::vector<PlotColumn> all;
    for (const record::CsvField& field : record::allFields())
      all.push_back({text(field.name), text(field.unit), text(field.column->meaning)});
    return all;
  }();
  return kAll;
}

int findPlotColumn(const QString& name) {
  const std::vector<PlotColumn>& all = plotColumns();
  const auto found = std::find_if(all.begin(), all.end(), [&](const PlotColumn& one) { return one.name == name; });
  return found == all.end() ? -1 : static_cast<int>(found - all.begin());
}

void fillColumns(const servo::TickRecord& record, const arm::Geometry& geometry, std::span<float> values) {
  Numbers row{values};
  record::fillAll(record, geometry, row);
}

ColumnRows::ColumnRows(std::vector<int> columns, std::size_t max)
    : columns_(std::move(columns)),
      geometry_(arm::findPreset(arm::kDefaultArm)->geometry),
      max_(max),
      all_(plotColumns().size()) {}

void ColumnRows::add(double time_s, const servo::TickRecord& record) {
  if (size() > 0 && time_s < times_s_.back()) {  // another device: its past is another one
    times_s_.clear();
    values_.clear();
    first_ = 0;
  }
  if (seen_++ % every_ != 0) return;
  fillColumns(record, geometry_, all_);
  times_s_.push_back(time_s);
  for (const int column : columns_) values_.push_back(all_[static_cast<std::size_t>(column)]);
  if (size() >= max_) halve();
}

void ColumnRows::dropBefore(double time_s) {
  while (first_ < times_s_.size() && times_s_[first_] < time_s) ++first_;
  if (first_ < times_s_.size() / 2 || first_ < 1024) return;  // seldom: it moves all others
  times_s_.erase(times_s_.begin(), times_s_.begin() + static_cast<std::ptrdiff_t>(first_));
  values_.erase(values_.begin(), values_.begin() + static_cast<std::ptrdiff_t>(first_ * columns_.size()));
  first_ = 0;
}

void ColumnRows::halve() {
  const std::size_t width = columns_.size(), half = size() / 2;
  for (std::size_t row = 0; row < half; ++row) {
    times_s_[row] = times_s_[first_ + 2 * row];
    for (std::size_t index = 0; index < width; ++index)
      values_[row * width + index] = values_[(first_ + 2 * row) * width + index];
  }
  times_s_.resize(half);
  values_.resize(half * width);
  first_ = 0;
  every_ *= 2;
}

std::size_t thinColumn(const ColumnRows& rows, std::size_t index, std::size_t parts, double from_s, double to_s,
                       double shift_s, std::span<PlotPoint> points) {
  const double part_s = (to_s - from_s) / static_cast<double>(std::max<std::size_t>(parts, 1));
  return thinRows(
      rows.size(), [&](std::size_t row) { return rows.time_s(row); },
      [&](std::size_t row) { return rows.value(row, index); }, part_s, shift_s, std::numeric_limits<float>::infinity(),
      points);
}

namespace {

/// The arm of a session's ticks, in their order: that of the scene in effect.
class ArmOfTicks {
 public:
  explicit ArmOfTicks(record::Session& session) {
    for (const record::ChangeRow& change : session.changes()) {
      const Result<scene::Description> scene = session.scene(change);
      if (scene && !scene.value().constraints.empty())
        begins_.push_back({change.tick, scene::armOf(scene.value()).geometry});
    }
  }
  /// Tells rows which arm it is, where that has changed by this tick.
  void follow(std::int64_t tick, ColumnRows& rows) {
    for (; next_ < begins_.size() && begins_[next_].tick <= tick; ++next_) rows.setGeometry(begins_[next_].geometry);
  }

 private:
  struct Begin {
    std::int64_t tick = 0;
    arm::Geometry geometry;
  };
  std::vector<Begin> begins_;
  std::size_t next_ = 0;
};

}  // namespace

Result<std::shared_ptr<const ColumnRows>> readColumns(const std::string& path, const std::vector<int>& columns,
                                                      WorkState& state) {
  Result<record::Session> session = record::Session::open(path);
  if (!session) return session.problems();
  const auto rate_hz = static_cast<double>(session.value().info().header.rate_hz);
  auto rows = std::make_shared<ColumnRows>(columns);
  ArmOfTicks arm_of_ticks(session.value());
  device::LoadWatch watch;
  watch.cancelled = &state.cancelled;
  watch.row = [&](std::int64_t row, const servo::TickRecord& record) {
    arm_of_ticks.follow(record.tick, *rows);
    rows->add(static_cast<double>(row) / rate_hz, record);
  };
  const Result<std::shared_ptr<const device::Recorded>> recorded = device::loadRecorded(session.value(), watch);
  if (!recorded) return recorded.problems();
  return std::shared_ptr<const ColumnRows>(std::move(rows));
}

}  // namespace underact::gui
