#include "app/gui/feature/feature.h"

#include <QCoreApplication>

#include "app/gui/calibration/calibration_panel.h"

namespace underact::gui {

FeatureRow calibrationFeature() {
  return {
      .panels = {{"calibration", QT_TRANSLATE_NOOP("panel", "Threshold"), Qt::LeftDockWidgetArea, "Ctrl+Alt+8",
                  QT_TRANSLATE_NOOP(
                      "panel", "Measures the smallest difference of stiffness that a hand can feel, with two beams."),
                  [](const FeatureParts& all, QWidget* parent) -> Panel* {
                    return new CalibrationPanel({all.servo, all.document, all.actions}, parent);
                  },
                  "scenes"}},
      .pages = {{"panel.calibration", "calibration"}, {"dialog.save_calibration", "calibration"}}};
}

}  // namespace underact::gui
