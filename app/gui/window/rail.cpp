#include "app/gui/window/rail.h"

#include <QAction>
#include <QDockWidget>
#include <QEvent>
#include <QMenu>
#include <QToolBar>
#include <QToolButton>
#include <algorithm>
#include <optional>
#include <utility>

#include "app/gui/feature/panel.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/message_label.h"

namespace underact::gui {
namespace {

constexpr int kMargins_px = 16;
constexpr int kNamesFrom_px = 1100;  // the width of a window from which on the names are there

// The others are in the menu at the end.
constexpr const char* kOften[] = {"scenes", "lessons",    "feel", "shape",    "arm", "plots",
                                  "robot",  "kinematics", "dh",   "sessions", "lab", "devices"};

void dress(QToolBar* rail, QAction* action, const QString& name) {
  auto* const button = qobject_cast<QToolButton*>(rail->widgetForAction(action));
  nameWidget(button, name, action->iconText());
  button->setProperty("role", "rail");
  button->setFocusPolicy(Qt::TabFocus);
  button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

/// In a narrow window the icons stand alone: their names are in their tips, and the room is the view's.
class NarrowRail : public QObject {
 public:
  NarrowRail(QToolBar* rail, int button_width, QMainWindow* window)
      : QObject(rail), rail_(rail), window_(window), button_width_(button_width) {
    window->installEventFilter(this);
    fit();
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::Resize) fit();
    return QObject::eventFilter(watched, event);
  }

 private:
  void fit() {
    const bool has_names = window_->width() >= kNamesFrom_px;
    if (std::exchange(has_names_, has_names) == has_names) return;
    rail_->setToolButtonStyle(has_names ? Qt::ToolButtonTextUnderIcon : Qt::ToolButtonIconOnly);
    for (QAction* action : rail_->actions())
      rail_->widgetForAction(action)->setMinimumWidth(has_names ? button_width_ : 0);
  }

  QToolBar* rail_;
  QMainWindow* window_;
  int button_width_;
  std::optional<bool> has_names_;
};

}  // namespace

void buildRail(QMainWindow* window, Actions& actions) {
  auto* const rail = new QToolBar(QToolBar::tr("Panels"), window);
  nameWidget(rail, "rail", QToolBar::tr("Panels"));
  rail->setMovable(false);
  rail->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
  const int icon = qRound(1.3 * window->fontMetrics().height());
  rail->setIconSize({icon, icon});
  rail->setContextMenuPolicy(Qt::PreventContextMenu);
  window->addToolBar(Qt::LeftToolBarArea, rail);
  QStringList shown;
  for (const char* const key : kOften) {
    QAction* const action = actions.find(QString("dock.%1").arg(key));
    if (action == nullptr) continue;
    rail->addAction(action);
    dress(rail, action, QString("rail.%1").arg(key));
    shown << action->objectName();
  }
  QAction* const more = actions.find("menu.panels");
  auto* const menu = new QMenu(more->text(), window);
  menu->setObjectName("rail.more.menu");
  for (const QDockWidget* dock : docksOf(window)) {
    QAction* const action = actions.find(dock->objectName());
    if (!shown.contains(action->objectName())) menu->addAction(action);
  }
  more->setMenu(menu);
  rail->addAction(more);
  dress(rail, more, "rail.more");
  qobject_cast<QToolButton*>(rail->widgetForAction(more))->setPopupMode(QToolButton::InstantPopup);
  int width = 0;  // one for all
  for (const QAction* action : rail->actions())
    width = std::max(width, rail->fontMetrics().horizontalAdvance(action->iconText()) + kMargins_px);
  new NarrowRail(rail, width, window);
}

}  // namespace underact::gui
