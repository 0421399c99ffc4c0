// How the window is put together; what it does is in main_window.cpp.
#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QLineEdit>
#include <QSettings>
#include <QStatusBar>
#include <QTimer>
#include <QToolBar>
#include <QVBoxLayout>

#include "app/gui/actions.h"
#include "app/gui/compare/compare_tool.h"
#include "app/gui/curve/curve_files.h"
#include "app/gui/devices/arm_choice.h"
#include "app/gui/document.h"
#include "app/gui/fault_watch.h"
#include "app/gui/frame_pacer.h"
#include "app/gui/gallery/gallery_actions.h"
#include "app/gui/ghost/ghost_actions.h"
#include "app/gui/ghost/ghost_hand.h"
#include "app/gui/ghost/ghost_strip.h"
#include "app/gui/guide/guide_tool.h"
#include "app/gui/hand.h"
#include "app/gui/hands/moving_hands.h"
#include "app/gui/help_dialog.h"
#include "app/gui/identify/identify_tool.h"
#include "app/gui/language_actions.h"
#include "app/gui/late_sheets.h"
#include "app/gui/left_hand.h"
#include "app/gui/lessons/lesson_library.h"
#include "app/gui/live/live_data.h"
#include "app/gui/main_window.h"
#include "app/gui/menus.h"
#include "app/gui/mesh/load_strip.h"
#include "app/gui/mesh/mesh_files.h"
#include "app/gui/panels.h"
#include "app/gui/plots_panel.h"
#include "app/gui/problems_box.h"
#include "app/gui/projector/projector.h"
#include "app/gui/registration/registration_tool.h"
#include "app/gui/replay/player.h"
#include "app/gui/replay/replay_actions.h"
#include "app/gui/replay/replay_bar.h"
#include "app/gui/scene_files.h"
#include "app/gui/scene_library.h"
#include "app/gui/second/second_arm.h"
#include "app/gui/servo/servo_rate.h"
#include "app/gui/sessions/sessions_panel.h"
#include "app/gui/status_line.h"
#include "app/gui/stop_key.h"
#include "app/gui/stylus_key.h"
#include "app/gui/tab_order.h"
#include "app/gui/view/section_strip.h"
#include "app/gui/view_actions.h"
#include "app/gui/visitor/visitor_mode.h"
#include "app/gui/welcome/tour.h"
#include "app/gui/welcome/welcome.h"
#include "core/arm/preset.h"

