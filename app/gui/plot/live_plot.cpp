#include "app/gui/plot/live_plot.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <optional>

#include "app/gui/model/plot_columns.h"
#include "app/gui/plot/chart.h"
#include "app/gui/plot/column_chart.h"
#include "app/gui/plot/plot_range.h"
#include "core/arm/preset.h"
#include "core/base/units.h"

namespace underact::gui {
namespace {

constexpr std::size_t kPathGroups = 250;  // of force against displacement: 1000 points
// Times the limit: a greater commanded force leaves the plot, so that the sent one is readable.
constexpr double kAskedShown = 2.5;
constexpr double kMinError_mm = 1.0, kMinAway_mm = 1.0, kMinForce_N = 0.2, kMinEnergy_mJ = 1.0, kMinActive_mJ = 0.1;
constexpr double kMinChart_lines = 9.0;  // of text: the width that a chart needs for its labels
constexpr double kBelowZero = 0.1;       // of the energy's range

QString pathTitle(int axis) {
  return QCoreApplication::translate("underact::gui::LivePlot", "Force along %1 [N]").arg(QLatin1Char("xyz"[axis]));
}

double greatestOf(std::span<const PlotPoint> points) {
  float greatest = 0.0F;
  for (const PlotPoint& point : points) greatest = std::max(greatest, std::abs(point.y));
  return static_cast<double>(greatest);
}

}  // namespace

struct LivePlot::Impl {
  explicit Impl(LivePlot* owner) : plot(owner) {
    angles.setTickStep(45.0);
    path.setPaths();
    force.setHelper(0);
    energy.setHelper(0);
    energy.setHelper(1);
    angles.setRange(-PlotHistory::kSpan_s, 0.0, -180.0, 180.0);
  }

  void place(double scale) {
    const double width = plot->width(), height = plot->height();
    double path_width = std::clamp(0.26 * width, std::min(180.0, 0.3 * width), 1.6 * height + 60.0);
    const double against_time = 2.0 + (energy_shown ? 1.0 : 0.0) + (angles_shown ? 1.0 : 0.0) + (columns ? 1.0 : 0.0);
    const double min = kMinChart_lines * plot->fontMetrics().lineSpacing();
    letPathFit(against_time <= 2.0 || (width - path_width) / against_time >= min);
    if (!path_fits) path_width = 0.0;
    const double each = (width - path_width) / against_time;
    double left = 0.0;
    for (Chart* chart : shown()) {
      const double wide = chart == &path ? path_width : each;
      chart->setPlace({left, 0.0, wide, height}, scale, plot->font());
      left += wide;
    }
    energy.reserve(6 * (energy.columns() + 2));
    angles.reserve(4 * (angles.columns() + 2));
    error.reserve(2 * (error.columns() + 2));
    force.reserve(2 * (force.columns() + 2));
    path.reserve(4 * (kPathGroups + 2));
    if (columns) columns->reserve(2 * (columns->columns() + 2));
    data_changed = true;
  }

  void fill() {
    data_changed = false;
    const PlotHistory& rows_seen = held ? held->history : history;
    const double now_s = rows_seen.newest_s();
    const std::size_t errors = thinByTime(rows_seen, &PlotRow::error_mm, error.columns(), error.points(0));
    const std::size_t asked = thinByTime(rows_seen, &PlotRow::asked_N, force.columns(), force.points(1));
    const std::size_t sent = thinByTime(rows_seen, &PlotRow::sent_N, force.columns(), force.points(2));
    const std::size_t passive = thinByTime(rows_seen, &PlotRow::passive_N, force.columns(), force.points(3));
    const std::size_t steps = thinPath(rows_seen, static_cast<std::size_t>(axis), kPathGroups, path.points(0));
    const double limit = limit_N;
    std::fill(force.points(0).begin(), force.points(0).end(), PlotPoint{0.0F, static_cast<float>(limit)});
    force.points(0)[0].x = static_cast<float>(-PlotHistory::kSpan_s);

    const std::size_t old_errors = thinByTime(rows_seen, &PlotRow::recorded_error_mm, error.columns(), error.points(1));
    const std::size_t old_sent = thinByTime(rows_seen, &PlotRow::recorded_N, force.columns(), force.points(4));
    error.setCurveShown(1, old_errors > 0);
    force.setCurveShown(4, old_sent > 0);
    const double max_mm =
        std::max(greatestOf(error.points(0).first(errors)), greatestOf(error.points(1).first(old_errors)));
    const double top_mm = error_range.update(max_mm, now_s);
    const double max_N = std::max({greatestOf(force.points(2).first(sent)), greatestOf(force.points(1).first(asked)),
                                   greatestOf(force.points(4).first(old_sent))});
    force.setCurveShown(3, greatestOf(force.points(3).first(passive)) > 0.0);
    force_range.update(std::min(std::max(max_N, limit), kAskedShown * limit) / 1.05, now_s);
    double away_mm = 0.0, along_N = 0.0;
    for (const PlotPoint& point : path.points(0).first(steps)) {
      away_mm = std::max(away_mm, static_cast<double>(std::abs(point.x)));
      along_N = std::max(along_N, static_cast<double>(std::abs(point.y)));
    }
    away_range.update(away_mm, now_s);
    along_range.update(along_N, now_s);
    error.setRange(-PlotHistory::kSpan_s, 0.0, 0.0, top_mm);
    force.setRange(-PlotHistory::kSpan_s, 0.0, 0.0, force_range.end());
    path.setRange(-away_range.end(), away_range.end(), -along_range.end(), along_range.end());
    if (angles_shown) drawAngles(rows_seen);
    if (energy_shown) drawEnergy(rows_seen, now_s);
    const std::optional<ColumnRows>& rows = held ? held->rows : column_rows;
    if (columns && rows) {
      const double newest_s = rows->size() > 0 ? rows->time_s(rows->size() - 1) : 0.0;
      fillColumnChart(*columns, *rows, newest_s - PlotHistory::kSpan_s, newest_s, -newest_s);
    }
  }

