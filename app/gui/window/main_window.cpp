#include "app/gui/window/main_window.h"

#include <QAccessible>
#include <QAction>
#include <QCloseEvent>
#include <QMimeData>
#include <QStatusTipEvent>
#include <QTabBar>
#include <utility>

#include "app/gui/arms/second_arm.h"
#include "app/gui/feature/status_line.h"
#include "app/gui/files/scene_files.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/deferred_style_sheet.h"
#include "app/gui/kit/frame_pacer.h"
#include "app/gui/kit/icons.h"
#include "app/gui/kit/style.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/data_words.h"
#include "app/gui/model/player.h"
#include "app/gui/view/hand.h"
#include "app/gui/view/scene_view.h"
#include "app/gui/window/docks.h"
#include "app/gui/window/drop_overlay.h"
#include "app/gui/window/purpose.h"
#include "app/gui/window/stop_banner.h"
#include "app/gui/window/window_watch.h"

namespace underact::gui {
namespace {

constexpr int kNarrow_px = 900;

}  // namespace

/// Also for a window that was never closed: features end while everything they restore still exists.
MainWindow::~MainWindow() {
  for (ServoListener* listener : listeners_) listener->finish();
}

void MainWindow::frame() {
  services_.player->poll();
  for (ServoListener* listener : listeners_) listener->before();
  const servo::Snapshot snapshot = given_.host.snapshot();
  drain();
  services_.second->poll();
  if (pacer_->isSeen()) {
    if (snapshot.ticks > 0) services_.view->present(snapshot);  // before the first tick the stylus position is unknown
    services_.hand->present(snapshot);
    services_.status->present(snapshot);
    for (ServoListener* listener : listeners_) listener->present(snapshot);
    services_.presentForceLimit();
    presentMode(snapshot);
  }
  for (ServoListener* listener : listeners_) listener->poll(snapshot);
}

void MainWindow::drain() {
  given_.host.drain([this](const servo::TickRecord& record) {
    services_.player->add(record);
    for (ServoListener* listener : listeners_) listener->add(record);
  });
}

void MainWindow::presentMode(const servo::Snapshot& snapshot) {
  const bool faulted = snapshot.mode == servo::Mode::Faulted;
  const QString sentence = faulted ? sentenceText(describe(snapshot.report.fault)) : QString();
  if (fault_ != sentence) {  // the view shows it; a screen reader announces it at once
    fault_ = sentence;
    services_.status->setFault(sentence);
    QAccessibleEvent alert(services_.status, QAccessible::Alert);
    if (faulted) QAccessible::updateAccessibility(&alert);
  }
  if (banner_ != nullptr) {
    const bool may_start =
        services_.document->isOpen() && !services_.player->isOpen() && !services_.actions->isLocked();
    banner_->present(may_start && snapshot.mode == servo::Mode::Idle);
  }
  // Stop is always enabled: nobody in trouble should find it grey.
  const bool all_run =
      snapshot.mode == servo::Mode::Running && (!services_.second->isOn() || services_.second->servo().running());
  services_.actions->find("session.start")->setEnabled(services_.document->isOpen() && !all_run);
}

void MainWindow::sceneOpened() {
  if (!services_.document->showsRecorded()) settings_.last_scene = services_.document->path();
  services_.actions->find("scene.save_as")->setEnabled(true);
  presentMode(given_.host.snapshot());
  updateTitle();
}

void MainWindow::updateTitle() {
  const QString title = services_.document->isMirrored() ? tr("%1 (mirrored)[*] – Underact") : tr("%1[*] – Underact");
  // "[*]" is the mark of changes; twice, it is a part of the name.
  const QString name = sceneText(services_.document->scene().title).replace("[*]", "[*][*]");
  setWindowTitle(services_.document->isOpen() ? title.arg(name) : tr("Underact"));
  setWindowModified(services_.document->modified());
  setWindowFilePath({});
}

void MainWindow::setTheme(const Theme& theme) {
  sheets_->set(gui::styleSheet(theme));
  services_.actions->setIcons([&theme](const QString& name) { return icon(name, theme); });
  setWindowIcon(icon("underact", theme));
  services_.view->setTheme(theme);
  drop_->setTheme(theme);
  for (ServoListener* listener : listeners_) listener->setTheme(theme);
}

QStringList MainWindow::busyReason() const {
  QStringList sentences;
  for (const ServoListener* listener : listeners_) {
    if (const QString busy = listener->busyReason(); !busy.isEmpty()) sentences << busy;
  }
  return sentences;
}

bool MainWindow::event(QEvent* event) {
  if (event->type() == QEvent::StatusTip && docks_ != nullptr) {
    services_.status->setTip(static_cast<QStatusTipEvent*>(event)->tip());  // beside the status, not over it
    return true;
  }
  if (event->type() == QEvent::ChildPolished) {  // Qt makes a tab bar for panels that share a place
    auto* bar = qobject_cast<QTabBar*>(static_cast<QChildEvent*>(event)->child());
    if (bar != nullptr) {
      bar->setAccessibleName(tr("Panel tabs"));
      bar->setElideMode(Qt::ElideNone);  // scroll many tabs rather than shorten them to "S…"
    }
  }
  // In the smallest window the view gives up what its panels need to be seen whole.
  if (event->type() == QEvent::Resize) services_.view->setMinimumWidth(width() < kNarrow_px ? 300 : 320);
  if (event->type() == QEvent::WindowStateChange || event->type() == QEvent::Hide) {
    pacer_->setSeen(isVisible() && !isMinimized());
  }
  return QMainWindow::event(event);
}

void MainWindow::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  pacer_->setSeen(true);
  if (!arranged_ && settings_.layouts.value(purpose().key).isEmpty())
    docks_->arrange(purpose());  // sizes are not known earlier
  if (!std::exchange(arranged_, true)) services_.actions->perform("view.projector", settings_.projector);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  for (const ServoListener* listener : listeners_) {
    if (!listener->mayClose()) return event->ignore();
  }
  for (ServoListener* listener : listeners_) listener->leave();
  if (!services_.files->settleEdits()) return event->ignore();
  const bool shows_another = services_.document->showsRecorded();
  for (ServoListener* listener : listeners_) listener->finish();
  services_.player->close();
  if (shows_another && !services_.files->settleEdits()) return event->ignore();  // edits from before the replay
  given_.host.stop();
  services_.second->setOn(false);
  remember();
  event->accept();
}

/// Accepted, too, if nothing opens it: Qt would not say that it has left.
void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (services_.actions->isLocked() || !event->mimeData()->hasUrls()) return;
  drop_->present(draggedOf(*event->mimeData()));
  event->setDropAction(Qt::CopyAction);  // whoever drags it must not remove it
  event->accept();
}

void MainWindow::dragMoveEvent(QDragMoveEvent* event) {
  event->setDropAction(Qt::CopyAction);
  event->setAccepted(drop_->dragged().opens);
}

void MainWindow::dragLeaveEvent(QDragLeaveEvent*) {
  drop_->hide();
}

void MainWindow::dropEvent(QDropEvent* event) {
  drop_->hide();
  const QString path = drop_->dragged().path;
  if (services_.actions->isLocked() || path.isEmpty()) return;
  services_.status->setTip({});  // the pointer came without leaving what it was over
  event->setDropAction(Qt::CopyAction);
  event->accept();
  services_.actions->perform("scene.open", path);
}

}  // namespace underact::gui
