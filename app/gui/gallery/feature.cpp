#include "app/gui/feature/feature.h"

#include <QMainWindow>

#include "app/gui/gallery/gallery_actions.h"

namespace underact::gui {
namespace {

void makeGallery(const FeatureParts& parts, ServoListeners&) {
  addGalleryActions(parts.actions, parts.window);
}

}  // namespace

FeatureRow galleryFeature() {
  return {.pages = {{"dialog.figures", "python#the-figures-of-the-thesis"}},
          .make = makeGallery,
          .opens = FileKind::Figures,
          .open_action = "figures.open"};
}

}  // namespace underact::gui
