#pragma once
#include <QMainWindow>

namespace underact::gui {

class Actions;

struct Purpose;

/// The rail at the left edge: an icon with its name for each panel of the purpose, and a menu of all. Replaces the one
/// that is there.
void buildRail(QMainWindow* window, Actions& actions, const Purpose& purpose);

}  // namespace underact::gui
