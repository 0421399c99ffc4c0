#include "app/gui/window/menus.h"

#include <QAction>
#include <QCoreApplication>
#include <QFileInfo>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>
#include <algorithm>
#include <utility>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/stop_key.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/scene_library.h"
#include "app/gui/window/narrow_bar.h"
#include "app/gui/window/purpose.h"
#include "core/lesson/layers.h"

namespace underact::gui {
namespace {

// names: of actions; "-": a separator. Skipped: what no feature of this window adds, and what the purpose does not
// take.
void fillMenu(QMenu* menu, const Actions& actions, const Purpose& purpose, const QStringList& names) {
  for (const QString& name : names) {
    QAction* const action = purpose.hasInMenus(name) ? actions.find(name) : nullptr;
    if (name == "-")
      menu->addSeparator();  // a menu shows none at its ends, and one of several
    else if (action != nullptr)
      menu->addAction(action);
  }
}

/// Menus without an entry are left out, but for that of recent files, which fills.
void removeEmpty(QMenuBar* bar) {
  const QList<QMenu*> menus = bar->findChildren<QMenu*>();
  for (auto menu = menus.rbegin(); menu != menus.rend(); ++menu) {  // those inside others first
    const QList<QAction*> entries = (*menu)->actions();
    const bool is_empty = std::all_of(entries.begin(), entries.end(), [](QAction* one) { return one->isSeparator(); });
    if (is_empty && (*menu)->objectName() != "menu.recent") delete *menu;
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

const char* roleOf(const QString& name) {
  return name == "hand.keep" ? "hold" : name == "session.record" ? "record" : name.startsWith("menu.") ? "menu" : "";
}

void addTo(QMenu* menu, QAction* action) {
  if (action != nullptr) menu->addAction(action);
}

/// Where the purpose is switched.
void addPurposes(QToolBar* bar, Actions& actions, const Purpose& chosen) {
  auto* const button = new QToolButton(bar);
  nameWidget(button, "button.purpose", tr("What you do"), tr("Which panels, menus and buttons are shown."));
  button->setText(QCoreApplication::translate("purpose", chosen.title));
  button->setFocusPolicy(Qt::TabFocus);
  button->setPopupMode(QToolButton::InstantPopup);
  button->setProperty("role", "menu");
  auto* const menu = new QMenu(button);
  menu->setObjectName("toolbar.purposes");
  for (const Purpose& one : purposes()) addTo(menu, actions.find(QString("purpose.%1").arg(one.key)));
  button->setMenu(menu);
  bar->addWidget(button);
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

void buildMenus(QMainWindow* window, Actions& actions, RecentFiles& recent, const Purpose& purpose) {
  QMenuBar* bar = window->menuBar();
  qDeleteAll(bar->findChildren<QMenu*>(QString(), Qt::FindDirectChildrenOnly));
  nameWidget(bar, "menubar", tr("Menu"));
  const auto fill = [&](QMenu* menu, const QStringList& names) {
    fillMenu(menu, actions, purpose, names);
    return menu;
  };
  QMenu* file = named(bar->addMenu(tr("&File")), "menu.file");
  fill(file, {"scene.open", "mesh.add", "mesh.report", "curve.add"});
  QMenu* recent_menu = named(file->addMenu(tr("Open rece&nt")), "menu.recent");
  fillRecent(recent_menu, actions, recent);
  QObject::connect(&recent, &RecentFiles::changed, recent_menu,
                   [recent_menu, &actions, &recent] { fillRecent(recent_menu, actions, recent); });
  fill(file, {"scenes.find", "-", "scene.save_as", "-", "live.send", "live.address", "service.on", "service.take_back",
              "-", "app.quit"});
  fill(named(bar->addMenu(tr("&Edit")), "menu.edit"),
       {"edit.undo", "edit.redo", "-", "gains.reset", "-", "scene.left_handed"});
  fill(named(bar->addMenu(tr("&Servo")), "menu.servo"), {"session.start",
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
  QMenu* replay = named(new QMenu(tr("&Replay"), bar), "menu.replay");
  fill(replay,
       {"replay.open", "-", "replay.play", "replay.back", "replay.forward", "-", "replay.loop", "replay.loop_in",
        "replay.loop_out", "-", "replay.what_if", "-", "replay.files", "replay.close", "-", "ghost.open"});
  fill(named(replay->addMenu(tr("&Ghost")), "menu.ghost"), {"ghost.play", "ghost.restart", "ghost.close"});
  QMenu* view = named(new QMenu(tr("&View"), bar), "menu.view");
  fill(view, {"view.fit", "view.selection", "view.home", "-", "view.front", "view.top", "view.side", "view.isometric",
              "view.left", "view.back", "view.bottom", "-", "view.parallel", "-", "view.focus", "-"});
  fill(named(view->addMenu(tr("L&ayers")), "menu.layers"), layerNames());
  fill(named(view->addMenu(tr("T&heme")), "menu.theme"), {"view.theme.system", "view.theme.light", "view.theme.dark"});
  fill(named(view->addMenu(tr("Lan&guage")), "menu.language"), {"language.system", "language.en", "language.de"});
  fill(view, {"-", "compare.on", "compare.swap", "compare.same", "compare.open", "-", "view.film", "view.projector",
              "visitor.start", "visitor.demonstrator"});
  QMenu* const sessions = fill(named(new QMenu(tr("Sessio&ns"), bar), "menu.sessions"),
                               {"session.record", "session.mark", "-", "sessions.find", "sessions.export",
                                "sessions.plots", "sessions.follow", "sessions.rerun", "sessions.show", "sessions.edit",
                                "sessions.recover", "sessions.delete", "-", "sessions.folder"});
  QMenu* const lessons = fill(
      named(new QMenu(tr("Less&ons"), bar), "menu.lessons"),
      {"lesson.all", "lesson.open", "-", "lesson.back", "lesson.next", "lesson.hint", "lesson.after", "-",
       "lesson.report", "lesson.print", "lesson.pdf", "lesson.leave", "-", "lesson.new_student", "lesson.results"});
  for (QMenu* const menu : {sessions, replay, lessons, view}) bar->addMenu(menu);
  fill(named(bar->addMenu(tr("&Help")), "menu.help"),
       {"help.guide", "help.find", "help.welcome", "help.tour", "help.keys", "help.figures", "-", "help.about"});
  removeEmpty(bar);
}

void buildToolBar(QMainWindow* window, Actions& actions, const Purpose& purpose) {
  delete window->findChild<QToolBar*>("toolbar");
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
  QAction* layers = actions.find("menu.layers");
  auto* menu = new QMenu(layers->text(), bar);
  menu->setObjectName("toolbar.layers");
  for (const QString& name : layerNames()) {
    if (name == "-")
      menu->addSeparator();
    else
      addTo(menu, actions.find(name));
  }
  layers->setMenu(menu);
  for (const QString& name : purpose.buttons) button(name, roleOf(name));
  if (QAction* record = actions.find("session.record"); purpose.buttons.contains("session.record") && record != nullptr)
    keepWidth(bar, record);
  if (auto* const chooser = qobject_cast<QToolButton*>(bar->widgetForAction(layers)))
    chooser->setPopupMode(QToolButton::InstantPopup);
  auto* const between = new QWidget(bar);
  between->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar->addWidget(between);
  addPurposes(bar, actions, purpose);
  new NarrowBar(bar, {"button.view.fit", "button.menu.layers", "button.visitor.start", "button.hand.keep",
                      "button.help.guide", "button.purpose", "button.session.record"});
}

}  // namespace underact::gui
