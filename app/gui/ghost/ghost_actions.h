#pragma once

class QWidget;

namespace underact::gui {

class Actions;
class Document;
class GhostHand;
class SceneFiles;

/// What can be done with a recorded hand that is followed, by name: menu, keys, the strip and stories.
void addGhostActions(Actions& actions, GhostHand& ghost, const Document& document, SceneFiles& files, QWidget* window);

}  // namespace underact::gui
