#include "app/gui/feature/feature.h"

#include <QCoreApplication>

#include "app/gui/arm/arm_panel.h"

namespace underact::gui {

FeatureRow armFeature() {
  return {.panels = {{"arm", QT_TRANSLATE_NOOP("panel", "Arm"), Qt::RightDockWidgetArea, "Ctrl+Alt+4",
                      QT_TRANSLATE_NOOP("panel", "Joint angles, tip position and faults of the arm."),
                      [](const FeatureParts&, QWidget* parent) -> Panel* { return new ArmPanel(parent); }}},
          .pages = {{"panel.arm", "window#arm"}}};
}

}  // namespace underact::gui