namespace underact::gui {

constexpr int kLayoutVersion = 9;  // up by one where a dock is added: an old layout would hide it

MainWindow::MainWindow(const WindowParts& parts)
    : parts_(parts),
      settings_(readSettings()),
      actions_(new Actions(this)),
      document_(new Document(parts.host, this)),
      recent_(new RecentFiles(this)),
      loads_(new LoadStrip(this)),
      files_(new SceneFiles(*document_, *recent_, *loads_, this)),
      mesh_files_(new MeshFiles(*document_, *files_, *loads_, this)),
      curve_files_(new CurveFiles(*document_, *files_, *loads_, this)),
      view_(new SceneView(this)),
      player_(new Player(parts.host, *document_, parts.replay, this)),
      ghost_(new GhostHand(*document_, *player_, *loads_, *view_, this)),
      rate_(new ServoRate(parts.host, this)),
      arms_(new ArmChoice(parts.host, *document_, parts.chosen, parts.arm, this)),
      second_(new SecondArm(parts.host, *arms_, *view_, this)),
      registration_(
          new RegistrationTool({parts.host, *document_, *arms_, *second_, *view_, parts.chosen}, *actions_, this)),
      faults_(new FaultWatch(parts.host, *actions_, this)),
      live_(new LiveData(parts.host, *actions_, this)),
      pacer_(new FramePacer(this)),
      arm_in_use_(new ArmInUse(parts.arm, settings_.arm_model, this)),
      identify_(new IdentifyTool({parts.host, *document_, *view_, *player_, *arm_in_use_, *arms_}, *actions_, this)),
      guide_(new GuideTool(*actions_, settings_.guide_page, settings_.guide_zoom, this)),
      sheets_(new LateSheets(this)) {
  setObjectName("window");
  setAcceptDrops(true);
  setDockNestingEnabled(true);
  resize(1280, 800);
  setMinimumSize(800, 560);
  recent_->set(settings_.recent);
  // At once: a replay looks for its files beside the scenes opened lately.
  connect(recent_, &RecentFiles::changed, this, [this] { QSettings().setValue("files/recent", recent_->paths()); });
  parts_.theme.choose(settings_.theme);
  view_->setLayers(settings_.layers);
  addActions();
  addHelpActions();
  addReplayActions(*actions_, *player_, *files_, this);
  addGhostActions(*actions_, *ghost_, *document_, *files_, this);
  addGalleryActions(*actions_, this);
  addViewActions(*actions_, *view_, parts_.theme);
  addLanguageActions(*actions_, this);
  buildView();
  buildGuests();
  buildDocks();
  buildMenus(this, *actions_, *recent_);
  buildToolBar(this, *actions_);
  orderTabs();
  connectDocument();
  connectPlayer();
  connectGhost();
  connectRate();
  connectArms();
  updateTitle();
  restore();
  setTheme(parts_.theme.theme());
  connect(&parts_.theme, &ThemeWatcher::changed, this, &MainWindow::setTheme);
  new StopKey([this] { actions_->perform("session.stop"); }, this);
  connect(pacer_, &FramePacer::frame, this, &MainWindow::frame);
  pacer_->start();
}

void MainWindow::addActions() {
  actions_->add(
      {"session.start", tr("&Start"), QKeySequence("F5"), tr("Lets the servo push; also after a fault."), "start"},
      [this](const QVariantList&) {
        parts_.host.start();
        second_->start();
        return true;
      });
  actions_->add({"session.stop", tr("S&top"), QKeySequence("Esc"),
                 tr("Lets go: the force goes to zero. Esc does it from anywhere."), "stop"},
                [this](const QVariantList&) {
                  parts_.host.stop();
                  second_->stop();
                  return true;
                });
  actions_->add({"scene.open", tr("&Open file…"), QKeySequence::Open, tr("Opens a scene file."), "open"},
                [this](const QVariantList& path) {
                  if (!path.isEmpty() && isSession(path.first().toString()))
                    return actions_->perform("replay.open", path);
                  if (!path.isEmpty() && isLessonFile(path.first().toString()))
                    return actions_->perform("lesson.open", path);
                  if (!path.isEmpty() && isMeshFile(path.first().toString()))
                    return actions_->perform("mesh.add", path);
                  if (!path.isEmpty() && isCurveFile(path.first().toString()))
                    return actions_->perform("curve.add", path);
                  if (!path.isEmpty()) return files_->open(path.first().toString());
                  files_->chooseAndOpen();
                  return true;
                });
  actions_->addCommand("scene.settle", [this](const QVariantList&) { return files_->settleEdits(); });
  addMeshActions(*actions_, *mesh_files_);
  addCurveActions(*actions_, *curve_files_);
  addLeftHandAction(*actions_, *document_);
  actions_
      ->add({"scene.save_as", tr("&Save tuned scene as…"), QKeySequence::Save,
             tr("Saves the scene with its gains as they are now."), "save", tr("Save as…")},
            [this](const QVariantList& path) {
              if (!path.isEmpty()) return files_->saveAs(path.first().toString());
              files_->chooseAndSave();
              return true;
            })
      ->setEnabled(false);
  actions_->add({"app.quit", tr("&Quit"), QKeySequence("Ctrl+Q"), tr("Stops the servo and closes the window.")},
                [this](const QVariantList&) { return close(); });
  QUndoStack& undo = document_->undoStack();
  QAction* back = actions_->add(
      {"edit.undo", tr("&Undo"), QKeySequence::Undo, tr("Takes the last change of a gain back."), "undo", tr("Undo")},
      [&undo](const QVariantList&) {
        undo.undo();
        return true;
      });
  QAction* forth = actions_->add(
      {"edit.redo", tr("&Redo"), QKeySequence("Ctrl+Shift+Z"), tr("Makes the change again."), "redo", tr("Redo")},
      [&undo](const QVariantList&) {
        undo.redo();
        return true;
      });
  back->setEnabled(false);
  forth->setEnabled(false);
  connect(&undo, &QUndoStack::canUndoChanged, back, &QAction::setEnabled);
  connect(&undo, &QUndoStack::canRedoChanged, forth, &QAction::setEnabled);
  connect(&undo, &QUndoStack::undoTextChanged, back, [back](const QString& what) {
    back->setText(what.isEmpty() ? tr("&Undo") : tr("&Undo %1").arg(what));
    back->setIconText(tr("Undo"));
  });
  connect(&undo, &QUndoStack::redoTextChanged, forth, [forth](const QString& what) {
    forth->setText(what.isEmpty() ? tr("&Redo") : tr("&Redo %1").arg(what));
    forth->setIconText(tr("Redo"));
  });
}

void MainWindow::addHelpActions() {
  actions_->add(
      {"menu.layers", tr("La&yers"), QKeySequence("Ctrl+Alt+Y"), tr("What the view shows."), "layers", tr("Layers")},
      [](const QVariantList&) { return true; });
  actions_->add(
      {"layout.reset", tr("&Reset"), QKeySequence("Ctrl+Alt+0"), tr("Puts every panel back to where it was at first.")},
      [this](const QVariantList&) {
        arrangeDocks();
        return true;
      });
  actions_->add({"help.keys", tr("&Mouse and keys"), QKeySequence("Shift+F1"), tr("What the mouse and the keys do.")},
                [this](const QVariantList&) {
                  auto* dialog = new HelpDialog(*actions_, this);
                  dialog->setAttribute(Qt::WA_DeleteOnClose);
                  dialog->show();
                  return true;
                });
  actions_->add(
      {"help.about", tr("&About Underact"), QKeySequence("Ctrl+F1"), tr("Version, licence, and what was never tried.")},
      [this](const QVariantList&) {
        auto* dialog = new AboutDialog(this);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        dialog->show();
        return true;
      });
}

void MainWindow::buildView() {
  view_->setMinimumSize(320, 240);
  auto* middle = new QWidget(this);
  replay_bar_ = new ReplayBar(*player_, *actions_, middle);
  compare_ = new CompareTool({parts_.host, *document_, *files_, *view_, *actions_}, middle);
  ghost_strip_ = new GhostStrip(*ghost_, *document_, *actions_, middle);
  section_ = new SectionStrip(*view_, *actions_, middle);
  auto* column = new QVBoxLayout(middle);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(compare_->views(), 1);
  column->addWidget(compare_->strip());
  column->addWidget(section_);
  column->addWidget(loads_);
  column->addWidget(replay_bar_);
  column->addWidget(ghost_strip_);
  setCentralWidget(middle);
  hand_ = new Hand(view_, parts_.arm, this);
  hands_ = new MovingHands(parts_.host, *hand_, parts_.hands, *actions_, this);
  if (parts_.arm != nullptr) new StylusKey(*parts_.arm, this, view_);
  const double limit_N = arm::findPreset(arm::kDefaultArm)->continuous_force_N;
  view_->setForceLimit(limit_N);
  status_ = new StatusLine(parts_.host, limit_N, this);
  status_->setObjectName("status");
  status_->setAccessibleName(tr("Status"));
  if (parts_.arm != nullptr) {
    const auto tell = [this] {
      const sim::ArmModel& model = arm_in_use_->model();
      status_->setArmModel(arm_in_use_->isMeasured() ? QString::fromStdString(model.name) : QString(),
                           QString::fromStdString(model.provenance));
    };
    connect(arm_in_use_, &ArmInUse::changed, status_, tell);
    tell();
  }
  statusBar()->setSizeGripEnabled(false);
  statusBar()->addPermanentWidget(status_, 1);
}

/// For those who see it for the first time, from afar, or for a minute.
void MainWindow::buildGuests() {
  welcome_ = new Welcome(*view_, *hand_, *document_, *actions_, settings_.has_pushed);
  tour_ = new Tour(this, *view_, *actions_);
  projector_ = new Projector(this, *view_, parts_.theme, *actions_);
  visitors_ =
      new VisitorMode({this, parts_.host, *document_, *view_, *hand_, *actions_, *faults_, *player_}, centralWidget());
  connect(visitors_, &VisitorMode::forceLimitChanged, this, &MainWindow::showForceLimit);
}

void MainWindow::buildDocks() {
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  for (const PanelRow& row : panels()) {
    const QString title = QCoreApplication::translate("panel", row.title);
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName(QString("dock.%1").arg(row.key));
    dock->setAccessibleName(title);
    const PanelParts parts{parts_.host, *document_,   *recent_, *actions_, *view_,         *player_,
                           *rate_,      *arm_in_use_, *arms_,   *second_,  *registration_, *hands_};
    Panel* panel = row.make(parts, dock);
    panel->setObjectName(QString("panel.%1").arg(row.key));
    panel->setAccessibleName(title);
    dock->setWidget(panel);
    addDockWidget(row.area, dock);
    QAction* action = actions_->add({QString("dock.%1").arg(row.key),
                                     title,
                                     QKeySequence(row.shortcut),
                                     QCoreApplication::translate("panel", row.tip),
                                     {},
                                     {},
                                     true},
                                    [dock](const QVariantList& on) {
                                      dock->setVisible(on.value(0).toBool());
                                      dock->raise();  // to the front, where others stand in its place
                                      return true;
                                    });
    connect(dock, &QDockWidget::visibilityChanged, action, [dock, action] { action->setChecked(!dock->isHidden()); });
    if (row.behind != nullptr) {
      tabifyDockWidget(docks_.value(row.behind), dock);
      dock->hide();
    }
    docks_.insert(row.key, dock);
    panels_.insert(row.key, panel);
  }
  auto* sessions = static_cast<SessionsPanel*>(panels_["sessions"]);
  connect(sessions, &SessionsPanel::told, status_, &StatusLine::setRecording);
  connect(sessions, &SessionsPanel::replayRequested, this, &MainWindow::openSession);
  for (QLineEdit* line : findChildren<QLineEdit*>()) line->setAcceptDrops(false);  // a scene is dropped on the window
}

// From left to right and top to bottom: tool bar, scenes, view, then the panels in their order.
void MainWindow::orderTabs() {
  QList<QWidget*> groups{
      findChild<QToolBar*>(), panels_["scenes"], view_, compare_->strip(), section_, loads_, replay_bar_, ghost_strip_};
  for (const PanelRow& row : panels()) {
    if (panels_[row.key] != groups[1]) groups << panels_[row.key];
  }
  gui::orderTabs(groups);
}

void MainWindow::arrangeDocks() {
  for (const PanelRow& row : panels()) {
    QDockWidget* dock = docks_.value(row.key);
    dock->setFloating(false);
    addDockWidget(row.area, dock);
    if (row.behind != nullptr) tabifyDockWidget(docks_.value(row.behind), dock);
    dock->setVisible(row.behind == nullptr);
  }
  const int line = fontMetrics().lineSpacing();
  resizeDocks({docks_["scenes"], docks_["feel"]}, {15 * line, 20 * line}, Qt::Horizontal);
  resizeDocks({docks_["feel"], docks_["shape"], docks_["arm"]}, {26 * line, 9 * line, 10 * line}, Qt::Vertical);
  resizeDocks({docks_["plots"]}, {13 * line}, Qt::Vertical);
}

void MainWindow::restore() {
  if (settings_.are_newer) {
    QTimer::singleShot(0, this, [this] {
      showProblemsBox(
          "dialog.newer_settings", tr("Settings"),
          tr("The settings on this computer were written by a newer Underact. This one starts with its own and "
             "leaves those as they are."),
          {}, this);
    });
  }
  if (!settings_.geometry.isEmpty()) restoreGeometry(settings_.geometry);
  if (!settings_.layout.isEmpty() && !restoreState(settings_.layout, kLayoutVersion)) settings_.layout.clear();
  static_cast<PlotsPanel*>(panels_["plots"])->setAxis(settings_.plot_axis);
  actions_->perform("plots.energy", settings_.energy_plot);
  actions_->perform("session.hold_to_run", settings_.hold_to_run);
  actions_->perform("scene.left_handed", settings_.left_handed);
}

void MainWindow::remember() {
  settings_.projector = projector_->isOn();
  projector_->setOn(false);  // what is remembered is the window's own layout
  settings_.geometry = saveGeometry();
  settings_.layout = saveState(kLayoutVersion);
  settings_.theme = parts_.theme.choice();
  settings_.layers = view_->layers();
  settings_.recent = recent_->paths();
  settings_.plot_axis = static_cast<PlotsPanel*>(panels_["plots"])->axis();
  settings_.energy_plot = static_cast<PlotsPanel*>(panels_["plots"])->showsEnergy();
  settings_.hold_to_run = parts_.host.holdToRun();
  settings_.left_handed = document_->isLeftHanded();
  settings_.servo_rate_hz = rate_->chosen().value_or(settings_.servo_rate_hz);
  settings_.guide_page = guide_->place();
  settings_.guide_zoom = guide_->zoom();
  settings_.has_pushed = welcome_->wasSeen();
  settings_.arm_model = arm_in_use_->text();
  if (parts_.chosen != nullptr) settings_.device = arms_->wanted();
  writeSettings(settings_);
}

}  // namespace underact::gui
