#include "app/gui/feature/feature.h"

#include <QCoreApplication>

#include "app/gui/devices/devices_panel.h"

namespace underact::gui {

FeatureRow devicesFeature() {
  return {.panels = {{"devices", QT_TRANSLATE_NOOP("panel", "Devices"), Qt::LeftDockWidgetArea,
                      QT_TRANSLATE_NOOP("panel", "Which arms are plugged in, what each lacks, and which is in use."),
                      [](const FeatureParts& all, QWidget* parent) -> Panel* {
                        return new DevicesPanel({all.servo, all.actions, all.arms, all.where_it_stands}, parent);
                      },
                      "scenes"}},
          .pages = {{"panel.devices", "devices#choosing-an-arm"}, {"dialog.fix", "devices"}}};
}

}  // namespace underact::gui
