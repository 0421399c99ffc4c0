#include "app/gui/feature/feature.h"

#include <QMainWindow>

#include "app/gui/curve/curve_files.h"

namespace underact::gui {
namespace {

void makeCurve(const FeatureParts& parts, Followers&) {
  auto* files = new CurveFiles(parts.document, parts.files, parts.loads, parts.window);
  addCurveActions(parts.actions, *files);
}

}  // namespace

FeatureRow curveFeature() {
  return {.pages = {{"dialog.add_curve", "curves"}, {"dialog.curve", "curves"}, {"dialog.curve_problems", "curves"}},
          .make = makeCurve,
          .opens = isCurveFile,
          .open_action = "curve.add"};
}

}  // namespace underact::gui
