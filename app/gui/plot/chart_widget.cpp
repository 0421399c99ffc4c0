#include "app/gui/plot/chart_widget.h"

#include <QApplication>
#include <QClipboard>
#include <QEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/gui/kit/accessible_widgets.h"
#include "app/gui/plot/chart.h"

namespace underact::gui {
namespace {

constexpr double kMaxEnlarged = 1e5;  // of the whole range

/// The range enlarged about a point in it, inside the whole.
void enlargeRange(double& from, double& to, double about, double factor, double whole_from, double whole_to) {
  const double min = (whole_to - whole_from) / kMaxEnlarged;
  const double span = std::clamp((to - from) / factor, min, whole_to - whole_from);
  const double share = (about - from) / (to - from);
  from = std::clamp(about - share * span, whole_from, whole_to - span);
  to = from + span;
}

}  // namespace

ChartWidget::ChartWidget(QWidget* parent) : QWidget(parent) {
  setAccessibleRole(this, QAccessible::Chart);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setStatusTip(
      tr("Wheel: enlarge in time; Ctrl and wheel: in value. Shift and drag: a rectangle. Double click: show all. Right "
         "click: copy or save."));
}

ChartWidget::~ChartWidget() = default;

void ChartWidget::paint(QPaintDevice& paper, bool is_on_screen) {
  const QSize pixels = (QSizeF(size()) * devicePixelRatioF()).toSize();
  const bool places = pixels != placed_;
  placed_ = pixels;
  if (places) place(devicePixelRatioF());
  prepare(places);
  QPainter painter(&paper);
  painter.fillRect(rect(), background_);
  for (Chart* chart : shown()) chart->paint(painter);
  if (is_on_screen) paintCursor(painter);
  ++frames_;
}

void ChartWidget::paintCursor(QPainter& painter) const {
  const Chart* const under = pointer_ && !pressed_ ? chartAt(*pointer_) : nullptr;
  if (under != nullptr) {
    for (const Chart* chart : linkedTo(*under)) {
      const double x = chart == under ? pointer_->x() : chart->placeOf(*under->xAt(*pointer_)).x();
      chart->paintReadings(painter, {x, chart == under ? pointer_->y() : chart->axes().center().y()});
    }
  }
  if (pressed_ && is_rectangle_) {
    painter.setPen(QPen(ink_, 1.0, Qt::DashLine));
    painter.setBrush(faint(ink_, 0.1));
    painter.drawRect(QRectF(*pressed_, last_).normalized());
  }
  if (!hasFocus()) return;
  painter.setPen(QPen(focusColour(palette()), 2.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0));
}

QImage ChartWidget::picture() {
  QImage image((QSizeF(size()) * devicePixelRatioF()).toSize().expandedTo({1, 1}), QImage::Format_RGB32);
  image.setDevicePixelRatio(devicePixelRatioF());
  paint(image, false);
  return image;
}

void ChartWidget::setBackground(const Theme& theme) {
  background_ = theme.background;
  ink_ = theme.ink;
}

void ChartWidget::draw() {
  update();
}

void ChartWidget::placeAnew() {
  placed_ = {};
  draw();
}

void ChartWidget::paintEvent(QPaintEvent*) {
  paint(*this, true);
}

void ChartWidget::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) placeAnew();
}

Chart* ChartWidget::chartAt(const QPointF& place) const {
  for (Chart* chart : shown()) {
    if (chart->axes().contains(place)) return chart;
  }
  return nullptr;
}

std::vector<Chart*> ChartWidget::linkedTo(const Chart& chart) const {
  std::vector<Chart*> linked;
  for (Chart* other : shown()) {
    const bool is_same_x = other->xTitle() == chart.xTitle() && other->whole().x_from == chart.whole().x_from &&
                           other->whole().x_to == chart.whole().x_to && !other->isPath() && !chart.isPath();
    if (other == &chart || is_same_x) linked.push_back(other);
  }
  return linked;
}

