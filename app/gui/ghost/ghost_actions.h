#pragma once

class QWidget;

namespace underact::gui {

class Actions;
class Document;
class GhostHand;
class SceneFiles;

/// The actions and commands for following a recorded hand: for menus, keys, the strip and stories.
void addGhostActions(Actions& actions, GhostHand& ghost, const Document& document, SceneFiles& files, QWidget* window);

}  // namespace underact::gui
