#include "app/gui/feature/feature.h"

#include <QCoreApplication>

#include "app/gui/lab/lab_panel.h"

namespace underact::gui {

FeatureRow labFeature() {
  return {
      .panels =
          {{"lab", QT_TRANSLATE_NOOP("panel", "Lab"), Qt::LeftDockWidgetArea,
            QT_TRANSLATE_NOOP(
                "panel",
                "Measures what each choice between speed and accuracy costs, with a slider along the best trade-offs."),
            [](const FeatureParts& all, QWidget* parent) -> Panel* {
              return new LabPanel({all.document, all.actions, all.rate, all.arm_in_use}, parent);
            },
            "scenes"}},
      .pages = {{"panel.lab", "lab"}}};
}

}  // namespace underact::gui
