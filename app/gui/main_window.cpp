#include "app/gui/main_window.h"

#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QMimeData>
#include <QStatusBar>
#include <QStatusTipEvent>
#include <QTabBar>
#include <QUrl>
#include <utility>

#include "app/gui/actions.h"
#include "app/gui/compare/compare_tool.h"
#include "app/gui/data_words.h"
#include "app/gui/devices/arm_choice.h"
#include "app/gui/document.h"
#include "app/gui/fault_watch.h"
#include "app/gui/frame_pacer.h"
#include "app/gui/ghost/ghost_hand.h"
#include "app/gui/ghost/ghost_strip.h"
#include "app/gui/hand.h"
#include "app/gui/hands/moving_hands.h"
#include "app/gui/icons.h"
#include "app/gui/identify/identify_tool.h"
#include "app/gui/late_sheets.h"
#include "app/gui/live/live_data.h"
#include "app/gui/panels.h"
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
#include "app/gui/style.h"
#include "app/gui/view/section_strip.h"
#include "app/gui/visitor/visitor_mode.h"
#include "app/gui/welcome/tour.h"
#include "app/gui/welcome/welcome.h"
#include "app/gui/words.h"
#include "core/arm/preset.h"
#include "device/simulated_arm.h"

namespace underact::gui {

MainWindow::~MainWindow() {
  identify_->end();  // while the document that it puts back is still there
}

void MainWindow::frame() {
  player_->look();
  hands_->look();
  const servo::Snapshot snapshot = parts_.host.snapshot();
  parts_.host.drain([this](const servo::TickRecord& record) {
    player_->add(record);
    ghost_->add(record);
    faults_->add(record);
    live_->add(record);
    identify_->add(record);
    compare_->add(record);
    registration_->add(record);
    for (Panel* panel : panels_) panel->add(record);
  });
  second_->look();
  registration_->look(snapshot);
  faults_->look(snapshot);
  if (pacer_->isSeen()) showFrame(snapshot);
  identify_->look(snapshot);  // last of all: it may put a scene into effect, which none of the others has seen
  visitors_->present(parts_.host.snapshot());  // so may they, and they are to see what it did
}

void MainWindow::showFrame(const servo::Snapshot& snapshot) {
  if (snapshot.ticks > 0) view_->present(snapshot);  // before the first tick nobody knows where the stylus is
  hand_->present(snapshot);
  status_->present(snapshot);
  compare_->present(snapshot);
  section_->present();
  replay_bar_->present(snapshot);
  ghost_->draw();
  ghost_strip_->present();
  status_->setLive(live_->where(), live_->details());
  for (Panel* panel : panels_) panel->present(snapshot);
  presentMode(snapshot);
  welcome_->present(snapshot, parts_.host.rateHz(), !visitors_->isOn());
  if (visitors_->isOn()) {
    tour_->leave();
    compare_->setOn(false);
    ghost_->close();
  }
  tour_->follow();
}

void MainWindow::presentMode(const servo::Snapshot& snapshot) {
  const bool faulted = snapshot.mode == servo::Mode::Faulted;
  const QString sentence = faulted ? faultText(snapshot.report.fault) : QString();
  if (fault_ != sentence) {  // the view shows it; a screen reader says it at once, wherever it is
    fault_ = sentence;
    status_->setFault(sentence);
    QAccessibleEvent alert(status_, QAccessible::Alert);
    if (faulted) QAccessible::updateAccessibility(&alert);
  }
  // Stop stays there always: a button that a hand in trouble finds grey is one too few.
  const bool all_run = snapshot.mode == servo::Mode::Running && (!second_->isOn() || second_->host().running());
  actions_->find("session.start")->setEnabled(document_->isOpen() && !all_run);
}

void MainWindow::connectDocument() {
  const auto integrate = [this] {
    if (parts_.arm != nullptr) parts_.arm->integrate(integrationOf(document_->scene().simulation));
  };
  connect(document_, &Document::opened, this, integrate);
  connect(document_, &Document::edited, this, integrate);
  connect(document_, &Document::opened, this, [this] {
    const scene::Description& scene = document_->scene();
    view_->setScene(scene);
    showForceLimit();
    if (!document_->showsRecorded()) settings_.last_scene = document_->path();
    actions_->find("scene.save_as")->setEnabled(true);
    presentMode(parts_.host.snapshot());
    updateTitle();
  });
  connect(document_, &Document::modifiedChanged, this, &MainWindow::updateTitle);
  connect(document_, &Document::edited, this, [this] {
    view_->followEdit(document_->scene());
    updateTitle();
  });
}

void MainWindow::showForceLimit() {
  const arm::Preset* preset = arm::findPreset(document_->scene().arm);
  if (preset == nullptr) return;
  const double limit_N = preset->continuous_force_N * parts_.host.forceShare();
  view_->setForceLimit(limit_N);
  status_->setForceLimit(limit_N);
}

void MainWindow::connectPlayer() {
  connect(player_, &Player::opened, this, &MainWindow::replayBegins);
  connect(player_, &Player::closed, this, &MainWindow::replayEnds);
  connect(player_, &Player::failed, this, [this](const QString& path, const Problems& problems) {
    const QString file = QFileInfo(path).fileName();
    tellOfSession(player_->isOpen() ? tr("A scene of “%1” cannot be run. The one before it stays.").arg(file)
                                    : tr("“%1” was not opened. Scene and arm stay as they are.").arg(file),
                  problems);
  });
}

void MainWindow::connectGhost() {
  connect(ghost_, &GhostHand::opened, this, [this] {
    const LoadedGhost& ghost = ghost_->ghost();
    if (ghost.damage.empty()) return;
    tellOfSession(tr("“%1” is damaged. What could be read is followed.").arg(QString::fromStdString(ghost.name)),
                  ghost.damage);
  });
  connect(ghost_, &GhostHand::failed, this, [this](const QString& path, const Problems& problems) {
    tellOfSession(tr("“%1” cannot be followed. Everything stays as it is.").arg(QFileInfo(path).fileName()), problems);
  });
}

void MainWindow::connectRate() {
  connect(rate_, &ServoRate::changed, this, [this](int, int rate_hz) {
    faults_->setRate(rate_hz);
    live_->setRate(rate_hz);
    status_->measureAnew();
    second_->setRate(rate_hz);
  });
}

void MainWindow::connectArms() {
  connect(arms_, &ArmChoice::changed, this, [this] {
    hand_->setAbsent(arms_->simulated() == nullptr);
    status_->presentDevice(player_->isOpen());
    status_->measureAnew();
  });
  connect(arms_, &ArmChoice::began, identify_, &IdentifyTool::end);  // it was to measure the arm before
}

void MainWindow::tellOfSession(const QString& what, const Problems& problems) {
  showProblemsBox("dialog.session_problems", tr("Recorded session"), what, problems, this);
}

void MainWindow::replayBegins() {
  const device::Recorded& recorded = player_->recorded();
  if (!recorded.damage.empty()) {
    tellOfSession(tr("“%1” is damaged. What could be read is replayed.").arg(QString::fromStdString(recorded.name)),
                  recorded.damage);
  }
  hand_->setReplaying(true);
  status_->presentDevice(true);
}

void MainWindow::replayEnds() {
  hand_->setReplaying(false);
  status_->presentDevice();
}

void MainWindow::openSession(const QString& path) {
  actions_->perform("replay.open", path);
}

void MainWindow::updateTitle() {
  const QString title = document_->isMirrored() ? tr("%1 (mirrored)[*] – Underact") : tr("%1[*] – Underact");
  setWindowTitle(document_->isOpen() ? title.arg(sceneText(document_->scene().title)) : tr("Underact"));
  setWindowModified(document_->modified());
  setWindowFilePath({});
}

void MainWindow::setTheme(const Theme& theme) {
  sheets_->set(gui::styleSheet(theme));
  actions_->setIcons([&theme](const QString& name) { return icon(name, theme); });
  setWindowIcon(icon("underact", theme));
  view_->setTheme(theme);
  compare_->setTheme(theme);
  replay_bar_->setTheme(theme);
  ghost_strip_->setTheme(theme);
  faults_->setTheme(theme);
  identify_->setTheme(theme);
  registration_->setTheme(theme);
  welcome_->setTheme(theme);
  tour_->setTheme(theme);
  for (Panel* panel : panels_) panel->setTheme(theme);
}

bool MainWindow::event(QEvent* event) {
  if (event->type() == QEvent::StatusTip && status_ != nullptr) {
    status_->setTip(static_cast<QStatusTipEvent*>(event)->tip());  // beside what is always true, not over it
    return true;
  }
  if (event->type() == QEvent::ChildPolished) {  // Qt makes a bar of tabs where panels share a place
    auto* bar = qobject_cast<QTabBar*>(static_cast<QChildEvent*>(event)->child());
    if (bar != nullptr) {
      bar->setAccessibleName(tr("Panels in this place"));
      bar->setElideMode(Qt::ElideNone);  // many are scrolled: "S…" says nothing
    }
  }
  if (event->type() == QEvent::WindowStateChange || event->type() == QEvent::Hide) {
    pacer_->setSeen(isVisible() && !isMinimized());
  }
  return QMainWindow::event(event);
}

void MainWindow::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  pacer_->setSeen(true);
  if (!arranged_ && settings_.layout.isEmpty()) arrangeDocks();  // sizes are known only now
  if (!std::exchange(arranged_, true)) actions_->perform("view.projector", settings_.projector);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (visitors_->isOn() && !qApp->isSavingSession()) {  // the demonstrator's panel has the way out
    event->ignore();
    return;
  }
  visitors_->leave();
  actions_->perform("lesson.leave");  // what is asked about and remembered is the user's own
  if (!files_->settleEdits()) {
    event->ignore();
    return;
  }
  static_cast<SessionsPanel*>(panels_["sessions"])->finish();
  player_->close();
  if (!files_->settleEdits()) {  // those from before the replay
    event->ignore();
    return;
  }
  parts_.host.stop();
  second_->setOn(false);
  identify_->end();
  actions_->perform("calibration.cancel");  // the scene's own stiffness, before anybody else looks
  remember();
  event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (visitors_->isOn()) return;
  const QList<QUrl> urls = event->mimeData()->urls();
  if (urls.size() == 1 && urls.first().isLocalFile()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  if (visitors_->isOn()) return;
  event->acceptProposedAction();
  const QString path = event->mimeData()->urls().first().toLocalFile();
  actions_->perform(isSession(path) ? "replay.open" : "scene.open", path);
}

}  // namespace underact::gui
