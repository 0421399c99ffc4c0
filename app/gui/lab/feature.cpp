#include "app/gui/feature/feature.h"

#include <QCoreApplication>

#include "app/gui/lab/lab_panel.h"

namespace underact::gui {

FeatureRow labFeature() {
  return {.panels = {{"lab", QT_TRANSLATE_NOOP("panel", "Lab"), Qt::LeftDockWidgetArea, "Ctrl+Alt+Q",
                      QT_TRANSLATE_NOOP(
                          "panel", "What each choice between speed and accuracy costs, and a slider along the best."),
                      makePanel<LabPanel>, "scenes"}},
          .pages = {{"panel.lab", "lab"}}};
}

}  // namespace underact::gui
