#include "app/gui/feature/feature.h"

#include <QCoreApplication>

#include "app/gui/servo/servo_panel.h"

namespace underact::gui {

FeatureRow servoFeature() {
  return {
      .panels =
          {{"servo", QT_TRANSLATE_NOOP("panel", "Servo"), Qt::LeftDockWidgetArea,
            QT_TRANSLATE_NOOP(
                "panel",
                "How evenly the servo loop runs, which limits reduce the force, and which scheduling is in effect."),
            [](const FeatureParts& all, QWidget* parent) -> Panel* {
              return new ServoPanel({all.servo, all.control, all.actions, all.rate, all.arms, all.settings}, parent);
            },
            "scenes"}},
      .pages = {{"panel.servo", "servo"}, {"panel.servo.scheduling", "real_time"}, {"dialog.check", "real_time"}}};
}

}  // namespace underact::gui
