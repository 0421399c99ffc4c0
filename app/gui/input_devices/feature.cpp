#include "app/gui/feature/feature.h"

#include <QCoreApplication>

#include "app/gui/input_devices/input_devices_panel.h"

namespace underact::gui {

FeatureRow inputDevicesFeature() {
  return {.panels = {{"hands", QT_TRANSLATE_NOOP("panel", "Input devices"), Qt::LeftDockWidgetArea,
                      QT_TRANSLATE_NOOP(
                          "panel",
                          "Mouse, game controllers and 3D mice: which are plugged in, and how they move the stylus."),
                      [](const FeatureParts& all, QWidget* parent) -> Panel* {
                        return new InputDevicesPanel({all.window, all.servo, all.actions, all.hand, all.hands}, parent);
                      },
                      "scenes"}},
          .pages = {{"panel.hands", "simulated_arm#controllers-joysticks-and-3d-mice"}}};
}

}  // namespace underact::gui
