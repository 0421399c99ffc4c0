#include "app/gui/feature/feature.h"

#include <QCoreApplication>

#include "app/gui/scenes/scenes_panel.h"

namespace underact::gui {

FeatureRow scenesFeature() {
  return {.panels = {{"scenes", QT_TRANSLATE_NOOP("panel", "Scenes"), Qt::LeftDockWidgetArea,
                      QT_TRANSLATE_NOOP("panel", "The scenes that come with the program, and your own."),
                      [](const FeatureParts& all, QWidget* parent) -> Panel* {
                        return new ScenesPanel({all.document, all.recent, all.actions}, parent);
                      }}},
          .pages = {{"panel.scenes", "window#scenes"}}};
}

}  // namespace underact::gui
