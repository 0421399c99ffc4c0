#pragma once
#include <QMainWindow>

namespace underact::gui {

class Actions;
class RecentFiles;
struct Purpose;

/// The menu bar: what the purpose takes, each action once. Replaces the one that is there.
void buildMenus(QMainWindow* window, Actions& actions, RecentFiles& recent, const Purpose& purpose);

/// The tool bar: icons with text, Start and the large Stop first, what the purpose takes, and at the end the purpose.
/// Replaces the one that is there.
void buildToolBar(QMainWindow* window, Actions& actions, const Purpose& purpose);

}  // namespace underact::gui
