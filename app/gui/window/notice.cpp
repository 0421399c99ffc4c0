#include "app/gui/window/notice.h"

#include <QAccessible>
#include <QDesktopServices>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QUrl>
#include <algorithm>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/view/scene_view.h"

namespace underact::gui {
namespace {

constexpr int kShown_ms = 10'000;
constexpr int kFoot_px = 16, kGauge_px = 64;        // the gauge is at the foot of the view, at the right
constexpr int kTries = 20, kBetweenTries_ms = 250;  // until the list of sessions has read the new one

bool isSessionFile(const QString& path) {
  return path.endsWith(".h5", Qt::CaseInsensitive) || path.endsWith(".hdf5", Qt::CaseInsensitive);
}

}  // namespace

Notice::Notice(SceneView& view, Actions& actions)
    : QFrame(&view),
      view_(view),
      actions_(actions),
      sentence_(messageLabel("notice.sentence", tr("What was done"), "", this)),
      show_(pushButton("notice.show", tr("Show"), tr("Shows it: a session in its list, another file in its folder."),
                       this)) {
  setObjectName("notice");
  setAccessibleName(tr("Notice"));
  setProperty("role", "card");
  setAttribute(Qt::WA_NoMousePropagation);
  hide();
  auto* close = pushButton("notice.close", tr("Close"), tr("Closes the notice."), this);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 8, 8, 8);
  row->setSpacing(8);
  row->addWidget(sentence_, 1);
  row->addWidget(show_);
  row->addWidget(close);
  leaves_.setInterval(kShown_ms);
  connect(&leaves_, &QTimer::timeout, this, [this] {
    if (!underMouse() && !isAncestorOf(view_.window()->focusWidget())) leave();
  });
  connect(show_, &QPushButton::clicked, this, &Notice::reveal);
  connect(close, &QPushButton::clicked, this, &Notice::leave);
  view_.installEventFilter(this);
  actions_.addCommand("notice.tell", [this](const QVariantList& what) {
    tell(what.value(0).toString(), what.value(1).toString());
    return true;
  });
}

void Notice::tell(const QString& sentence, const QString& path) {
  path_ = path;
  sentence_->setText(sentence);
  sentence_->setToolTip(path);
  show_->setVisible(!path.isEmpty());
  show();
  place();
  leaves_.start();
  QAccessibleEvent alert(sentence_, QAccessible::Alert);
  QAccessible::updateAccessibility(&alert);
}

void Notice::place() {
  const int max = std::max(200, view_.width() - 2 * kFoot_px);
  sentence_->setWordWrap(false);
  int width = sizeHint().width();
  if (width > max) {
    sentence_->setWordWrap(true);
    width = max;
  }
  resize(width, hasHeightForWidth() ? heightForWidth(width) : sizeHint().height());
  move((view_.width() - width) / 2, view_.height() - height() - kFoot_px - kGauge_px);
  raise();
}

void Notice::reveal() {
  if (isSessionFile(path_) && actions_.find("dock.sessions") != nullptr) {
    actions_.perform("dock.sessions", true);
    chooseSession(kTries);
  } else {
    const QFileInfo shown(path_);
    QDesktopServices::openUrl(QUrl::fromLocalFile(shown.isDir() ? path_ : shown.absolutePath()));
  }
  leave();
}

void Notice::chooseSession(int tries) {
  if (tries == 0 || actions_.perform("sessions.choose", path_)) return;
  QTimer::singleShot(kBetweenTries_ms, this, [this, tries] { chooseSession(tries - 1); });
}

void Notice::leave() {
  leaves_.stop();
  if (isAncestorOf(view_.window()->focusWidget())) view_.setFocus(Qt::OtherFocusReason);
  hide();
}

bool Notice::eventFilter(QObject* watched, QEvent* event) {
  const bool changes = event->type() == QEvent::Resize || event->type() == QEvent::FontChange;
  if (watched == &view_ && changes && !isHidden()) place();
  return QFrame::eventFilter(watched, event);
}

}  // namespace underact::gui
