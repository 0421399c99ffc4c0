#include "app/gui/model/made_curves.h"

#include <QCoreApplication>
#include <utility>

#include "core/scene/compile.h"

namespace underact::gui {

std::vector<target::CurvePath> madeCurves(const scene::Description& scene, const Watch& watch) {
  std::vector<target::CurvePath> made;
  for (const scene::Constraint& constraint : scene.constraints) {
    const auto* const curve = std::get_if<scene::Curve>(&constraint.shape);
    if (curve == nullptr || curve->points == nullptr || watch.isCancelled()) continue;
    watch.tell(QT_TRANSLATE_NOOP("step of work", "Joining the points"), 1.0);
    auto path = scene::makeCurvePath(*curve, constraint.place);
    if (path) made.push_back(std::move(path).value());  // else compile() says what is wrong with it
  }
  return made;
}

}  // namespace underact::gui
