#include "app/gui/servo/share_bar.h"

#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QStyle>
#include <algorithm>

#include "app/gui/kit/message_label.h"
#include "app/gui/kit/tight_layout.h"

namespace underact::gui {

ShareBar::ShareBar(const QString& object_name, const Words& words, bool with_note, QWidget* parent)
    : Painted(object_name, words.name, words.tip, parent), track_(new QLabel(this)), value_(new QLabel(this)) {
  auto* label = new QLabel(words.name, this);
  label->setFixedWidth(fontMetrics().horizontalAdvance(words.widest_name) + 4);
  track_->setObjectName(object_name + ".bar");
  track_->setMinimumWidth(32);
  track_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  nameWidget(value_, object_name + ".value", words.name);
  value_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  QFont bold = font();
  bold.setBold(true);
  value_->setFixedSize(QFontMetrics(bold).horizontalAdvance(words.widest_value) + 4, fontMetrics().lineSpacing());
  auto* grid = tight<QGridLayout>(this);
  grid->setHorizontalSpacing(4);
  grid->setVerticalSpacing(0);
  grid->addWidget(label, 0, 0);
  grid->addWidget(track_, 0, 1);
  grid->addWidget(value_, 0, 2);
  grid->setColumnStretch(1, 1);
  if (!with_note) return;
  note_ = new QLabel(this);
  nameWidget(note_, object_name + ".note", tr("%1, last active").arg(words.name));
  note_->setProperty("role", "quiet");
  note_->setMinimumHeight(fontMetrics().lineSpacing());
  grid->addWidget(note_, 1, 0, 1, 3);
}

void ShareBar::present(double share, const QString& value, bool acts) {
  if (acts == acts_ && share == share_ && value == value_->text()) return;
  share_ = share;
  value_->setText(value);
  if (acts != acts_) {
    acts_ = acts;
    value_->setProperty("role", acts ? "limited-text" : "");
    value_->style()->polish(value_);  // makes the style apply the property
  }
  update();
}

void ShareBar::setNote(const QString& note) {
  if (note_ != nullptr && note_->text() != note) note_->setText(note);
}

void ShareBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  const QRectF all(track_->x(), track_->y() + 0.5 * track_->height() - 4.0, track_->width(), 8.0);
  painter.setBrush(quiet(0.5));
  painter.drawRoundedRect(all, 3, 3);
  const double share = std::clamp(share_, 0.0, 1.0);
  if (!(share > 0.0)) return;
  painter.setBrush(acts_ ? theme_.force_limited : ink(0.5));
  painter.drawRoundedRect(QRectF(all.topLeft(), QSizeF(std::max(3.0, share * all.width()), all.height())), 3, 3);
}

}  // namespace underact::gui
