#include "app/gui/replay/session_plot.h"

#include <QMouseEvent>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "app/gui/plot/chart.h"
#include "app/gui/plot/column_chart.h"
#include "app/gui/plot/plot_range.h"
#include "app/gui/replay/thin_session.h"

namespace underact::gui {
namespace {

constexpr double kMinShownError_mm = 1.0, kMinForce_N = 0.2, kMinEnergy_mJ = 1.0, kMinAway_mm = 1.0;
constexpr double kSessionRoom = 1.05;
constexpr double kSessionAskedShown = 2.5;  // times the greatest force sent: the commanded force has no limit
constexpr double kMaxFrequency_hz = 250.0;  // a hand reaches some 20 Hz, the buzzing of a stiff scene stays below this
constexpr double kMin_dB = -20.0, kStep_dB = 20.0;
constexpr double kPerUnit_dB = 60.0;  // of N, mm: 1 is 60 dB re a thousandth
constexpr std::size_t kPathGroups = 500;
constexpr float kNoBreak = std::numeric_limits<float>::infinity();

double greatestOf(std::span<const PlotPoint> points, float PlotPoint::*value) {
  float greatest = 0.0F;
  for (const PlotPoint& point : points) {
    if (std::isfinite(point.*value)) greatest = std::max(greatest, std::abs(point.*value));
  }
  return static_cast<double>(greatest);
}

double endOf(double greatest, double min) {
  return roundUp(std::max(kSessionRoom * greatest, min));
}

/// Both ends of the cursor, the last two points of each chart's last curve.
void putLine(std::span<PlotPoint> points, double x, double from, double to) {
  std::fill(points.begin(), points.end(), PlotPoint{static_cast<float>(x), static_cast<float>(to)});
  points[0].y = static_cast<float>(from);
}

}  // namespace

struct SessionPlot::Impl {
  explicit Impl(SessionPlot* owner) : plot(owner) {
    angles.setTickStep(45.0);
    for (Chart* chart : {&force_lines, &error_lines}) chart->setTickStep(kStep_dB);
    error.setHelper(1);
    force.setHelper(2);
    angles.setHelper(3);
    energy.setHelper(0);
    energy.setHelper(2);
    for (Chart& chart : along) {
      chart.setPaths();
      chart.setHelper(1);
    }
  }

  /// From left to right.
  std::vector<Chart*> shown() {
    switch (kind) {
      case SessionPlotKind::ErrorAndForce:
        return {&error, &force};
      case SessionPlotKind::ForceAgainstDisplacement:
        return {&along[0], &along[1], &along[2]};
      case SessionPlotKind::Angles:
        return {&angles};
      case SessionPlotKind::Energy:
        return {&energy};
      case SessionPlotKind::Spectrum:
        return {&force_lines, &error_lines};
      case SessionPlotKind::Columns:
        return {&columns};
    }
    return {};
  }
  bool isAgainstTime() const {
    return kind != SessionPlotKind::ForceAgainstDisplacement && kind != SessionPlotKind::Spectrum;
  }
  void prepare(bool placed) {
    if (placed) fill();
    if (!placed && !cursor_changed) return;
    cursor_changed = false;
    putCursor();
  }

  void place(double scale) {
    const double width = plot->width(), height = plot->height();
    const std::vector<Chart*> charts = shown();
    const double each = width / static_cast<double>(charts.size());
    double left = 0.0;
    for (Chart* chart : charts) {
      chart->setPlace({left, 0.0, each, height}, scale, plot->font());
      chart->reserve(4 * (std::max(chart->columns(), kPathGroups) + 2));
      left += each;
    }
  }

  std::size_t against(Chart& chart, std::size_t curve, const std::function<float(const SessionRow&)>& value,
                      float largest_step = kNoBreak) {
    return thinSession(rows(), value, chart.columns(), largest_step, chart.points(curve));
  }
  const std::vector<SessionRow>& rows() const {
    static const std::vector<SessionRow> kNone;
    return data ? data->rows() : kNone;
  }
  double end_s() const { return rows().empty() ? 1.0 : std::max(rows().back().plot.time_s, 1e-3); }

