#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "app/gui/model/thin_rows.h"
#include "core/servo/snapshot.h"

namespace underact::gui {

/// What was recorded at the replayed tick; NaN: no replay.
struct RecordedBeside {
  float error_mm = std::numeric_limits<float>::quiet_NaN();
  float force_N = std::numeric_limits<float>::quiet_NaN();  // sent
};

/// What the plots store of a tick, in the units shown.
struct PlotRow {
  double time_s = 0.0;
  float error_mm = 0.0F;
  float asked_N = 0.0F;
  float sent_N = 0.0F;
  std::array<float, 3> away_mm{};  // tip minus target, per axis of W; NaN if there is no target
  std::array<float, 3> force_N{};  // sent, per axis of W
  // Angles of stylus, tip and target about the axis of the shape with influence; NaN if there is none.
  float alpha_deg = 0.0F;
  float beta_deg = 0.0F;
  float theta_deg = 0.0F;
  float energy_mJ = 0.0F;  // that the stylus has put in and not got back
  float passive_N = 0.0F;  // what the passivity controllers add
  // From the recording; NaN: no replay.
  float recorded_error_mm = std::numeric_limits<float>::quiet_NaN();
  float recorded_N = std::numeric_limits<float>::quiet_NaN();
};

PlotRow plotRowOf(const servo::TickRecord& record);

/// The last 10 s of ticks, up to 10000 a second, in a ring buffer that grows with the servo rate: 1.2 MB at 1 kHz, 7.2
/// at most. For the GUI thread: add() may allocate.
class PlotHistory {
 public:
  static constexpr double kSpan_s = 10.0;
  static constexpr std::size_t kCapacity = 100'000;

  /// If the clock goes backwards, it is another device: earlier rows are dropped.
  void add(const servo::TickRecord& record, const RecordedBeside& recorded = {});
  void clear();
  std::size_t size() const { return size_; }
  /// Number of rows that fit without growing.
  std::size_t room() const { return rows_.size(); }
  /// From the oldest, 0, to the newest.
  const PlotRow& row(std::size_t index) const { return rows_[(first_ + index) % rows_.size()]; }
  double newest_s() const { return size_ == 0 ? 0.0 : row(size_ - 1).time_s; }

 private:
  void grow();

  std::vector<PlotRow> rows_;
  std::size_t first_ = 0;
  std::size_t size_ = 0;
};

/// A value against the time before the newest row, s: the least and the greatest value in each of `columns` columns of
/// the span, in order, so that a spike of one tick is drawn. Columns keep their ticks as time passes, so the line does
/// not flicker. points: at least 2 (columns + 2); unused ones repeat the last. Returns the number used; values that are
/// not finite are left out.
std::size_t thinByTime(const PlotHistory& history, float PlotRow::*value, std::size_t columns,
                       std::span<PlotPoint> points);

/// Thins an angle in degrees, from -180 to 180: a step of more than half a turn is a wrap-around, where a NaN
/// point breaks the line. points: at least 4 (columns + 2).
std::size_t thinAngle(const PlotHistory& history, float PlotRow::*value_deg, std::size_t columns,
                      std::span<PlotPoint> points);

/// The part of a line below zero, as strokes from zero down to it, separated by NaN points. points: 3 for each point of
/// line; unused ones repeat the last. Returns the number used.
std::size_t strokesBelowZero(std::span<const PlotPoint> line, std::span<PlotPoint> points);

/// The path of (away_mm, force_N) along an axis: the extreme points of each of `groups` intervals of time, in order.
/// points: at least 4 (groups + 2); unused ones repeat the last.
std::size_t thinPath(const PlotHistory& history, std::size_t axis, std::size_t groups, std::span<PlotPoint> points);

}  // namespace underact::gui
