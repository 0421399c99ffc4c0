#include "app/gui/plot/plot_range.h"

#include <algorithm>
#include <cmath>

namespace underact::gui {
namespace {

constexpr double kRoom = 1.05;  // above the greatest value
constexpr double kShrinkAfter_s = 2.0;

}  // namespace

double roundUp(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (step * power >= value * (1.0 - 1e-9)) return step * power;
  }
  return 10.0 * power;
}

double PlotRange::update(double greatest, double time_s) {
  const double wanted = std::isfinite(greatest) ? std::max(min_, roundUp(std::max(kRoom * greatest, 1e-9))) : min_;
  if (wanted >= end_) {
    end_ = wanted;
    small_since_s_ = -1.0;
  } else if (small_since_s_ < 0.0 || time_s < small_since_s_) {
    small_since_s_ = time_s;
  } else if (time_s - small_since_s_ >= kShrinkAfter_s) {
    end_ = wanted;
    small_since_s_ = -1.0;
  }
  return end_;
}

namespace {

std::vector<double> placesAt(double from, double to, double step) {
  std::vector<double> places;
  for (double index = std::ceil(from / step - 1e-6); index * step <= to + 1e-6 * step; index += 1.0)
    places.push_back(index * step);
  return places;
}

}  // namespace

std::vector<double> ticks(double from, double to, int max) {
  return placesAt(from, to, roundUp(std::max((to - from) / std::max(max, 1), 1e-12)));
}

std::vector<double> multiples(double from, double to, double min, int max) {
  double step = min;
  while ((to - from) / step > std::max(max, 1)) step *= 2.0;
  return placesAt(from, to, step);
}

int decimalsOf(double step) {
  return std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 6);
}

}  // namespace underact::gui
