#include "app/gui/window/rail.h"

#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QToolBar>
#include <QToolButton>

#include "app/gui/feature/panel.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/window/narrow_bar.h"
#include "app/gui/window/purpose.h"

namespace underact::gui {
namespace {

constexpr int kNamesFrom_px = 1100;  // the width of a window from which on the names are there

void dress(QToolBar* rail, QAction* action, const QString& name) {
  auto* const button = qobject_cast<QToolButton*>(rail->widgetForAction(action));
  nameWidget(button, name, action->iconText());
  button->setProperty("role", "rail");
  button->setFocusPolicy(Qt::TabFocus);
  button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

}  // namespace

void buildRail(QMainWindow* window, Actions& actions, const Purpose& purpose) {
  delete window->findChild<QToolBar*>("rail");
  auto* const rail = new QToolBar(QToolBar::tr("Panels"), window);
  nameWidget(rail, "rail", QToolBar::tr("Panels"));
  rail->setMovable(false);
  rail->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
  const int icon = qRound(1.3 * window->fontMetrics().height());
  rail->setIconSize({icon, icon});
  rail->setContextMenuPolicy(Qt::PreventContextMenu);
  window->addToolBar(Qt::LeftToolBarArea, rail);
  for (const QString& key : purpose.panels) {
    QAction* const action = actions.find("dock." + key);
    if (action == nullptr) continue;
    rail->addAction(action);
    dress(rail, action, "rail." + key);
  }
  QAction* const more = actions.find("menu.panels");
  auto* const menu = new QMenu(more->text(), rail);
  menu->setObjectName("rail.more.menu");
  for (const QDockWidget* dock : docksOf(window)) menu->addAction(actions.find(dock->objectName()));
  menu->addSeparator();
  menu->addAction(actions.find("layout.reset"));
  more->setMenu(menu);
  rail->addAction(more);
  dress(rail, more, "rail.more");
  qobject_cast<QToolButton*>(rail->widgetForAction(more))->setPopupMode(QToolButton::InstantPopup);
  new NarrowBar(rail, kNamesFrom_px);  // in a narrow window the room is the view's
}

}  // namespace underact::gui
