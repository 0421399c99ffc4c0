// Builds the window; its behaviour is in main_window.cpp.
#include <QTimer>
#include <QToolBar>
#include <QVBoxLayout>

#include "app/gui/arms/second_arm.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/deferred_style_sheet.h"
#include "app/gui/kit/frame_pacer.h"
#include "app/gui/kit/problems_dialog.h"
#include "app/gui/kit/stop_key.h"
#include "app/gui/kit/tab_order.h"
#include "app/gui/model/arm_choice.h"
#include "app/gui/model/document.h"
#include "app/gui/model/window_scene.h"
#include "app/gui/view/hand_actions.h"
#include "app/gui/view/scene_view.h"
#include "app/gui/view/view_actions.h"
#include "app/gui/window/docks.h"
#include "app/gui/window/drop_overlay.h"
#include "app/gui/window/main_window.h"
#include "app/gui/window/menus.h"
#include "app/gui/window/notice.h"
#include "app/gui/window/purpose.h"
#include "app/gui/window/rail.h"
#include "app/gui/window/stop_banner.h"
#include "app/gui/window/window_actions.h"
#include "app/gui/window/window_watch.h"
#include "app/gui/window/yield_letters.h"

namespace underact::gui {

constexpr int kLayoutVersion = 10;  // count up when a dock is added: an old layout would hide it

MainWindow::MainWindow(const WindowParts& given, std::vector<FeatureRow> rows)
    : given_(given),
      rows_(std::move(rows)),
      pages_(helpPages(rows_)),
      settings_(readSettings()),
      services_(given, settings_, this),
      pacer_(new FramePacer(this)),
      sheets_(new DeferredStyleSheet(this)) {
  setObjectName("window");
  setAcceptDrops(true);
  setDockNestingEnabled(true);
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  resize(1280, 800);
  setMinimumSize(800, 560);
  given_.theme.choose(settings_.theme);
  buildFeatures();
  connect(services_.document, &Document::opened, this, &MainWindow::sceneOpened);
  connect(services_.document, &Document::modifiedChanged, this, &MainWindow::updateTitle);
  connect(services_.document, &Document::edited, this, &MainWindow::updateTitle);
  updateTitle();
  restore();
  setTheme(given_.theme.theme());
  connect(&given_.theme, &ThemeWatcher::changed, this, &MainWindow::setTheme);
  const auto* const key =
      new StopKey([this] { actions().perform("session.stop"); },
                  [this] { return services_.arms->simulated() == nullptr || services_.second->isReal(); }, this);
  if (given.busy_limit_s > 0.0)
    watch_ = std::make_unique<WindowWatch>(given.host, *services_.second, *key, given.busy_limit_s);
  banner_ = new StopBanner(view());
  connect(banner_, &QPushButton::clicked, this, [this] { actions().perform("session.start"); });
  connect(pacer_, &FramePacer::frame, this, &MainWindow::frame);
  pacer_->start();
}

void MainWindow::buildFeatures() {
  const FeatureParts parts = services_.parts(given_, settings_, pages_, [this] { return busyReason(); });
  services_.steered->setDrain([this] { drain(); });
  new Notice(view(), actions());
  drop_ = new DropOverlay(view());
  addWindowActions(
      parts, rows_, [this] { docks_->arrange(purpose()); },
      [this](const QString& key) {
        // Later: the button and the menu that asked for it are replaced.
        QMetaObject::invokeMethod(
            this, [this, key] { choosePurpose(key); }, Qt::QueuedConnection);
      });
  addViewActions(actions(), view(), given_.theme);
  addHandActions(actions(), parts.hand, settings_.keeps_holding);
  ServoListeners tools;
  for (const FeatureRow& row : rows_) {
    if (row.make != nullptr) row.make(parts, tools);
  }
  docks_ = std::make_unique<Docks>(rows_, parts);
  listeners_.assign(docks_->panels().begin(), docks_->panels().end());
  listeners_.insert(listeners_.end(), tools.begin(), tools.end());
  buildBars();
}

void MainWindow::buildBars() {
  buildMenus(this, actions(), *services_.recent, purpose());
  buildToolBar(this, actions(), purpose());
  buildRail(this, actions(), purpose());
  actions().find(QString("purpose.%1").arg(purpose().key))->setChecked(true);
  yieldLetters(*this);
  // From left to right and top to bottom: tool bar, rail, the first panel, the view and its strips, then the other
  // panels.
  const std::vector<Panel*>& panels = docks_->panels();
  QList<QWidget*> groups{findChild<QToolBar*>("toolbar"), findChild<QToolBar*>("rail")};
  if (!panels.empty()) groups << panels.front();
  groups << &view();
  for (int index = 1; index < services_.middle->count(); ++index) groups << services_.middle->itemAt(index)->widget();
  for (std::size_t index = 1; index < panels.size(); ++index) groups << panels[index];
  orderTabs(groups);
}

const Purpose& MainWindow::purpose() const {
  return purposeOf(settings_.purpose);
}

/// Each purpose has a layout of its own, which comes back with it.
void MainWindow::choosePurpose(const QString& key) {
  if (key == purpose().key) return;
  settings_.layouts[purpose().key] = saveState(kLayoutVersion);
  settings_.purpose = key;
  buildBars();
  setTheme(given_.theme.theme());  // the new buttons' icons
  if (!restoreState(settings_.layouts.value(key), kLayoutVersion)) docks_->arrange(purpose());
}

void MainWindow::restore() {
  if (settings_.are_newer) {
    QTimer::singleShot(0, this, [this] {
      showProblemsBox("dialog.newer_settings", tr("Settings"),
                      tr("The settings on this computer were written by a newer version of Underact. This version "
                         "starts with its defaults and leaves the saved settings unchanged."),
                      {}, this);
    });
  }
  if (!settings_.geometry.isEmpty()) restoreGeometry(settings_.geometry);
  QByteArray& layout = settings_.layouts[purpose().key];
  if (!layout.isEmpty() && !restoreState(layout, kLayoutVersion)) layout.clear();
  actions().perform("scene.left_handed", settings_.left_handed);
}

void MainWindow::remember() {
  for (ServoListener* listener : listeners_) listener->remember(settings_);
  services_.remember(settings_);
  settings_.geometry = saveGeometry();
  settings_.purpose = purpose().key;
  settings_.layouts[settings_.purpose] = saveState(kLayoutVersion);
  settings_.theme = given_.theme.choice();
  if (given_.chosen != nullptr) settings_.device = services_.arms->wanted();
  writeSettings(settings_);
}

}  // namespace underact::gui
