#include "app/gui/step/step_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/gui/kit/words.h"
#include "app/gui/plot/chart.h"
#include "app/gui/plot/plot_range.h"
#include "core/base/units.h"
#include "core/lab/unit_step.h"

namespace underact::gui {
namespace {

constexpr std::size_t kCurvePoints = 600;
constexpr double kStepRoom = 1.08;
constexpr double kMarkWide = 0.025, kMarkHigh = 0.07;  // half a cross, shares of the s-plane's chart
// Curves of the chart against time.
constexpr std::size_t kTimeMarks = 0, kFirst = 1, kMeasuredCurve = kFirst + StepPlot::kMaxResponses,
                      kFitCurve = kMeasuredCurve + 1;
// Curves of the s-plane.
constexpr std::size_t kAxes = 0, kPoles = 1, kZeros = 2;

constexpr float kCurveGap = std::numeric_limits<float>::quiet_NaN();

float plotted(double value) {
  return std::isfinite(static_cast<float>(value)) ? static_cast<float>(value) : kCurveGap;
}

/// Fills a curve with strokes, each followed by a gap; the rest of the points are gaps.
class Strokes {
 public:
  explicit Strokes(std::span<PlotPoint> points) : points_(points) {}
  ~Strokes() {
    while (used_ < points_.size()) points_[used_++] = {kCurveGap, kCurveGap};
  }
  void line(double x_from, double y_from, double x_to, double y_to) {
    to(x_from, y_from);
    to(x_to, y_to);
    end();
  }
  void to(double x, double y) { put({plotted(x), plotted(y)}); }
  void end() { put({kCurveGap, kCurveGap}); }

 private:
  void put(PlotPoint point) {
    if (used_ < points_.size()) points_[used_++] = point;
  }
  std::span<PlotPoint> points_;
  std::size_t used_ = 0;
};

std::vector<Chart::Curve> timeCurves() {
  std::vector<Chart::Curve> curves(kFitCurve + 1);
  curves[kTimeMarks] = {StepPlot::tr("2 % band, peak, settling"), 1.0F, true};
  for (std::size_t curve = kFirst; curve < kMeasuredCurve; ++curve) curves[curve] = {QString(), 1.5F};
  curves[kFirst].width = 2.0F;
  curves[kMeasuredCurve] = {StepPlot::tr("measured"), 1.5F};
  curves[kFitCurve] = {StepPlot::tr("fit"), 1.5F, true};
  return curves;
}

}  // namespace

struct StepPlot::Impl {
  void drawTime(const StepPicture& shown) {
    double min = 0.0, max = 0.0;
    const auto fill = [&](std::size_t curve, bool there, const auto& valueAt) {
      for (std::size_t index = 0; index < kCurvePoints; ++index) {
        const double t_s = shown.seconds * static_cast<double>(index) / (kCurvePoints - 1);
        const double y = there ? valueAt(t_s) : std::numeric_limits<double>::quiet_NaN();
        time.points(curve)[index] = {plotted(t_s), plotted(y)};
        if (!std::isfinite(y)) continue;
        min = std::min(min, y);
        max = std::max(max, y);
      }
      time.setCurveShown(curve, there);
    };
    for (std::size_t one = 0; one < kMaxResponses; ++one) {
      const bool there = one < shown.responses.size();
      time.setCurveName(kFirst + one, there ? shown.responses[one].name : QString());
      const lab::UnitStep step(there ? shown.responses[one].transfer : lab::TransferFunction{{1.0}, {1.0, 1.0}});
      fill(kFirst + one, there, [&](double t_s) { return step.at(t_s); });
    }
    fill(kMeasuredCurve, shown.measured.has_value(), [&](double t_s) {
      const auto index = static_cast<std::size_t>(std::lround(t_s / shown.measured->period_s));
      const std::vector<double>& value = shown.measured->value;
      return index < value.size() ? value[index] : std::numeric_limits<double>::quiet_NaN();
    });
    fill(kFitCurve, shown.fit.has_value(), [&](double t_s) {
      return shown.fit->gain * lab::secondOrderAt(shown.fit->omega_n_rad_per_s, shown.fit->zeta, t_s);
    });
    if (max <= min) max = min + 1.0;
    drawMarks(shown, kStepRoom * max);
    const double low = min < -1e-3 * max ? kStepRoom * min : 0.0;
    time.setRange(0.0, shown.seconds, low, kStepRoom * max);
  }

  void drawMarks(const StepPicture& shown, double top) {
    const lab::StepMetrics& metrics = shown.metrics;
    const bool one = shown.responses.size() == 1 && metrics.final_value.value_or(0.0) != 0.0;
    time.setCurveShown(kTimeMarks, one);
    Strokes strokes(time.points(kTimeMarks));
    if (!one) return;
    const double final_value = *metrics.final_value;
    for (const double share : {0.98, 1.02}) strokes.line(0.0, share * final_value, shown.seconds, share * final_value);
    for (const std::optional<double>& at_s : {metrics.peak_time_s, metrics.settling_2pct_s}) {
      if (at_s && *at_s < shown.seconds) strokes.line(*at_s, 0.0, *at_s, std::min(top, 1.02 * final_value));
    }
  }

