#include "app/gui/feature/feature.h"

#include <QMainWindow>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/words.h"
#include "app/gui/palette/palette.h"

namespace underact::gui {
namespace {

void makePalette(const FeatureParts& parts, ServoListeners&) {
  parts.actions.add({"help.find", tr("Find a &command…"), QKeySequence("Ctrl+Shift+P"),
                     tr("Finds commands, scenes, lessons, pages and settings by name."), "find"},
                    [&actions = parts.actions, window = parts.window](const QVariantList&) {
                      auto* const palette = new Palette(paletteEntries(actions, *window), window);
                      palette->open();
                      return true;
                    });
}

}  // namespace

FeatureRow paletteFeature() {
  return {.pages = {{"dialog.palette", "window#find-a-command"}}, .make = makePalette};
}

}  // namespace underact::gui
