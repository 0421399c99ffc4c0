#include "app/gui/feature/feature.h"

#include <QCoreApplication>

#include "app/gui/step/step_panel.h"

namespace underact::gui {

FeatureRow stepFeature() {
  return {.panels = {{"step", QT_TRANSLATE_NOOP("panel", "Step response"), Qt::LeftDockWidgetArea,
                      QT_TRANSLATE_NOOP("panel",
                                        "How the tip follows a target that jumps: rise time, settling time, overshoot, "
                                        "poles, and the measured arm beside the model."),
                      [](const FeatureParts& all, QWidget* parent) -> Panel* {
                        return new StepPanel({all.servo, all.document, all.actions, all.rate, all.arm_in_use}, parent);
                      },
                      "scenes"}},
          .pages = {{"panel.step", "step_response"}}};
}

}  // namespace underact::gui
