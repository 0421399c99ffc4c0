#pragma once

class QWidget;

namespace underact::gui {

class GhostHand;

/// A person is told of a recorded hand that is damaged, or cannot be followed.
void tellOfGhost(GhostHand& ghost, QWidget* window);

}  // namespace underact::gui
