#include "app/gui/kit/window_chrome.h"

#include <QDockWidget>
#include <QMenuBar>
#include <QStatusBar>
#include <QToolBar>

namespace underact::gui {

void WindowChrome::hideChrome(Keep keep) {
  if (is_off_) return;
  is_off_ = true;
  layout_ = window_->saveState();
  had_menus_ = !window_->menuBar()->isHidden();
  had_status_ = !window_->statusBar()->isHidden();
  for (QDockWidget* dock : window_->findChildren<QDockWidget*>()) dock->hide();
  window_->statusBar()->hide();
  if (auto* const rail = window_->findChild<QToolBar*>("rail")) rail->hide();  // of panels, which are hidden, too
  if (keep == Keep::MenusAndTools) return;
  for (QToolBar* bar : window_->findChildren<QToolBar*>(Qt::FindDirectChildrenOnly)) bar->hide();
  window_->menuBar()->hide();
}

void WindowChrome::showChrome() {
  if (!is_off_) return;
  is_off_ = false;
  window_->restoreState(layout_);
  window_->menuBar()->setVisible(had_menus_);
  window_->statusBar()->setVisible(had_status_);
}

}  // namespace underact::gui