  void drawPlane(const StepPicture& shown) {
    std::vector<std::complex<double>> zeros;
    std::vector<std::complex<double>> poles;
    if (!shown.responses.empty()) {
      const lab::TransferFunction& first = shown.responses.front().transfer;
      poles = lab::poles(first);
      if (first.num.size() > 1) zeros = lab::poles({{1.0}, first.num});  // the roots of the numerator
    }
    double left = 0.0, right = 0.0, high = 0.0;
    for (const auto* roots : {&poles, &zeros}) {
      for (const std::complex<double>& root : *roots) {
        left = std::min(left, root.real());
        right = std::max(right, root.real());
        high = std::max(high, std::abs(root.imag()));
      }
    }
    const double size = std::max({-left, right, high, 1e-9});
    const double x_from = -roundUp(1.2 * std::max(-left, 0.25 * size)),
                 x_to = roundUp(1.2 * std::max(right, 0.25 * size));
    const double y_to = roundUp(1.3 * std::max(high, 0.3 * size));
    const double half_x = kMarkWide * (x_to - x_from), half_y = kMarkHigh * 2.0 * y_to;
    {
      Strokes axes(plane.points(kAxes));
      axes.line(x_from, 0.0, x_to, 0.0);
      axes.line(0.0, -y_to, 0.0, y_to);
      Strokes crosses(plane.points(kPoles));
      for (const std::complex<double>& pole : poles) {
        const double x = pole.real(), y = pole.imag();
        crosses.line(x - half_x, y - half_y, x + half_x, y + half_y);
        crosses.line(x - half_x, y + half_y, x + half_x, y - half_y);
      }
      Strokes rings(plane.points(kZeros));
      for (const std::complex<double>& zero : zeros) {
        for (int turn = 0; turn <= 16; ++turn) {
          const double angle_rad = turn * kPi / 8.0;
          rings.to(zero.real() + half_x * std::cos(angle_rad), zero.imag() + half_y * std::sin(angle_rad));
        }
        rings.end();
      }
    }
    plane.setCurveShown(kZeros, !zeros.empty());
    plane.setRange(x_from, x_to, -y_to, y_to);
  }

  Chart time{StepPlot::tr("Response to a unit step"), StepPlot::tr("time [s]"), timeCurves()};
  Chart plane{StepPlot::tr("Imaginary part [rad/s]"),
              StepPlot::tr("real part [rad/s]"),
              {{QString(), 1.0F}, {StepPlot::tr("× pole"), 2.0F}, {StepPlot::tr("○ zero"), 1.5F}}};
};

StepPlot::StepPlot(QWidget* parent) : ChartWidget(parent), impl_(std::make_unique<Impl>()) {
  impl_->plane.setPaths();
  setObjectName("panel.step.plot");
  setAccessibleName(tr("Step response and poles"));
  setToolTip(
      tr("Above: the response to a unit step. Below: poles and zeros in the s-plane; poles to the left of the "
         "imaginary axis decay, the faster the farther away."));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::MinimumExpanding);
  impl_->time.reserve(kCurvePoints);
  impl_->plane.reserve(kCurvePoints);
  setTheme(Theme::light());
}

StepPlot::~StepPlot() = default;

QSize StepPlot::minimumSizeHint() const {
  return {240, 16 * fontMetrics().lineSpacing()};
}

void StepPlot::present(const StepPicture& picture) {
  impl_->drawTime(picture);
  impl_->drawPlane(picture);
  const std::optional<double>& overshoot = picture.metrics.overshoot_fraction;
  setAccessibleDescription(overshoot ? tr("Overshoot %1 %").arg(numberText(100.0 * *overshoot, 1))
                                     : tr("No final value"));
  placeAnew();  // the names in the legend have changed
}

void StepPlot::setTheme(const Theme& theme) {
  Impl& my = *impl_;
  setBackground(theme);
  my.time.setColours(theme,
                     {mixed(theme.background, theme.ink, 0.5), theme.constraint, theme.force_limited, theme.target,
                      theme.position, theme.force, theme.orientation, theme.ink, theme.force_limited});
  my.plane.setColours(theme, {mixed(theme.background, theme.ink, 0.6), theme.constraint, theme.target});
  draw();
}

std::vector<Chart*> StepPlot::shown() const {
  return {&impl_->time, &impl_->plane};
}

void StepPlot::place(double scale) {
  const double wide = width(), high = height(), upper = std::round(0.56 * high);
  impl_->time.setPlace({0.0, 0.0, wide, upper}, scale, font());
  impl_->plane.setPlace({0.0, upper, wide, high - upper}, scale, font());
}

}  // namespace underact::gui
