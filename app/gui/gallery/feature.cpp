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
  return {.pages = {{"dialog.figures", "thesis_figures"}}, .make = makeGallery};
}

}  // namespace underact::gui
