#pragma once
#include <QMainWindow>

namespace underact::gui {

class Actions;
class RecentFiles;

/// The menu bar: every action is in it once.
void buildMenus(QMainWindow* window, Actions& actions, RecentFiles& recent);

/// The one tool bar: icons with words, Start and the big Stop first.
void buildToolBar(QMainWindow* window, Actions& actions);

}  // namespace underact::gui
