#include "app/gui/window/menus.h"

#include <QAction>
#include <QDockWidget>
#include <QFileInfo>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>
#include <utility>

#include "app/gui/feature/panel.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/stop_key.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/scene_library.h"
#include "app/gui/window/narrow_bar.h"
#include "core/lesson/layers.h"

namespace underact::gui {
namespace {

// names: of actions; "-": a separator. Actions that no feature of this window adds are skipped.
void fillMenu(QMenu* menu, const Actions& actions, const QStringList& names) {
  for (const QString& name : names) {
    QAction* const action = actions.find(name);
    if (name == "-")
      menu->addSeparator();
    else if (action != nullptr)
      menu->addAction(action);
  }
}

QMenu* named(QMenu* menu, const char* name) {
  nameWidget(menu, name, menu->title().remove('&'));
  return menu;
}

void fillRecent(QMenu* menu, Actions& actions, const RecentFiles& recent) {
  menu->clear();
  menu->setEnabled(!recent.paths().isEmpty());
  for (const QString& path : recent.paths()) {
    QAction* action = menu->addAction(menuText(QFileInfo(path).fileName()));
    action->setStatusTip(path);
    QObject::connect(action, &QAction::triggered, &actions, [&actions, path] { actions.perform("scene.open", path); });
  }
}

// A fixed width, so that a running clock does not move its neighbours.
void keepWidth(QToolBar* bar, QAction* action) {
  QWidget* button = bar->widgetForAction(action);
  QFont bold = button->font();
  bold.setWeight(QFont::DemiBold);
  const QFontMetrics metrics(bold);
  const int margins = bar->iconSize().width() + 2 * metrics.averageCharWidth() + 28;
  const QString widest = action->property("widestText").toString();
  button->setMinimumWidth(metrics.horizontalAdvance(widest.isEmpty() ? action->iconText() : widest) + margins);
}

QStringList layerNames() {
  QStringList names;
  auto group = lesson::Layer::Group::Scene;
  for (const lesson::Layer& layer : lesson::layers()) {
    if (std::exchange(group, layer.group) != layer.group) names << "-";
    names << QString("layer.%1").arg(layer.name);
  }
  return names << QStringList{"section.x", "section.y", "section.z", "section.move", "-", "view.kinematics"};
}

}  // namespace

void buildMenus(QMainWindow* window, Actions& actions, RecentFiles& recent) {
  QMenuBar* bar = window->menuBar();
  nameWidget(bar, "menubar", tr("Menu"));
  QMenu* file = named(bar->addMenu(tr("&File")), "menu.file");
  fillMenu(file, actions, {"scene.open", "mesh.add", "mesh.report", "curve.add"});
  QMenu* recent_menu = named(file->addMenu(tr("Open rece&nt")), "menu.recent");
  fillRecent(recent_menu, actions, recent);
  QObject::connect(&recent, &RecentFiles::changed, recent_menu,
                   [recent_menu, &actions, &recent] { fillRecent(recent_menu, actions, recent); });
  fillMenu(file, actions,
           {"scenes.find", "-", "scene.save_as", "-", "live.send", "live.address", "service.on", "service.take_back",
            "-", "app.quit"});
  fillMenu(named(bar->addMenu(tr("&Edit")), "menu.edit"), actions,
           {"edit.undo", "edit.redo", "-", "gains.reset", "-", "scene.left_handed"});
  fillMenu(named(bar->addMenu(tr("&Servo")), "menu.servo"), actions,
           {"session.start",
            "session.stop",
            "session.hold_to_run",
            "-",
            "hand.keep",
            "hand.let_go",
            "-",
            "servo.restart",
            "servo.check",
            "servo.fault",
            "-",
            "devices.look",
            "devices.simulated",
            "second.on",
            "registration.open",
            "-",
            "identify.open",
            "arm.open",
            "arm.vendor",
            "-",
            "calibration.left",
            "calibration.right"});
  fillMenu(named(bar->addMenu(tr("Sessio&ns")), "menu.sessions"), actions,
           {"session.record", "session.mark", "-", "sessions.find", "sessions.export", "sessions.plots",
            "sessions.follow", "sessions.rerun", "sessions.show", "sessions.edit", "sessions.recover",
            "sessions.delete", "-", "sessions.folder"});
  QMenu* replay = named(bar->addMenu(tr("&Replay")), "menu.replay");
  fillMenu(replay, actions,
           {"replay.open", "-", "replay.play", "replay.back", "replay.forward", "-", "replay.loop", "replay.loop_in",
            "replay.loop_out", "-", "replay.what_if", "-", "replay.files", "replay.close", "-", "ghost.open"});
  fillMenu(named(replay->addMenu(tr("&Ghost")), "menu.ghost"), actions, {"ghost.play", "ghost.restart", "ghost.close"});
  fillMenu(named(bar->addMenu(tr("Less&ons")), "menu.lessons"), actions,
           {"lesson.all", "lesson.open", "-", "lesson.back", "lesson.next", "lesson.hint", "lesson.after", "-",
            "lesson.report", "lesson.leave"});
  QMenu* view = named(bar->addMenu(tr("&View")), "menu.view");
  fillMenu(view, actions,
           {"view.fit", "view.selection", "view.home", "-", "view.front", "view.top", "view.side", "view.isometric",
            "view.left", "view.back", "view.bottom", "-", "view.parallel", "-", "view.focus", "-"});
  fillMenu(named(view->addMenu(tr("L&ayers")), "menu.layers"), actions, layerNames());
  fillMenu(named(view->addMenu(tr("T&heme")), "menu.theme"), actions,
           {"view.theme.system", "view.theme.light", "view.theme.dark"});
  fillMenu(named(view->addMenu(tr("Lan&guage")), "menu.language"), actions,
           {"language.system", "language.en", "language.de"});
  fillMenu(view, actions,
           {"-", "compare.on", "compare.swap", "compare.same", "compare.open", "-", "view.projector", "visitor.start",
            "visitor.demonstrator"});
  QMenu* layout = named(bar->addMenu(tr("&Layout")), "menu.layout");
  QMenu* panels = named(layout->addMenu(tr("&Panels")), "menu.panels");
  for (const QDockWidget* dock : docksOf(window)) panels->addAction(actions.find(dock->objectName()));
  fillMenu(layout, actions, {"-", "layout.reset"});
  fillMenu(named(bar->addMenu(tr("&Help")), "menu.help"), actions,
           {"help.guide", "help.welcome", "help.tour", "help.keys", "help.figures", "-", "help.about"});
}

void buildToolBar(QMainWindow* window, Actions& actions) {
  auto* bar = new QToolBar(tr("Tool bar"), window);
  nameWidget(bar, "toolbar", tr("Tool bar"));
  bar->setMovable(false);
  bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  const int icon = qRound(1.2 * window->fontMetrics().height());  // icons scale with the text beside them
  bar->setIconSize({icon, icon});
  bar->setContextMenuPolicy(Qt::PreventContextMenu);
  window->addToolBar(bar);
  const auto button = [&](const QString& name, const char* role) {
    if (actions.find(name) == nullptr) return;
    bar->addAction(actions.find(name));
    auto* made = qobject_cast<QToolButton*>(bar->widgetForAction(actions.find(name)));
    nameWidget(made, "button." + name, actions.find(name)->iconText());
    made->setProperty("role", role);
    made->setFocusPolicy(Qt::TabFocus);
  };
  button("session.start", "start");
  button("session.stop", "stop");
  if (QAction* stop = actions.find("session.stop")) bar->widgetForAction(stop)->setProperty(StopKey::kStops, true);
  bar->addSeparator();
  button("hand.keep", "hold");
  button("session.record", "record");
  if (QAction* record = actions.find("session.record")) keepWidth(bar, record);
  // What the arm does is at the left, what is seen of it at the right: between them the record button may grow.
  auto* const between = new QWidget(bar);
  between->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar->addWidget(between);
  for (const char* name : {"view.fit", "view.front", "view.top", "view.side"}) button(name, "");
  bar->addSeparator();
  QAction* layers = actions.find("menu.layers");
  auto* menu = new QMenu(layers->text(), window);
  menu->setObjectName("toolbar.layers");
  fillMenu(menu, actions, layerNames());
  layers->setMenu(menu);
  button("menu.layers", "menu");
  qobject_cast<QToolButton*>(bar->widgetForAction(layers))->setPopupMode(QToolButton::InstantPopup);
  bar->addSeparator();
  button("dock.lessons", "");
  button("help.guide", "");
  // The axes in the corner of the view look from the sides, too.
  new NarrowBar(bar,
                {"button.view.side", "button.view.top", "button.view.front", "button.view.fit", "button.menu.layers",
                 "button.hand.keep", "button.help.guide", "button.dock.lessons", "button.session.record"});
}

}  // namespace underact::gui
