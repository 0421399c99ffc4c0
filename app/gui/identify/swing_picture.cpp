#include "app/gui/identify/swing_picture.h"

#include "core/base/units.h"

namespace underact::gui {
namespace {

template <class Travel>
std::vector<SwingPoint> inWindows(const std::vector<identify::Window>& windows, const Travel& travelOf) {
  std::vector<SwingPoint> points;
  for (std::size_t index = 0; index < windows.size(); ++index) {
    const identify::Window& window = windows[index];
    const std::vector<double>& travel_m = travelOf(index);
    for (std::size_t row = 0; row < travel_m.size(); ++row) {
      const double t_s = window.period_s * static_cast<double>(window.first_row + row);
      points.push_back({t_s, kMillimetrePerMetre * (travel_m[row] + window.origin_m)});
    }
    if (!points.empty()) points.push_back({points.back().t_s, kNotANumber});
  }
  return points;
}

}  // namespace

std::vector<SwingPoint> pointsOf(const std::vector<identify::Window>& windows,
                                 const std::vector<std::vector<double>>& travel_m) {
  return inWindows(windows, [&](std::size_t index) -> const std::vector<double>& { return travel_m[index]; });
}

SwingPicture pictureOf(const identify::AxisSwings& swings) {
  SwingPicture picture;
  picture.axis = "xyz"[swings.axis];
  picture.fit = pointsOf(swings.windows, swings.fit.travel_m);
  const auto own = [&](std::size_t index) -> const std::vector<double>& { return swings.windows[index].travel_m; };
  const auto target = [&](std::size_t index) -> const std::vector<double>& { return swings.windows[index].target_m; };
  picture.measured = inWindows(swings.windows, own);
  picture.target = inWindows(swings.windows, target);
  return picture;
}

}  // namespace underact::gui
