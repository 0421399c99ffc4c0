#include "app/gui/ghost/ghost_drawing.h"

#include <QObject>

#include "app/gui/kit/words.h"
#include "core/base/units.h"

namespace underact::gui {

// About as far as one looks ahead when drawing; more of a path that crosses itself is a tangle.
constexpr double kAhead_s = 1.5;
constexpr std::size_t kPoints = 40;
constexpr double kFaintest = 0.4;  // opacity at the end

Drawing ghostDrawing(const ghost::Trajectory& trajectory, const ghost::State& state, const Vec3& p_WT) {
  Drawing drawing;
  const std::vector<Vec3> points = ghost::ahead(trajectory, state.time_s, kAhead_s, kPoints);
  for (std::size_t index = 1; index < points.size(); ++index) {
    const double share = static_cast<double>(index) / static_cast<double>(points.size());
    drawing.links.push_back({points[index - 1], points[index], false, 1.0 - (1.0 - kFaintest) * share});
  }
  const Vec3& p_WG = state.ghost.p_WG;
  drawing.links.push_back({p_WT, p_WG, true});
  drawing.styluses.push_back({p_WG, state.ghost.stylus_W});
  drawing.words.push_back(
      {QObject::tr("%1 mm").arg(numberText(kMillimetrePerMetre * state.distance_m, 0)), 0.5 * (p_WT + p_WG)});
  return drawing;
}

}  // namespace underact::gui