  void drawEnergy(const PlotHistory& rows_seen, double now_s) {
    const std::size_t stored = thinByTime(rows_seen, &PlotRow::energy_mJ, energy.columns(), energy.points(2));
    const std::span<const PlotPoint> line = energy.points(2).first(stored);
    const std::size_t active = strokesBelowZero(line, energy.points(1));
    if (active == 0) std::fill(energy.points(1).begin(), energy.points(1).end(), PlotPoint{});
    std::fill(energy.points(0).begin(), energy.points(0).end(), PlotPoint{});
    energy.points(0)[0].x = static_cast<float>(-PlotHistory::kSpan_s);
    double max_mJ = 0.0, min_mJ = 0.0;
    for (const PlotPoint& point : line) {
      max_mJ = std::max(max_mJ, static_cast<double>(point.y));
      min_mJ = std::min(min_mJ, static_cast<double>(point.y));
    }
    const double top_mJ = stored_range.update(max_mJ, now_s), bottom_mJ = active_range.update(-min_mJ, now_s);
    // Room below zero even if nothing is there, so that the zero line is not the frame.
    energy.setRange(-PlotHistory::kSpan_s, 0.0, -std::max(bottom_mJ, kBelowZero * top_mJ), top_mJ);
  }

  /// If the charts would be too narrow to read, the one against displacement gives its room to those against time.
  void letPathFit(bool fits) {
    if (fits == path_fits) return;
    path_fits = fits;
    QMetaObject::invokeMethod(
        plot, [this] { emit plot->pathShown(path_fits); }, Qt::QueuedConnection);  // not in a paint
  }

  /// From left to right.
  std::vector<Chart*> shown() {
    std::vector<Chart*> charts{&error, &force};
    if (energy_shown) charts.push_back(&energy);
    if (angles_shown) charts.push_back(&angles);
    if (columns) charts.push_back(&*columns);
    if (path_fits) charts.push_back(&path);
    return charts;
  }

  void drawAngles(const PlotHistory& rows_seen) {
    thinAngle(rows_seen, &PlotRow::alpha_deg, angles.columns(), angles.points(0));
    thinAngle(rows_seen, &PlotRow::beta_deg, angles.columns(), angles.points(1));
    thinAngle(rows_seen, &PlotRow::theta_deg, angles.columns(), angles.points(2));
  }

  /// What is shown while the picture stands still.
  struct Held {
    PlotHistory history;
    std::optional<ColumnRows> rows;
  };

