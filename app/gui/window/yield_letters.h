#pragma once

class QMainWindow;

namespace underact::gui {

/// Alt and a letter open a menu, or do what an action does: no label or button in a panel takes the same letter, in
/// whatever language; it loses its underline. Once the window has all of its parts.
void yieldLetters(QMainWindow& window);

}  // namespace underact::gui
