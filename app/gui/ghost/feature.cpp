#include "app/gui/feature/feature.h"

#include <QBoxLayout>
#include <QMainWindow>

#include "app/gui/ghost/ghost_actions.h"
#include "app/gui/ghost/ghost_hand.h"
#include "app/gui/ghost/ghost_messages.h"
#include "app/gui/ghost/ghost_strip.h"
#include "app/gui/kit/actions.h"

namespace underact::gui {
namespace {

void makeGhost(const FeatureParts& parts, ServoListeners& listeners) {
  auto* ghost = new GhostHand(parts.document, parts.player, parts.loads, parts.view, parts.window);
  addGhostActions(parts.actions, *ghost, parts.document, parts.files, parts.window);
  connectGhostMessages(*ghost, parts.window);
  QObject::connect(&parts.actions, &Actions::locked, ghost, &GhostHand::close);
  auto* strip = new GhostStrip(*ghost, parts.document, parts.actions, parts.middle.parentWidget());
  parts.middle.addWidget(strip);
  listeners.push_back(ghost);
  listeners.push_back(strip);
}

}  // namespace

FeatureRow ghostFeature() {
  return {
      .pages = {{"ghost", "classes#following-a-recorded-hand"}, {"dialog.follow", "classes#following-a-recorded-hand"}},
      .make = makeGhost};
}

}  // namespace underact::gui
