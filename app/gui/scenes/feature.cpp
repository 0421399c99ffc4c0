#include "app/gui/feature/feature.h"

#include <QCoreApplication>

#include "app/gui/scenes/scenes_panel.h"

namespace underact::gui {

FeatureRow scenesFeature() {
  return {.panels = {{"scenes", QT_TRANSLATE_NOOP("panel", "Scenes"), Qt::LeftDockWidgetArea, "Ctrl+Alt+1",
                      QT_TRANSLATE_NOOP("panel", "The scenes that come with the program, and your own."),
                      makePanel<ScenesPanel>}},
          .pages = {{"panel.scenes", "window#scenes"}}};
}

}  // namespace underact::gui
