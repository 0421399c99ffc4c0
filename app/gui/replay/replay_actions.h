#pragma once
#include <QString>

class QWidget;

namespace underact::gui {

class Actions;
class Player;
class SceneFiles;

/// Whether a file is called as sessions are.
bool isSession(const QString& path);

/// What can be done with a recorded session, by name: menu, keys, the bar and stories. Without a player that can replay
/// opening is refused.
void addReplayActions(Actions& actions, Player& player, SceneFiles& files, QWidget* window);

}  // namespace underact::gui