void ChartWidget::enlarge(const QPointF& about, double along_x, double along_y) {
  Chart* const chart = chartAt(about);
  if (chart == nullptr) return;
  const Chart::Part whole = chart->whole();
  const double x = *chart->xAt(about);
  for (Chart* one : linkedTo(*chart)) {
    Chart::Part part = one->seen();
    enlargeRange(part.x_from, part.x_to, x, along_x, whole.x_from, whole.x_to);
    if (one == chart) {
      const double share = (chart->axes().bottom() - about.y()) / chart->axes().height();
      enlargeRange(part.y_from, part.y_to, part.y_from + share * (part.y_to - part.y_from), along_y, whole.y_from,
                   whole.y_to);
    }
    if (part == one->whole()) {
      one->showWhole();
    } else {
      one->showPart(part);
    }
  }
  placeAnew();
  emit partChanged();
}

void ChartWidget::showAll() {
  for (Chart* chart : shown()) chart->showWhole();
  placeAnew();
  emit partChanged();
}

bool ChartWidget::showsPart() const {
  const std::vector<Chart*> all = shown();
  return std::any_of(all.begin(), all.end(), [](const Chart* chart) { return chart->showsPart(); });
}

void ChartWidget::move(Chart& chart, const QPointF& by_px) {
  const Chart::Part whole = chart.whole();
  for (Chart* one : linkedTo(chart)) {
    Chart::Part part = one->seen();
    const double dx = std::clamp(-by_px.x() / one->axes().width() * (part.x_to - part.x_from),
                                 whole.x_from - part.x_from, whole.x_to - part.x_to);
    part.x_from += dx;
    part.x_to += dx;
    if (one == &chart) {
      const double dy = std::clamp(by_px.y() / one->axes().height() * (part.y_to - part.y_from),
                                   whole.y_from - part.y_from, whole.y_to - part.y_to);
      part.y_from += dy;
      part.y_to += dy;
    }
    if (one->showsPart()) one->showPart(part);
  }
  placeAnew();
  emit partChanged();
}

void ChartWidget::enlargeRectangle() {
  Chart* const chart = chartAt(*pressed_);
  if (chart == nullptr) return;
  const QRectF box = QRectF(*pressed_, last_).normalized() & chart->axes();
  if (box.width() < 4.0 || box.height() < 4.0) return;
  const Chart::Part seen = chart->seen();
  const QRectF& axes = chart->axes();
  const auto x = [&](double px) { return seen.x_from + (px - axes.left()) / axes.width() * (seen.x_to - seen.x_from); };
  const auto y = [&](double px) {
    return seen.y_from + (axes.bottom() - px) / axes.height() * (seen.y_to - seen.y_from);
  };
  for (Chart* one : linkedTo(*chart)) {
    Chart::Part part = one->seen();
    part.x_from = x(box.left());
    part.x_to = x(box.right());
    if (one == chart) {
      part.y_from = y(box.bottom());
      part.y_to = y(box.top());
    }
    one->showPart(part);
  }
  placeAnew();
  emit partChanged();
}

QString ChartWidget::readingsAt(const QPointF& place) const {
  const Chart* const chart = chartAt(place);
  if (chart == nullptr) return {};
  QStringList lines;
  for (const Chart::Reading& reading : chart->readingsAt(place))
    lines << QString("%1: %2").arg(reading.name).arg(reading.y);
  return lines.join('\n');
}

QString ChartWidget::dataText(QChar separator) const {
  QStringList parts;
  for (const Chart* chart : shown()) parts << chart->asText(separator);
  return parts.join('\n');
}

void ChartWidget::copyPicture() {
  QApplication::clipboard()->setImage(picture());
}

void ChartWidget::copyData() {
  QApplication::clipboard()->setText(dataText(QLatin1Char('\t')));
}

}  // namespace underact::gui
