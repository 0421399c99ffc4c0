#include "app/gui/feature/feature.h"

#include <QCoreApplication>

#include "app/gui/shape/shape_panel.h"

namespace underact::gui {

FeatureRow shapeFeature() {
  return {.panels = {{"shape", QT_TRANSLATE_NOOP("panel", "Shape"), Qt::RightDockWidgetArea,
                      QT_TRANSLATE_NOOP("panel", "The geometry of the constraint in numbers, and the distance to it."),
                      [](const FeatureParts& all, QWidget* parent) -> Panel* {
                        return new ShapePanel({all.document, all.actions}, parent);
                      }}},
          .pages = {{"panel.shape", "window#shape"}}};
}

}  // namespace underact::gui
