#include "app/gui/replay/scrub_slider.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QStyle>
#include <QToolTip>
#include <cstdlib>

#include "app/gui/kit/icons.h"

namespace underact::gui {
namespace {

constexpr int kTick_px = 5, kNear_px = 4;

}  // namespace

ScrubSlider::ScrubSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
}

void ScrubSlider::setMarks(const std::vector<device::RecordedMark>& marks) {
  marks_ = marks;
  update();
}

void ScrubSlider::setLoop(const std::optional<std::pair<std::int64_t, std::int64_t>>& rows) {
  if (rows == loop_) return;
  loop_ = rows;
  update();
}

void ScrubSlider::setTheme(const Theme& theme) {
  theme_ = theme;
  update();
}

int ScrubSlider::handle() const {
  return style()->pixelMetric(QStyle::PM_SliderLength, nullptr, this);
}

int ScrubSlider::xOf(std::int64_t row) const {
  return handle() / 2 +
         QStyle::sliderPositionFromValue(minimum(), maximum(), static_cast<int>(row), width() - handle());
}

int ScrubSlider::rowAt(int x) const {
  return QStyle::sliderValueFromPosition(minimum(), maximum(), x - handle() / 2, width() - handle());
}

void ScrubSlider::paintEvent(QPaintEvent* event) {
  QSlider::paintEvent(event);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (loop_) {
    painter.setPen(QPen(theme_.constraint, 3.0));
    painter.drawLine(xOf(loop_->first), height() - 2, xOf(loop_->second), height() - 2);
  }
  for (const device::RecordedMark& mark : marks_) {
    const int x = xOf(mark.row);
    painter.setPen(QPen(mark.is_fault ? alarm(theme_) : theme_.ink, 2.0));
    if (mark.is_fault) {
      painter.drawLine(x - 2, 1, x + 2, kTick_px);
      painter.drawLine(x - 2, kTick_px, x + 2, 1);
    } else {
      painter.drawLine(x, 0, x, kTick_px);
    }
  }
}

void ScrubSlider::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return QSlider::mousePressEvent(event);
  setSliderDown(true);
  setSliderPosition(rowAt(qRound(event->position().x())));
  event->accept();
}

void ScrubSlider::mouseMoveEvent(QMouseEvent* event) {
  if (isSliderDown()) setSliderPosition(rowAt(qRound(event->position().x())));
  event->accept();
}

void ScrubSlider::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) setSliderDown(false);
  event->accept();
}

/// The tool tip of a mark under the pointer is its label.
bool ScrubSlider::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QSlider::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  QStringList labels;
  for (const device::RecordedMark& mark : marks_) {
    if (std::abs(xOf(mark.row) - help->pos().x()) <= kNear_px) labels << QString::fromStdString(mark.label);
  }
  QToolTip::showText(help->globalPos(), labels.isEmpty() ? toolTip() : labels.join("\n"), this);
  return true;
}

}  // namespace underact::gui
