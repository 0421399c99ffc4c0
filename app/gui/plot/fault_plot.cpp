#include "app/gui/plot/fault_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/gui/plot/chart.h"
#include "app/gui/plot/plot_range.h"

namespace underact::gui {
namespace {

constexpr double kFaultMinForce_N = 0.2, kMinLateness_us = 100.0;
constexpr double kFaultAskedShown = 3.0;  // times the greatest force sent: the commanded force has no limit
constexpr double kFaultRoom = 1.05;

float finiteOrNone(double value) {
  return std::isfinite(static_cast<float>(value)) ? static_cast<float>(value) : std::numeric_limits<float>::quiet_NaN();
}

double greatestY(std::span<const PlotPoint> points) {
  float greatest = 0.0F;
  for (const PlotPoint& point : points) {
    if (std::isfinite(point.y)) greatest = std::max(greatest, point.y);
  }
  return static_cast<double>(greatest);
}

}  // namespace

struct FaultPlot::Impl {
  Chart force{FaultPlot::tr("Force [N]"),
              FaultPlot::tr("time [s]"),
              {{FaultPlot::tr("commanded"), 1.0F}, {FaultPlot::tr("sent"), 2.0F}}};
  Chart lateness{FaultPlot::tr("Latency [µs]"), FaultPlot::tr("time [s]"), {{QString(), 1.5F}}};
};

FaultPlot::FaultPlot(QWidget* parent) : ChartWidget(parent), impl_(std::make_unique<Impl>()) {
  setObjectName("dialog.fault.plot");
  setAccessibleName(tr("The second before the fault"));
  setToolTip(tr("Force and latency of the ticks before the fault, which is at the right edge."));
  setMinimumSize(240, 140);
  setTheme(Theme::light());
}

FaultPlot::~FaultPlot() = default;

void FaultPlot::setTicks(const std::vector<servo::TickRecord>& ticks, int rate_hz) {
  Impl& my = *impl_;
  const std::size_t count = std::max<std::size_t>(ticks.size(), 1);
  my.force.reserve(count);
  my.lateness.reserve(count);
  for (std::size_t index = 0; index < ticks.size(); ++index) {
    const servo::TickRecord& tick = ticks[index];
    const auto time_s = static_cast<float>(static_cast<double>(tick.tick - ticks.back().tick) / rate_hz);
    my.force.points(0)[index] = {time_s, finiteOrNone(tick.f_asked_T_W.norm())};
    my.force.points(1)[index] = {time_s, finiteOrNone(tick.f_sent_T_W.norm())};
    my.lateness.points(0)[index] = {time_s, finiteOrNone(1e-3 * static_cast<double>(tick.lateness_ns))};
  }
  const double sent_N = std::max(greatestY(my.force.points(1)), kFaultMinForce_N);
  const double asked_N = std::min(greatestY(my.force.points(0)), kFaultAskedShown * sent_N);
  const double late_us = std::max(greatestY(my.lateness.points(0)), kMinLateness_us);
  my.force.setRange(-1.0, 0.0, 0.0, roundUp(kFaultRoom * std::max(sent_N, asked_N)));
  my.lateness.setRange(-1.0, 0.0, 0.0, roundUp(kFaultRoom * late_us));
  draw();
}

void FaultPlot::setTheme(const Theme& theme) {
  Impl& my = *impl_;
  setBackground(theme);
  my.force.setColours(theme, {mixed(theme.background, theme.ink, 0.55), theme.force});
  my.lateness.setColours(theme, {mixed(theme.background, theme.ink, 0.7)});
  draw();
}

std::vector<Chart*> FaultPlot::shown() const {
  return {&impl_->force, &impl_->lateness};
}

void FaultPlot::place(double scale) {
  const double half = 0.5 * width(), high = height();
  impl_->force.setPlace({0.0, 0.0, half, high}, scale, font());
  impl_->lateness.setPlace({half, 0.0, half, high}, scale, font());
}

}  // namespace underact::gui
