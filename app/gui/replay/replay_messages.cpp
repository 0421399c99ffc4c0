#include "app/gui/replay/replay_messages.h"

#include <QFileInfo>

#include "app/gui/feature/status_line.h"
#include "app/gui/kit/problems_dialog.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/player.h"
#include "app/gui/view/hand.h"

namespace underact::gui {
namespace {

void tellOfReplay(QWidget* window, const QString& what, const Problems& problems) {
  showProblemsBox("dialog.session_problems", tr("Recorded session"), what, problems, window);
}

}  // namespace

void connectReplayMessages(Player& player, StatusLine& status, Hand& hand, QWidget* window) {
  QObject::connect(&player, &Player::opened, window, [&player, window, &status, &hand] {
    const device::Recorded& recorded = player.recorded();
    if (!recorded.damage.empty()) {
      tellOfReplay(window,
                   tr("“%1” is damaged. The readable part is replayed.").arg(QString::fromStdString(recorded.name)),
                   recorded.damage);
    }
    hand.setReplaying(true);
    status.presentDevice(true);
  });
  QObject::connect(&player, &Player::closed, window, [&status, &hand] {
    hand.setReplaying(false);
    status.presentDevice();
  });
  QObject::connect(&player, &Player::failed, window, [&player, window](const QString& path, const Problems& problems) {
    const QString file = QFileInfo(path).fileName();
    tellOfReplay(window,
                 player.isOpen() ? tr("A scene of “%1” cannot be run. Your previous scene stays open.").arg(file)
                                 : tr("“%1” was not opened. The scene and the arm are unchanged.").arg(file),
                 problems);
  });
}

}  // namespace underact::gui
