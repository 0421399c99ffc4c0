#pragma once

class QWidget;

namespace underact::gui {

class Hand;
class Player;
class StatusLine;

/// Tells the window when a replay begins and ends, and the user what is wrong with a recording.
void connectReplayMessages(Player& player, StatusLine& status, Hand& hand, QWidget* window);

}  // namespace underact::gui
