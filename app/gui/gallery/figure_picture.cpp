#include "app/gui/gallery/figure_picture.h"

#include <QPainter>

#include "app/gui/kit/accessible_widgets.h"

namespace underact::gui {

FigurePicture::FigurePicture(QWidget* parent) : QWidget(parent) {
  setAccessibleRole(this, QAccessible::Graphic);
  setMinimumSize(240, 160);
}

void FigurePicture::setPicture(const QString& path, const QString& words) {
  image_ = path.isEmpty() ? QImage() : QImage(path);
  words_ = words;
  scaled_ = {};
  update();
}

void FigurePicture::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (image_.isNull()) {
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(rect().adjusted(16, 16, -16, -16), static_cast<int>(Qt::AlignCenter) | Qt::TextWordWrap, words_);
    return;
  }
  const qreal ratio = devicePixelRatioF();
  const QSize room = size() * ratio;
  const QSize fits = image_.size().scaled(room, Qt::KeepAspectRatio).boundedTo(image_.size());
  if (scaled_.size() != fits) {
    // Qt's smooth scaling averages pixels, so thin lines stay visible.
    scaled_ = QPixmap::fromImage(image_.scaled(fits, Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
    scaled_.setDevicePixelRatio(ratio);
  }
  const QSizeF shown = QSizeF(scaled_.size()) / ratio;
  const QRectF where(QPointF((width() - shown.width()) / 2, (height() - shown.height()) / 2), shown);
  painter.fillRect(where, Qt::white);
  painter.drawPixmap(where.topLeft(), scaled_);
}

}  // namespace underact::gui
