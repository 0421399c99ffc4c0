#include "app/gui/feature/feature.h"

#include <QCoreApplication>

#include "app/gui/shape/shape_panel.h"

namespace underact::gui {

FeatureRow shapeFeature() {
  return {.panels = {{"shape", QT_TRANSLATE_NOOP("panel", "Shape"), Qt::RightDockWidgetArea, "Ctrl+Alt+3",
                      QT_TRANSLATE_NOOP("panel", "What the stylus is held to, in numbers."),
                      [](const FeatureParts& all, QWidget* parent) -> Panel* {
                        return new ShapePanel({all.document, all.actions}, parent);
                      }}},
          .pages = {{"panel.shape", "window#shape"}}};
}

}  // namespace underact::gui