  void fill() {
    switch (kind) {
      case SessionPlotKind::ErrorAndForce:
        return fillErrorAndForce();
      case SessionPlotKind::ForceAgainstDisplacement:
        return fillAlong();
      case SessionPlotKind::Angles:
        return fillAngles();
      case SessionPlotKind::Energy:
        return fillEnergy();
      case SessionPlotKind::Spectrum:
        fillLines(force_lines, data ? data->forceSpectrum() : std::vector<SpectrumLine>{});
        return fillLines(error_lines, data ? data->errorSpectrum() : std::vector<SpectrumLine>{});
      case SessionPlotKind::Columns:
        if (column_rows) return fillColumnChart(columns, *column_rows, 0.0, end_s(), 0.0);
        return columns.setRange(0.0, end_s(), 0.0, 1.0);
    }
  }

  void fillErrorAndForce() {
    against(error, 0, [](const SessionRow& row) { return row.plot.error_mm; });
    against(force, 0, [](const SessionRow& row) { return row.plot.asked_N; });
    against(force, 1, [](const SessionRow& row) { return row.plot.sent_N; });
    error.setRange(0.0, end_s(), 0.0, endOf(greatestOf(error.points(0), &PlotPoint::y), kMinShownError_mm));
    const double sent_N = std::max(greatestOf(force.points(1), &PlotPoint::y), kMinForce_N);
    const double asked_N = std::min(greatestOf(force.points(0), &PlotPoint::y), kSessionAskedShown * sent_N);
    force.setRange(0.0, end_s(), 0.0, endOf(std::max(sent_N, asked_N), kMinForce_N));
  }

  /// One scale for all three axes, so that their stiffnesses can be compared.
  void fillAlong() {
    double away_mm = kMinAway_mm, along_N = kMinForce_N;
    for (std::size_t axis = 0; axis < along.size(); ++axis) {
      thinSessionPath(rows(), axis, kPathGroups, along[axis].points(0));
      away_mm = std::max(away_mm, greatestOf(along[axis].points(0), &PlotPoint::x));
      along_N = std::max(along_N, greatestOf(along[axis].points(0), &PlotPoint::y));
    }
    away_mm = endOf(away_mm, kMinAway_mm);
    along_N = endOf(along_N, kMinForce_N);
    for (Chart& chart : along) chart.setRange(-away_mm, away_mm, -along_N, along_N);
  }

  void fillAngles() {
    against(
        angles, 0, [](const SessionRow& row) { return row.plot.alpha_deg; }, 180.0F);
    against(
        angles, 1, [](const SessionRow& row) { return row.plot.beta_deg; }, 180.0F);
    against(
        angles, 2, [](const SessionRow& row) { return row.plot.theta_deg; }, 180.0F);
    angles.setRange(0.0, end_s(), -180.0, 180.0);
  }

  void fillEnergy() {
    const std::size_t used = against(energy, 1, [](const SessionRow& row) { return row.plot.energy_mJ; });
    double max_mJ = 0.0, min_mJ = 0.0;
    for (const PlotPoint& point : energy.points(1).first(used)) {
      max_mJ = std::max(max_mJ, static_cast<double>(point.y));
      min_mJ = std::min(min_mJ, static_cast<double>(point.y));
    }
    std::fill(energy.points(0).begin(), energy.points(0).end(), PlotPoint{static_cast<float>(end_s()), 0.0F});
    energy.points(0)[0].x = 0.0F;
    const double top_mJ = endOf(max_mJ, kMinEnergy_mJ);
    energy.setRange(0.0, end_s(), min_mJ < 0.0 ? -endOf(-min_mJ, 0.1 * top_mJ) : -0.1 * top_mJ, top_mJ);
  }

