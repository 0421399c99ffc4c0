#include "app/gui/feature/feature.h"

#include <QCoreApplication>

#include "app/gui/robot/robot_panel.h"

namespace underact::gui {

FeatureRow robotFeature() {
  return {.panels = {{"robot", QT_TRANSLATE_NOOP("panel", "Robot"), Qt::LeftDockWidgetArea,
                      QT_TRANSLATE_NOOP("panel", "The virtual robot: joints, springs, rotational stiffness, solver."),
                      [](const FeatureParts& all, QWidget* parent) -> Panel* {
                        return new RobotPanel({all.servo, all.document, all.actions}, parent);
                      },
                      "scenes"}},
          .pages = {{"panel.robot", "robots"}}};
}

}  // namespace underact::gui
