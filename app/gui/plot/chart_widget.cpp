#include "app/gui/plot/chart_widget.h"

#include <QEvent>
#include <QPainter>

#include "app/gui/kit/accessible_widgets.h"
#include "app/gui/plot/chart.h"

namespace underact::gui {

ChartWidget::ChartWidget(QWidget* parent) : QWidget(parent) {
  setAccessibleRole(this, QAccessible::Chart);
  setAttribute(Qt::WA_OpaquePaintEvent);
}

ChartWidget::~ChartWidget() = default;

void ChartWidget::paint(QPaintDevice& paper) {
  const QSize pixels = (QSizeF(size()) * devicePixelRatioF()).toSize();
  const bool places = pixels != placed_;
  placed_ = pixels;
  if (places) place(devicePixelRatioF());
  prepare(places);
  QPainter painter(&paper);
  painter.fillRect(rect(), background_);
  for (Chart* chart : shown()) chart->paint(painter);
  ++frames_;
}

QImage ChartWidget::picture() {
  QImage image((QSizeF(size()) * devicePixelRatioF()).toSize().expandedTo({1, 1}), QImage::Format_RGB32);
  image.setDevicePixelRatio(devicePixelRatioF());
  paint(image);
  return image;
}

void ChartWidget::setBackground(const Theme& theme) {
  background_ = theme.background;
}

void ChartWidget::draw() {
  update();
}

void ChartWidget::placeAnew() {
  placed_ = {};
  draw();
}

void ChartWidget::paintEvent(QPaintEvent*) {
  paint(*this);
}

void ChartWidget::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) placeAnew();
}

}  // namespace underact::gui