  void fillLines(Chart& chart, const std::vector<SpectrumLine>& spectrum) const {
    const double max_hz = std::min(kMaxFrequency_hz, spectrum.empty() ? 1e9 : spectrum.back().frequency_hz);
    const std::span<PlotPoint> points = chart.points(0);
    std::size_t used = 0;
    double max_dB = kStep_dB;
    for (const SpectrumLine& line : spectrum) {
      if (line.frequency_hz > max_hz || used >= points.size()) break;
      const double level_dB = std::max(kPerUnit_dB + 20.0 * std::log10(std::max(line.amplitude, 1e-9)), kMin_dB);
      max_dB = std::max(max_dB, level_dB);
      points[used++] = {static_cast<float>(line.frequency_hz), static_cast<float>(level_dB)};
    }
    std::fill(points.begin() + static_cast<std::ptrdiff_t>(used), points.end(),
              used > 0 ? points[used - 1] : PlotPoint{});
    chart.setRange(0.0, max_hz, kMin_dB, kStep_dB * std::ceil(max_dB / kStep_dB));
  }

  void putCursor() {
    if (isAgainstTime()) {
      for (Chart* chart : shown()) {
        const auto [from, to] = chart->yRange();
        putLine(chart->points(chart->curves() - 1), cursor_s, from, to);
      }
    } else if (kind == SessionPlotKind::ForceAgainstDisplacement) {
      const SessionRow* row = rowAt(cursor_s);
      for (std::size_t axis = 0; axis < along.size(); ++axis) {
        const std::span<PlotPoint> points = along[axis].points(1);
        const double x = row != nullptr ? static_cast<double>(row->plot.away_mm[axis]) : 0.0;
        const double y = row != nullptr ? static_cast<double>(row->plot.force_N[axis]) : 0.0;
        const double arm = 0.06 * along[axis].yRange().second;
        putLine(points, x, y - arm, y + arm);
      }
    }
  }

  const SessionRow* rowAt(double time_s) const {
    const auto found = std::lower_bound(rows().begin(), rows().end(), time_s - 1e-9,
                                        [](const SessionRow& row, double wanted) { return row.plot.time_s < wanted; });
    return found == rows().end() ? (rows().empty() ? nullptr : &rows().back()) : &*found;
  }

