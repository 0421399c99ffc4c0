#include "app/gui/identify/swing_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/gui/plot/chart.h"
#include "app/gui/plot/plot_range.h"

namespace underact::gui {
namespace {

constexpr std::size_t kSwingPoints = 2000;
constexpr std::size_t kTarget = 0, kMeasuredSwing = 1, kSwingFit = 2;
constexpr float kGap = std::numeric_limits<float>::quiet_NaN();

/// Takes every n-th point, so that they fit into the curve, and fills the rest with gaps.
void fill(std::span<PlotPoint> into, const std::vector<SwingPoint>& from) {
  const std::size_t every = from.size() / into.size() + 1;
  std::size_t used = 0;
  for (std::size_t index = 0; index < from.size() && used < into.size(); ++index) {
    const bool is_gap = !std::isfinite(from[index].travel_mm);
    if (index % every != 0 && !is_gap) continue;
    into[used++] = {static_cast<float>(from[index].t_s), is_gap ? kGap : static_cast<float>(from[index].travel_mm)};
  }
  std::fill(into.begin() + static_cast<std::ptrdiff_t>(used), into.end(), PlotPoint{kGap, kGap});
}

}  // namespace

struct SwingPlot::Impl {
  void draw(const SwingPicture& picture) {
    fill(chart.points(kTarget), picture.target);
    fill(chart.points(kMeasuredSwing), picture.measured);
    fill(chart.points(kSwingFit), picture.fit);
    chart.setCurveShown(kSwingFit, !picture.fit.empty());
    double from_s = 0.0, to_s = 1.0, min_mm = -1.0, max_mm = 1.0;
    if (!picture.measured.empty()) {
      from_s = picture.measured.front().t_s;
      to_s = std::max(from_s + 0.1, picture.measured.back().t_s);
      min_mm = max_mm = picture.measured.front().travel_mm;
    }
    for (const std::vector<SwingPoint>* points : {&picture.target, &picture.measured, &picture.fit}) {
      for (const SwingPoint& point : *points) {
        if (!std::isfinite(point.travel_mm)) continue;
        min_mm = std::min(min_mm, point.travel_mm);
        max_mm = std::max(max_mm, point.travel_mm);
      }
    }
    const double room_mm = std::max(0.5, 0.08 * (max_mm - min_mm));
    chart.setTitle(SwingPlot::tr("Tip along %1 [mm]").arg(QLatin1Char(picture.axis)));
    chart.setRange(from_s, to_s, min_mm - room_mm, max_mm + room_mm);
  }

  Chart chart{SwingPlot::tr("Tip along x [mm]"),
              SwingPlot::tr("time [s]"),
              {{SwingPlot::tr("target"), 1.0F},
               {SwingPlot::tr("measured"), 2.5F},
               {SwingPlot::tr("fitted model"), 1.5F, true}}};
};

SwingPlot::SwingPlot(const QString& object_name, QWidget* parent)
    : ChartWidget(parent), impl_(std::make_unique<Impl>()) {
  setObjectName(object_name);
  setAccessibleName(tr("Swings of the tip"));
  setToolTip(
      tr("The tip is pulled towards the target and swings. The dashed line is the fitted model: a mass with friction "
         "and damping under the force that was sent."));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::MinimumExpanding);
  impl_->chart.reserve(kSwingPoints);
  impl_->draw({});
  setTheme(Theme::light());
}

SwingPlot::~SwingPlot() = default;

QSize SwingPlot::minimumSizeHint() const {
  return {20 * fontMetrics().averageCharWidth(), 8 * fontMetrics().lineSpacing()};
}

void SwingPlot::present(const SwingPicture& picture) {
  impl_->draw(picture);
  setAccessibleDescription(tr("%1 points along %2").arg(picture.measured.size()).arg(QLatin1Char(picture.axis)));
  placeAnew();  // the names in the legend may have changed
}

void SwingPlot::setTheme(const Theme& theme) {
  setBackground(theme);
  impl_->chart.setColours(theme, {mixed(theme.background, theme.ink, 0.5), theme.constraint, theme.force_limited});
  draw();
}

std::vector<Chart*> SwingPlot::shown() const {
  return {&impl_->chart};
}

void SwingPlot::place(double scale) {
  impl_->chart.setPlace(rect(), scale, font());
}

}  // namespace underact::gui
