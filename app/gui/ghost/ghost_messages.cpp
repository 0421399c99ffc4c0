#include "app/gui/ghost/ghost_messages.h"

#include <QFileInfo>
#include <QWidget>

#include "app/gui/ghost/ghost_hand.h"
#include "app/gui/kit/problems_dialog.h"
#include "app/gui/kit/words.h"

namespace underact::gui {

void connectGhostMessages(GhostHand& ghost, QWidget* window) {
  const auto tell = [window](const QString& what, const Problems& problems) {
    showProblemsBox("dialog.session_problems", tr("Recorded session"), what, problems, window);
  };
  QObject::connect(&ghost, &GhostHand::opened, window, [&ghost, tell] {
    const LoadedGhost& read = ghost.ghost();
    if (read.damage.empty()) return;
    tell(tr("“%1” is damaged. You follow the part that could be read.").arg(QString::fromStdString(read.name)),
         read.damage);
  });
  QObject::connect(&ghost, &GhostHand::failed, window, [tell](const QString& path, const Problems& problems) {
    tell(tr("“%1” cannot be followed. Nothing has changed.").arg(QFileInfo(path).fileName()), problems);
  });
}

}  // namespace underact::gui