  LivePlot* plot;
  PlotHistory history;
  arm::Geometry geometry = arm::findPreset(arm::kDefaultArm)->geometry;
  std::optional<ColumnRows> column_rows;
  std::optional<Chart> columns;
  std::optional<Held> held;
  Theme theme = Theme::light();
  Chart error{LivePlot::tr("Error [mm]"),
              LivePlot::tr("time [s]"),
              {{QString(), 1.5F}, {LivePlot::tr("recorded"), 1.5F, true}}};
  Chart force{LivePlot::tr("Force [N]"),
              LivePlot::tr("time [s]"),
              {{LivePlot::tr("limit"), 1.0F},
               {LivePlot::tr("commanded"), 1.0F},
               {LivePlot::tr("sent"), 2.0F},
               {LivePlot::tr("passive"), 1.5F},
               {LivePlot::tr("recorded"), 1.5F, true}}};
  Chart path{pathTitle(0), LivePlot::tr("displacement [mm]"), {{QString(), 1.5F}}};
  Chart angles{
      LivePlot::tr("Angle [°]"),
      LivePlot::tr("time [s]"),
      {{LivePlot::tr("α stylus"), 1.5F, true}, {LivePlot::tr("β tip"), 1.5F}, {LivePlot::tr("θ target"), 2.5F}}};
  Chart energy{LivePlot::tr("Energy [mJ]"),
               LivePlot::tr("time [s]"),
               {{QString(), 1.0F}, {LivePlot::tr("active"), 1.0F}, {LivePlot::tr("stored"), 2.0F}}};
  PlotRange stored_range{kMinEnergy_mJ}, active_range{kMinActive_mJ};
  PlotRange error_range{kMinError_mm}, force_range{kMinForce_N}, away_range{kMinAway_mm}, along_range{kMinForce_N};
  double limit_N = arm::findPreset(arm::kDefaultArm)->continuous_force_N;
  int axis = 0;
  bool angles_shown = false;
  bool energy_shown = true;
  bool path_fits = true;
  bool data_changed = true;
};

LivePlot::LivePlot(QWidget* parent) : ChartWidget(parent), impl_(std::make_unique<Impl>(this)) {
  setObjectName(QStringLiteral("plot.live"));
  setAccessibleName(tr("Live plots"));
  setAccessibleDescription(
      tr("Error and force over the last 10 seconds, and force against displacement along one axis."));
  setMinimumSize(240, 120);
  setTheme(Theme::light());
}

LivePlot::~LivePlot() = default;

void LivePlot::add(const servo::TickRecord& record, const RecordedBeside& recorded) {
  impl_->history.add(record, recorded);
  if (impl_->column_rows) {
    const double now_s = kSecondPerNanosecond * static_cast<double>(record.time_ns);
    impl_->column_rows->add(now_s, record);
    impl_->column_rows->dropBefore(now_s - PlotHistory::kSpan_s);
  }
  if (!impl_->held) impl_->data_changed = true;
}

void LivePlot::redraw() {
  if (impl_->data_changed) draw();
}

void LivePlot::clear() {
  impl_->history.clear();
  for (PlotRange* range : {&impl_->error_range, &impl_->force_range, &impl_->away_range, &impl_->along_range})
    range->clear();
  impl_->stored_range.clear();
  impl_->active_range.clear();
  impl_->data_changed = true;
  draw();
}

void LivePlot::showColumns(const std::vector<int>& columns) {
  impl_->columns.reset();
  impl_->column_rows.reset();
  if (!columns.empty()) {
    impl_->columns = columnChart(columns);
    impl_->column_rows.emplace(columns);
    impl_->column_rows->setGeometry(impl_->geometry);
    setColumnColours(*impl_->columns, impl_->theme);
  }
  if (impl_->held) impl_->held->rows = impl_->column_rows;
  placeAnew();
}

void LivePlot::setGeometry(const arm::Geometry& geometry) {
  impl_->geometry = geometry;
  if (impl_->column_rows) impl_->column_rows->setGeometry(geometry);
}

void LivePlot::hold(bool on) {
  if (on == holds()) return;
  if (on) {
    impl_->held = Impl::Held{impl_->history, impl_->column_rows};
  } else {
    impl_->held.reset();
  }
  impl_->data_changed = true;
  draw();
}

bool LivePlot::holds() const {
  return impl_->held.has_value();
}

void LivePlot::setTheme(const Theme& theme) {
  Impl& my = *impl_;
  my.theme = theme;
  if (my.columns) setColumnColours(*my.columns, theme);
  setBackground(theme);
  my.error.setColours(theme, {theme.target, theme.ink});
  my.force.setColours(
      theme, {theme.force_limited, mixed(theme.background, theme.ink, 0.55), theme.force, theme.constraint, theme.ink});
  my.energy.setColours(theme, {theme.ink, theme.force_limited, theme.constraint});
  my.path.setColours(theme, {theme.force});
  my.angles.setColours(theme, {theme.orientation, theme.position, theme.target});
  draw();
}

void LivePlot::setAxis(int axis) {
  impl_->axis = std::clamp(axis, 0, 2);
  impl_->path.setTitle(pathTitle(impl_->axis));
  impl_->away_range.clear();
  impl_->along_range.clear();
  impl_->data_changed = true;
  draw();
}

int LivePlot::axis() const {
  return impl_->axis;
}

void LivePlot::showAngles(bool shown) {
  if (shown == impl_->angles_shown) return;
  impl_->angles_shown = shown;
  placeAnew();  // the widths of the others change
}

void LivePlot::showEnergy(bool shown) {
  if (shown == impl_->energy_shown) return;
  impl_->energy_shown = shown;
  placeAnew();
}

bool LivePlot::showsEnergy() const {
  return impl_->energy_shown;
}

bool LivePlot::showsAngles() const {
  return impl_->angles_shown;
}

void LivePlot::setForceLimit(double continuous_N) {
  impl_->limit_N = continuous_N;
  impl_->data_changed = true;
  draw();
}

std::vector<Chart*> LivePlot::shown() const {
  return impl_->shown();
}

void LivePlot::place(double scale) {
  impl_->place(scale);
}

void LivePlot::prepare(bool /*placed*/) {
  if (impl_->data_changed) impl_->fill();
}

}  // namespace underact::gui
