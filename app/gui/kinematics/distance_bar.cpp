#include "app/gui/kinematics/distance_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/gui/kit/message_label.h"
#include "app/gui/kit/tight_layout.h"
#include "app/gui/kit/words.h"

namespace underact::gui {

DistanceBar::DistanceBar(const QString& object_name, const QString& name, const QString& tip, const Scale& scale,
                         QWidget* parent)
    : Painted(object_name, name, tip, parent),
      name_(name),
      scale_(scale),
      track_(new QLabel(this)),
      value_(new QLabel(this)),
      word_(new QLabel(this)) {
  auto* label = new QLabel(name, this);
  label->setFixedWidth(fontMetrics().horizontalAdvance("q6 gimbal 3") + 4);
  nameWidget(value_, object_name + ".value", name);
  value_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  value_->setFixedSize(fontMetrics().horizontalAdvance("000.0 mm") + 4, fontMetrics().lineSpacing());
  nameWidget(word_, object_name + ".word", tr("%1, warning when near").arg(name));
  word_->setProperty("role", "amber-text");
  word_->setFixedSize(fontMetrics().horizontalAdvance(tr("near")) + 12, fontMetrics().lineSpacing());
  track_->setObjectName(object_name + ".bar");
  track_->setMinimumWidth(64);
  track_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  auto* row = tight<QHBoxLayout>(this, 4);
  row->addWidget(label);
  row->addWidget(track_, 1);
  row->addWidget(value_);
  row->addWidget(word_);
}

void DistanceBar::setFarthest(double farthest) {
  scale_.farthest = farthest;
  update();
}

void DistanceBar::present(double distance) {
  const QString text = numberText(distance, scale_.decimals) + scale_.unit;
  if (distance == distance_ && text == value_->text()) return;
  distance_ = distance;
  value_->setText(text);
  word_->setText(isNear() ? tr("near") : QString());
  update();
}

void DistanceBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  const QRectF all(track_->x(), 0.5 * height() - 5.0, track_->width(), 10.0);
  painter.setBrush(quiet(0.5));
  painter.drawRoundedRect(all, 3, 3);
  const double share = std::clamp(distance_ / scale_.farthest, 0.0, 1.0);
  painter.setBrush(isNear() ? theme_.force : ink(0.5));
  painter.drawRoundedRect(QRectF(all.topLeft(), QSizeF(std::max(3.0, share * all.width()), all.height())), 3, 3);
  painter.setBrush(theme_.ink);  // the threshold of near
  painter.drawRect(QRectF(std::round(all.left() + scale_.near_below / scale_.farthest * all.width()) - 1.0,
                          all.top() - 3.0, 2.0, all.height() + 6.0));
}

}  // namespace underact::gui
