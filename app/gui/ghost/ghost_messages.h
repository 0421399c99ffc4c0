#pragma once

class QWidget;

namespace underact::gui {

class GhostHand;

/// Tells the user that a recorded hand is damaged or cannot be followed.
void connectGhostMessages(GhostHand& ghost, QWidget* window);

}  // namespace underact::gui
