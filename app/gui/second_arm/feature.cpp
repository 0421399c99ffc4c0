#include "app/gui/feature/feature.h"

#include <QCoreApplication>

#include "app/gui/second_arm/second_arm_panel.h"

namespace underact::gui {

FeatureRow secondArmFeature() {
  return {.panels = {{"second", QT_TRANSLATE_NOOP("panel", "Second arm"), Qt::LeftDockWidgetArea,
                      QT_TRANSLATE_NOOP("panel", "Another arm beside the first, with a scene of its own."),
                      [](const FeatureParts& all, QWidget* parent) -> Panel* {
                        return new SecondArmPanel({all.actions, all.second}, parent);
                      },
                      "scenes"}},
          .pages = {{"panel.second", "devices#two-arms"}, {"dialog.second_scene", "devices#two-arms"}}};
}

}  // namespace underact::gui
