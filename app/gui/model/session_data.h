#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "app/gui/model/plot_history.h"
#include "app/gui/model/spectrum.h"
#include "core/base/types.h"
#include "core/servo/histogram.h"

namespace underact::gui {

/// A recorded tip position and the force sent there.
struct PathPoint {
  Vec3 p_mm = Vec3::Zero();
  double force_N = 0.0;
};

/// What the charts store of a recorded tick.
struct SessionRow {
  PlotRow plot;  // time_s: since the first tick
  std::array<float, 3> p_mm{};
};

/// A session for charts. In a long one, a row represents a group of ticks by the one with the greatest force.
class SessionData {
 public:
  static constexpr std::size_t kMaxRows = 2'000'000;

  /// max_rows: above it the rows are halved; must be even.
  explicit SessionData(std::size_t max_rows = kMaxRows) : max_rows_(max_rows) {}
  /// Adds a row of the recording, in order.
  void add(std::int64_t row, double rate_hz, const servo::TickRecord& record);
  /// Call it after the last row. It is slow, so not in the window's thread.
  void finish(double rate_hz);
  const std::vector<SessionRow>& rows() const { return rows_; }
  /// Number of ticks that a row represents.
  std::int64_t ticksPerRow() const { return ticks_per_row_; }
  const servo::Histogram& lateness() const { return lateness_; }  // of all ticks

  // After finish().
  const std::vector<SpectrumLine>& forceSpectrum() const { return force_spectrum_; }  // N
  const std::vector<SpectrumLine>& errorSpectrum() const { return error_spectrum_; }  // mm
  const std::vector<PathPoint>& path() const { return path_; }

 private:
  void halve();

  std::size_t max_rows_;
  std::vector<SessionRow> rows_;
  std::int64_t ticks_per_row_ = 1, group_ = -1;
  servo::Histogram lateness_;
  std::vector<SpectrumLine> force_spectrum_, error_spectrum_;
  std::vector<PathPoint> path_;
};

/// The path of the tip in at most that many points: one each time it has moved far enough, with the greatest force
/// since the last one.
std::vector<PathPoint> pathOf(const std::vector<SessionRow>& rows, std::size_t max);

}  // namespace underact::gui
