#pragma once
#include <QMainWindow>

namespace underact::gui {

class Actions;
class RecentFiles;

/// The menu bar, which contains every action once.
void buildMenus(QMainWindow* window, Actions& actions, RecentFiles& recent);

/// The tool bar: icons with text, Start and the large Stop first.
void buildToolBar(QMainWindow* window, Actions& actions);

}  // namespace underact::gui
