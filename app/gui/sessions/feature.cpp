#include "app/gui/feature/feature.h"

#include <QCoreApplication>

#include "app/gui/sessions/sessions_panel.h"

namespace underact::gui {

FeatureRow sessionsFeature() {
  return {.panels = {{"sessions", QT_TRANSLATE_NOOP("panel", "Sessions"), Qt::LeftDockWidgetArea,
                      QT_TRANSLATE_NOOP("panel", "Record, set markers, and find recorded sessions."),
                      [](const FeatureParts& all, QWidget* parent) -> Panel* {
                        return new SessionsPanel({all.actions, all.status, all.recording}, parent);
                      },
                      "scenes"}},
          .pages = {{"panel.sessions", "sessions"},
                    {"button.session.record", "sessions"},
                    {"dialog.delete_session", "sessions"},
                    {"dialog.remove_session", "sessions#find-and-use"},
                    {"dialog.save_session", "sessions"},
                    {"dialog.session_folder", "sessions"},
                    {"dialog.words", "sessions"}}};
}

}  // namespace underact::gui
