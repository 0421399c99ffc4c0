// Of chart_widget.h: mouse, keys, and the context menu.
#include <QContextMenuEvent>
#include <QFile>
#include <QMenu>
#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>

#include "app/gui/kit/file_question.h"
#include "app/gui/plot/chart.h"
#include "app/gui/plot/chart_widget.h"

namespace underact::gui {
namespace {

constexpr double kNotch = 1.25;  // one step of the wheel or of + and -
constexpr double kNotch_eighths = 120.0;
constexpr double kStep_px = 40.0;  // of an arrow key

}  // namespace

void ChartWidget::mousePressEvent(QMouseEvent* event) {
  const bool is_left = event->button() == Qt::LeftButton, is_middle = event->button() == Qt::MiddleButton;
  const bool is_rectangle = is_left && event->modifiers().testFlag(Qt::ShiftModifier);
  const bool moves = is_middle || (is_left && !is_rectangle && !isTaken(event->position()) && showsPart());
  if (chartAt(event->position()) == nullptr || !(is_rectangle || moves)) return QWidget::mousePressEvent(event);
  pressed_ = last_ = event->position();
  is_rectangle_ = is_rectangle;
}

void ChartWidget::mouseMoveEvent(QMouseEvent* event) {
  const QPointF by = event->position() - last_;
  pointer_ = last_ = event->position();
  if (pressed_ && !is_rectangle_) {
    if (Chart* const chart = chartAt(*pressed_)) move(*chart, by);
  }
  draw();
}

void ChartWidget::mouseReleaseEvent(QMouseEvent* event) {
  if (!pressed_) return QWidget::mouseReleaseEvent(event);
  last_ = event->position();
  if (is_rectangle_) enlargeRectangle();
  pressed_.reset();
  draw();
}

void ChartWidget::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) showAll();
}

void ChartWidget::wheelEvent(QWheelEvent* event) {
  const QPoint turned = event->angleDelta();
  const double notches = (turned.y() != 0 ? turned.y() : turned.x()) / kNotch_eighths;
  if (chartAt(event->position()) == nullptr || notches == 0.0) return event->ignore();
  const double factor = std::pow(kNotch, notches);
  const bool of_value = event->modifiers().testFlag(Qt::ControlModifier);
  enlarge(event->position(), of_value ? 1.0 : factor, of_value ? factor : 1.0);
  event->accept();
}

void ChartWidget::keyPressEvent(QKeyEvent* event) {
  const std::vector<Chart*> charts = shown();
  Chart* chart = pointer_ ? chartAt(*pointer_) : nullptr;
  if (chart == nullptr && !charts.empty()) chart = charts.front();
  if (chart == nullptr) return QWidget::keyPressEvent(event);
  const bool of_value = event->modifiers().testFlag(Qt::ControlModifier);
  const auto by = [&](double factor) {
    enlarge(chart->axes().center(), of_value ? 1.0 : factor, of_value ? factor : 1.0);
  };
  switch (event->key()) {
    case Qt::Key_Plus:
      return by(kNotch);
    case Qt::Key_Minus:
      return by(1.0 / kNotch);
    case Qt::Key_Home:
      return showAll();
    case Qt::Key_Left:
      return move(*chart, {kStep_px, 0.0});
    case Qt::Key_Right:
      return move(*chart, {-kStep_px, 0.0});
    case Qt::Key_Up:
      return move(*chart, {0.0, kStep_px});
    case Qt::Key_Down:
      return move(*chart, {0.0, -kStep_px});
    default:
      QWidget::keyPressEvent(event);
  }
}

void ChartWidget::leaveEvent(QEvent* event) {
  pointer_.reset();
  draw();
  QWidget::leaveEvent(event);
}

void ChartWidget::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  draw();
}

void ChartWidget::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  draw();
}

void ChartWidget::contextMenuEvent(QContextMenuEvent* event) {
  auto* const menu = new QMenu(this);
  menu->setObjectName("plot.menu");
  menu->setAttribute(Qt::WA_DeleteOnClose);
  QAction* const all = menu->addAction(tr("&Show all"), this, &ChartWidget::showAll);
  all->setEnabled(showsPart());
  menu->addSeparator();
  menu->addAction(tr("Copy &picture"), this, &ChartWidget::copyPicture);
  menu->addAction(tr("Copy &data"), this, &ChartWidget::copyData);
  menu->addAction(tr("Save data &as…"), this, &ChartWidget::saveData);
  menu->popup(event->globalPos());
}

/// What is drawn, as CSV.
void ChartWidget::saveData() {
  askWhereToSave(this, "dialog.save_plot", tr("Save the data of the plots"), "plots.csv",
                 tr("CSV files (*.csv);;All files (*)"), [this](const QString& path) {
                   QFile file(path);
                   if (file.open(QIODevice::WriteOnly)) file.write(dataText(QLatin1Char(',')).toUtf8());
                 });
}

}  // namespace underact::gui
