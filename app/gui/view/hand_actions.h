#pragma once

namespace underact::gui {

class Actions;
class Hand;

/// Keep holding, and let go. keeps_holding: as saved.
void addHandActions(Actions& actions, Hand& hand, bool keeps_holding);

}  // namespace underact::gui