  SessionPlot* plot;
  std::shared_ptr<const SessionData> data;
  SessionPlotKind kind = SessionPlotKind::ErrorAndForce;
  std::shared_ptr<const ColumnRows> column_rows;
  Chart columns = columnChart({});
  Theme theme = Theme::light();
  double cursor_s = 0.0;
  bool cursor_changed = true;
  Chart error{SessionPlot::tr("Error [mm]"), SessionPlot::tr("time [s]"), {{QString(), 1.5F}, {QString(), 1.0F}}};
  Chart force{SessionPlot::tr("Force [N]"),
              SessionPlot::tr("time [s]"),
              {{SessionPlot::tr("commanded"), 1.0F}, {SessionPlot::tr("sent"), 2.0F}, {QString(), 1.0F}}};
  std::array<Chart, 3> along{Chart{SessionPlot::tr("Force along x [N]"),
                                   SessionPlot::tr("displacement [mm]"),
                                   {{QString(), 1.5F}, {QString(), 2.0F}}},
                             Chart{SessionPlot::tr("Force along y [N]"),
                                   SessionPlot::tr("displacement [mm]"),
                                   {{QString(), 1.5F}, {QString(), 2.0F}}},
                             Chart{SessionPlot::tr("Force along z [N]"),
                                   SessionPlot::tr("displacement [mm]"),
                                   {{QString(), 1.5F}, {QString(), 2.0F}}}};
  Chart angles{SessionPlot::tr("Angle [°]"),
               SessionPlot::tr("time [s]"),
               {{SessionPlot::tr("α stylus"), 1.5F, true},
                {SessionPlot::tr("β tip"), 1.5F},
                {SessionPlot::tr("θ target"), 2.5F},
                {QString(), 1.0F}}};
  Chart energy{SessionPlot::tr("Energy [mJ]"),
               SessionPlot::tr("time [s]"),
               {{QString(), 1.0F}, {SessionPlot::tr("stored"), 2.0F}, {QString(), 1.0F}}};
  Chart force_lines{SessionPlot::tr("Force [dB re 1 mN]"), SessionPlot::tr("frequency [Hz]"), {{QString(), 1.5F}}};
  Chart error_lines{SessionPlot::tr("Error [dB re 1 µm]"), SessionPlot::tr("frequency [Hz]"), {{QString(), 1.5F}}};
};

SessionPlot::SessionPlot(QWidget* parent) : ChartWidget(parent), impl_(std::make_unique<Impl>(this)) {
  setObjectName("panel.session.plot");
  setAccessibleName(tr("Plots of the whole session"));
  setAccessibleDescription(
      tr("Error and force, force against displacement, angles, energy or spectrum, as selected above."));
  setMinimumSize(240, 96);
  setTheme(Theme::light());
}

SessionPlot::~SessionPlot() = default;

void SessionPlot::setSession(std::shared_ptr<const SessionData> session) {
  impl_->data = std::move(session);
  impl_->cursor_s = 0.0;
  placeAnew();
}

void SessionPlot::setKind(SessionPlotKind kind) {
  impl_->kind = kind;
  placeAnew();
}

void SessionPlot::setColumns(std::shared_ptr<const ColumnRows> rows) {
  impl_->column_rows = std::move(rows);
  impl_->columns = columnChart(impl_->column_rows ? impl_->column_rows->columns() : std::vector<int>{});
  setColumnColours(impl_->columns, impl_->theme);
  placeAnew();
}

SessionPlotKind SessionPlot::kind() const {
  return impl_->kind;
}

void SessionPlot::setCursor(double time_s) {
  if (time_s == impl_->cursor_s) return;
  impl_->cursor_s = time_s;
  impl_->cursor_changed = true;
  if (impl_->kind != SessionPlotKind::Spectrum) draw();
}

void SessionPlot::setTheme(const Theme& theme) {
  Impl& my = *impl_;
  const QColor quiet = mixed(theme.background, theme.ink, 0.55);
  setBackground(theme);
  my.theme = theme;
  setColumnColours(my.columns, theme);
  my.error.setColours(theme, {theme.target, theme.ink});
  my.force.setColours(theme, {quiet, theme.force, theme.ink});
  for (Chart& chart : my.along) chart.setColours(theme, {theme.force, theme.ink});
  my.angles.setColours(theme, {theme.orientation, theme.position, theme.target, theme.ink});
  my.energy.setColours(theme, {theme.ink, theme.constraint, theme.ink});
  my.force_lines.setColours(theme, {theme.force});
  my.error_lines.setColours(theme, {theme.target});
  draw();
}

QPointF SessionPlot::placeOf(double time_s) const {
  return impl_->shown().front()->placeOf(time_s);
}

void SessionPlot::mousePressEvent(QMouseEvent* event) {
  ChartWidget::mousePressEvent(event);
  const bool is_plain = event->button() == Qt::LeftButton && !event->modifiers().testFlag(Qt::ShiftModifier);
  if (!is_plain || !isTaken(event->position())) return;
  for (const Chart* chart : impl_->shown()) {
    if (const std::optional<double> time_s = chart->xAt(event->position())) emit timeAsked(*time_s);
  }
}

void SessionPlot::mouseMoveEvent(QMouseEvent* event) {
  ChartWidget::mouseMoveEvent(event);
  const bool is_plain = event->buttons() == Qt::LeftButton && !event->modifiers().testFlag(Qt::ShiftModifier);
  if (!is_plain || !isTaken(event->position())) return;
  for (const Chart* chart : impl_->shown()) {
    if (const std::optional<double> time_s = chart->xAt(event->position())) emit timeAsked(*time_s);
  }
}

/// A click in a chart against time jumps there.
bool SessionPlot::isTaken(const QPointF&) const {
  return impl_->isAgainstTime() && impl_->data != nullptr;
}

std::vector<Chart*> SessionPlot::shown() const {
  return impl_->shown();
}

void SessionPlot::place(double scale) {
  impl_->place(scale);
}

void SessionPlot::prepare(bool placed) {
  impl_->prepare(placed);
}

}  // namespace underact::gui
