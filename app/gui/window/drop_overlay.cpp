#include "app/gui/window/drop_overlay.h"

#include <QAccessible>
#include <QEvent>
#include <QFileInfo>
#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>

#include "app/gui/kit/larger_font.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/view/scene_view.h"

namespace underact::gui {
namespace {

constexpr int kMargin_px = 16, kRound_px = 12;

}  // namespace

DropOverlay::DropOverlay(SceneView& view)
    : Painted("drop", tr("A file over the window"), {}, &view),
      view_(view),
      sentence_(messageLabel("drop.sentence", tr("What dropping the file does"), "", this)),
      file_(messageLabel("drop.file", tr("The file"), "quiet", this)) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  hide();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4 * kMargin_px, 4 * kMargin_px, 4 * kMargin_px, 4 * kMargin_px);
  column->setSpacing(8);
  column->addStretch();
  for (QLabel* label : {sentence_, file_}) {
    label->setAlignment(Qt::AlignCenter);
    label->setTextFormat(Qt::PlainText);
    column->addWidget(label);
  }
  column->addStretch();
  sentence_->setFont(larger(sentence_->font(), 1.5));
  view_.installEventFilter(this);
}

void DropOverlay::present(const Dragged& dragged) {
  dragged_ = dragged;
  sentence_->setText(dragged.sentence);
  file_->setText(QFileInfo(dragged.path).fileName());
  setGeometry(view_.rect());
  show();
  raise();
  update();
  QAccessibleEvent alert(sentence_, QAccessible::Alert);
  QAccessible::updateAccessibility(&alert);
}

/// A dashed frame where it may land, a whole one where it may not.
void DropOverlay::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF frame = QRectF(rect()).adjusted(kMargin_px, kMargin_px, -kMargin_px, -kMargin_px);
  painter.setBrush(faint(theme_.background, 0.88));
  painter.setPen(QPen(readable(dragged_.opens ? theme_.target : theme_.force_limited, theme_), 3.0,
                      dragged_.opens ? Qt::DashLine : Qt::SolidLine));
  painter.drawRoundedRect(frame, kRound_px, kRound_px);
}

bool DropOverlay::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize && !isHidden()) setGeometry(view_.rect());
  return Painted::eventFilter(watched, event);
}

}  // namespace underact::gui
