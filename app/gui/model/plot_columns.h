#pragma once
#include <QString>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/gui/kit/background.h"
#include "app/gui/model/plot_history.h"
#include "core/arm/preset.h"
#include "core/base/result.h"

namespace underact::gui {

/// A number of a tick that can be plotted: one of a column of a session.
struct PlotColumn {
  QString name;     // as in CSV, or in Parquet where CSV does not have it
  QString unit;     // empty: it has none
  QString meaning;  // of its column
};

/// All there are: those of CSV in its order, then those that only sessions have.
const std::vector<PlotColumn>& plotColumns();

/// The index of that name; -1: there is none.
int findPlotColumn(const QString& name);

/// The numbers of a tick in that order. geometry: of the arm, for the turn of the stylus, which the servo computes only
/// where a scene needs it. values: as many as there are columns.
void fillColumns(const servo::TickRecord& record, const arm::Geometry& geometry, std::span<float> values);

/// Columns against time, s: a row for each tick, or for each of several ticks in a row.
class ColumnRows {
 public:
  /// columns: of plotColumns(), as many as are chosen; most: rows, above which every other one is dropped; even.
  explicit ColumnRows(std::vector<int> columns, std::size_t max = std::size_t{1} << 20);
  /// Of the arm whose ticks are added from now on; at first the default arm's.
  void setGeometry(const arm::Geometry& geometry) { geometry_ = geometry; }
  void add(double time_s, const servo::TickRecord& record);
  /// Drops the rows before that time.
  void dropBefore(double time_s);
  const std::vector<int>& columns() const { return columns_; }
  std::size_t size() const { return times_s_.size() - first_; }
  double time_s(std::size_t row) const { return times_s_[first_ + row]; }
  /// index: in columns().
  float value(std::size_t row, std::size_t index) const { return values_[(first_ + row) * columns_.size() + index]; }

 private:
  void halve();

  std::vector<int> columns_;
  arm::Geometry geometry_;
  std::size_t max_, first_ = 0;
  std::int64_t every_ = 1, seen_ = 0;
  std::vector<double> times_s_;
  std::vector<float> values_;
  std::vector<float> all_;  // of the tick being added
};

/// One column thinned by the least and the greatest value of each of `parts` equal intervals from from_s to to_s, in
/// order. shift_s: added to each time. points: at least 2 (parts + 2); unused ones repeat the last. Returns the number
/// used.
std::size_t thinColumn(const ColumnRows& rows, std::size_t index, std::size_t parts, double from_s, double to_s,
                       double shift_s, std::span<PlotPoint> points);

/// Reads columns of a session file; times from its first tick. Problems: those of the file.
Result<std::shared_ptr<const ColumnRows>> readColumns(const std::string& path, const std::vector<int>& columns,
                                                      WorkState& state);

}  // namespace underact::gui
