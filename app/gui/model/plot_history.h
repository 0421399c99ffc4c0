#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/servo/snapshot.h"

namespace underact::gui {

/// What a recording has at the tick that is replayed; NaN: nothing is.
struct RecordedBeside {
  float error_mm = std::numeric_limits<float>::quiet_NaN();
  float force_N = std::numeric_limits<float>::quiet_NaN();  // sent
};

/// What the plots keep of a tick, in the screen's units.
struct PlotRow {
  double time_s = 0.0;
  float error_mm = 0.0F;
  float asked_N = 0.0F;
  float sent_N = 0.0F;
  std::array<float, 3> away_mm{};  // of the tip from the target, per axis of W; NaN where none acts
  std::array<float, 3> force_N{};  // sent, per axis of W
  // About the influenced shape's axis, of stylus, tip and target; NaN where there are none.
  float alpha_deg = 0.0F;
  float beta_deg = 0.0F;
  float theta_deg = 0.0F;
  float energy_mJ = 0.0F;  // that the stylus has put in and not got back
  float passive_N = 0.0F;  // what the passivity controllers add
  // Of what is replayed; NaN: nothing is.
  float recorded_error_mm = std::numeric_limits<float>::quiet_NaN();
  float recorded_N = std::numeric_limits<float>::quiet_NaN();
};

PlotRow plotRowOf(const servo::TickRecord& record);

/// The last 10 s of ticks, up to 10000 a second, in a ring that grows to what the servo's rate needs: 1.2 MB at 1 kHz,
/// 7.2 at most. For the GUI thread: add() may allocate.
class PlotHistory {
 public:
  static constexpr double kSpan_s = 10.0;
  static constexpr std::size_t kCapacity = 100'000;

  /// A clock that goes backwards is another device: what was before is dropped.
  void add(const servo::TickRecord& record, const RecordedBeside& recorded = {});
  void clear();
  std::size_t size() const { return size_; }
  /// Rows there is room for without growing.
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

struct PlotPoint {
  float x = 0.0F;
  float y = 0.0F;
};

/// Of points of which so many were used, what is left over repeats the last.
void repeatLast(std::span<PlotPoint> points, std::size_t used);

/// One value against the time before the newest row, s: of each of `columns` columns of the span the least and the
/// greatest value, in the order they came, so that a spike of one tick is drawn. Columns keep their ticks as time goes
/// on, so nothing shimmers. points: at least 2 (columns + 2); what is left over repeats the last. Gives how many were
/// used; values that are not finite are left out.
std::size_t thinByTime(const PlotHistory& history, float PlotRow::*value, std::size_t columns,
                       std::span<PlotPoint> points);

/// The same for an angle in degrees, from -180 to 180: a step of more than half a turn is a smaller one the other way,
/// and a point that is no number breaks the line there. points: at least 4 (columns + 2).
std::size_t thinAngle(const PlotHistory& history, float PlotRow::*value_deg, std::size_t columns,
                      std::span<PlotPoint> points);

/// What of a line is below zero, as strokes from zero down to it, each closed by a point that is no number. points: 3
/// for each of line's; what is left over repeats the last. Gives how many were used.
std::size_t strokesBelowZero(std::span<const PlotPoint> line, std::span<PlotPoint> points);

/// The way of (away_mm, force_N) along an axis: of each of `groups` stretches of time the extreme points, in order.
/// points: at least 4 (groups + 2); what is left over repeats the last.
std::size_t thinPath(const PlotHistory& history, std::size_t axis, std::size_t groups, std::span<PlotPoint> points);

}  // namespace underact::gui
