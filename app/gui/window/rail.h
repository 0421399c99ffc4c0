#pragma once
#include <QMainWindow>

namespace underact::gui {

class Actions;

/// The rail at the left edge: an icon with its name for each panel that is used often, and a menu of the others.
void buildRail(QMainWindow* window, Actions& actions);

}  // namespace underact::gui
