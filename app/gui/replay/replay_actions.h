#pragma once
class QWidget;

namespace underact::gui {

class Actions;
class Player;
class SceneFiles;

/// The actions for a recorded session, by name: for the menu, the keys, the bar and stories. If the player cannot
/// replay, opening is refused.
void addReplayActions(Actions& actions, Player& player, SceneFiles& files, QWidget* window);

}  // namespace underact::gui
