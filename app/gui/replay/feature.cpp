#include "app/gui/feature/feature.h"

#include <QBoxLayout>
#include <QCoreApplication>
#include <QMainWindow>

#include "app/gui/replay/replay_actions.h"
#include "app/gui/replay/replay_bar.h"
#include "app/gui/replay/replay_messages.h"
#include "app/gui/replay/session_panel.h"

namespace underact::gui {
namespace {

void makeReplay(const FeatureParts& parts, ServoListeners& listeners) {
  addReplayActions(parts.actions, parts.player, parts.files, parts.window);
  connectReplayMessages(parts.player, parts.status, parts.hand, parts.window);
  auto* bar = new ReplayBar(parts.player, parts.actions, parts.middle.parentWidget());
  parts.middle.addWidget(bar);
  listeners.push_back(bar);
}

}  // namespace

FeatureRow replayFeature() {
  return {.panels = {{"session", QT_TRANSLATE_NOOP("panel", "Session plots"), Qt::BottomDockWidgetArea,
                      QT_TRANSLATE_NOOP(
                          "panel", "Plots of the whole session that is replayed: force, angles, energy, spectrum."),
                      [](const FeatureParts& all, QWidget* parent) -> Panel* {
                        return new SessionPanel({all.actions, all.view, all.player}, parent);
                      },
                      "plots"}},
          .pages = {{"panel.session", "sessions#replay"},
                    {"panel.replay", "sessions#replay"},
                    {"dialog.replay_files", "sessions#replay"},
                    {"dialog.session", "sessions"},
                    {"dialog.session_problems", "sessions#replay"}},
          .make = makeReplay,
          .opens = FileKind::Session,
          .open_action = "replay.open"};
}

}  // namespace underact::gui
