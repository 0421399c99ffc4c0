#include "app/gui/model/left_hand.h"

#include <QAction>
#include <QCoreApplication>

#include "app/gui/kit/actions.h"
#include "app/gui/model/document.h"

namespace underact::gui {

void addLeftHandAction(Actions& actions, Document& document) {
  const auto tr = [](const char* text) { return QCoreApplication::translate("underact::gui", text); };
  QAction* const action =
      actions.add({"scene.left_handed",
                   tr("&Left-handed"),
                   {},
                   tr("Mirrors every scene for the left hand; lessons and recordings are not mirrored."),
                   {},
                   {},
                   true},
                  [&document](const QVariantList& on) { return document.setLeftHanded(on.value(0).toBool()).empty(); });
  QObject::connect(&document, &Document::leftHandedChanged, action, &QAction::setChecked);  // undo changes it, too
}

}  // namespace underact::gui
