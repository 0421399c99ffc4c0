#include "app/gui/window/purpose.h"

#include <QCoreApplication>
#include <algorithm>

namespace underact::gui {

bool Purpose::hasInMenus(const QString& action) const {
  return std::any_of(menus.begin(), menus.end(), [&action](const QString& begin) { return action.startsWith(begin); });
}

const std::vector<Purpose>& purposes() {
  // What everybody does.
  static const QStringList kCommon{"scene.open",    "scenes.",       "app.",         "edit.",
                                   "gains.",        "session.start", "session.stop", "hand.",
                                   "servo.restart", "servo.fault",   "devices.",     "view.",
                                   "layer.",        "language.",     "help.",        "scene.left_handed"};
  static const std::vector<Purpose> kAll{
      {"demonstrate",
       QT_TRANSLATE_NOOP("purpose", "Demonstrate"),
       QT_TRANSLATE_NOOP("purpose", "Let visitors feel scenes."),
       {"scenes", "feel", "shape", "devices", "hands"},
       {"scenes", "feel"},
       {"hand.keep", "view.fit", "visitor.start", "help.guide"},
       kCommon + QStringList{"session.hold_to_run", "visitor.", "compare.", "second.", "registration.", "mesh.add"}},
      {"teach",
       QT_TRANSLATE_NOOP("purpose", "Teach"),
       QT_TRANSLATE_NOOP("purpose", "Explain kinematics and haptics to a class, with lessons."),
       {"lessons", "scenes", "kinematics", "dh", "robot", "feel"},
       {"lessons", "feel"},
       {"hand.keep", "view.fit", "menu.layers", "help.guide"},
       kCommon + QStringList{"lesson.", "ghost.", "section.", "scene.save_as"}},
      {"research",
       QT_TRANSLATE_NOOP("purpose", "Research"),
       QT_TRANSLATE_NOOP("purpose", "Record, measure and compare."),
       {"scenes", "feel", "plots", "sessions", "lab", "servo"},
       {"scenes", "feel", "sessions"},
       {"hand.keep", "session.record", "menu.layers", "help.guide"},
       kCommon + QStringList{"scene.", "mesh.", "curve.", "live.", "service.", "session", "servo.", "second.",
                             "registration.", "identify.", "arm.", "calibration.", "replay.", "ghost.", "section.",
                             "compare."}}};
  return kAll;
}

const Purpose& purposeOf(const QString& key) {
  const std::vector<Purpose>& all = purposes();
  const auto found = std::find_if(all.begin(), all.end(), [&key](const Purpose& one) { return key == one.key; });
  return found == all.end() ? all.front() : *found;
}

}  // namespace underact::gui
