#include "app/gui/gain_row.h"

#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QSignalBlocker>
#include <QStyle>
#include <QStyleOptionSlider>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace underact::gui {
namespace {

constexpr int kPauseBetweenSteps_ms = 1000;  // a run of keys or wheel steps is over after so long
constexpr double kLargest = 1e6;

QString translated(const char* text) {
  return QCoreApplication::translate("gain", text);
}

}  // namespace

const GainKind& gainKind(int gain) {
  static const GainKind kKinds[kGainKinds] = {
      {"kp", QT_TRANSLATE_NOOP("gain", "Stiffness"),
       QT_TRANSLATE_NOOP("gain",
                         "How hard the stylus is pulled back for each millimetre: f = kp e (proportional gain)."),
       "N/mm", 100, 200, 3},
      {"kd", QT_TRANSLATE_NOOP("gain", "Damping"),
       QT_TRANSLATE_NOOP("gain", "How hard a change of the error is resisted: f = kd de/dt (derivative gain)."),
       "N s/mm", 10000, 100, 5},
      {"ki", QT_TRANSLATE_NOOP("gain", "Integral"),
       QT_TRANSLATE_NOOP("gain", "How fast an error that stays is worked off: df/dt = ki e (integral gain)."),
       "N/(mm s)", 100, 500, 3}};
  return kKinds[gain];
}

void MarkedSlider::setMark(double position) {
  mark_ = position;
  update();
}

void MarkedSlider::paintEvent(QPaintEvent* event) {
  QSlider::paintEvent(event);
  QStyleOptionSlider option;
  initStyleOption(&option);
  const QRect groove = style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderGroove, this);
  const int handle = style()->pixelMetric(QStyle::PM_SliderLength, &option, this);
  if (mark_ < minimum() || mark_ > maximum()) return;
  const double share = (mark_ - minimum()) / (maximum() - minimum());
  const double x = groove.left() + 0.5 * handle + share * (groove.width() - handle);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(palette().color(QPalette::WindowText));
  const double y = height() - 1.0;
  painter.drawPolygon(QPolygonF{{{x - 3.5, y}, {x + 3.5, y}, {x, y - 4.5}}});
}

void MarkedSlider::mouseDoubleClickEvent(QMouseEvent* event) {
  event->accept();
  emit resetAsked();
}

void MarkedSlider::wheelEvent(QWheelEvent* event) {
  // Scrolling the panel past a slider must not change what a hand feels: first the focus, then the wheel.
  if (hasFocus())
    QSlider::wheelEvent(event);
  else
    event->ignore();
}

GainRow::GainRow(int gain, int axis, QWidget* parent)
    : QWidget(parent),
      kind_(gainKind(gain)),
      label_(new QLabel(this)),
      slider_(new MarkedSlider(this)),
      number_(new QDoubleSpinBox(this)) {
  const QChar letter('x' + axis);
  const QString name = QString("panel.gains.%1.%2").arg(kind_.key).arg(letter);
  setObjectName(name);
  label_->setBuddy(number_);
  label_->setMinimumWidth(fontMetrics().horizontalAdvance("q1"));  // x and q1: the sliders stay where they are
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(8);
  row->addWidget(label_);
  row->addWidget(slider_, 1);
  row->addWidget(number_);

  const QString tip =
      translated(kind_.tip) + "\n" + tr("The mark is the scene's own value; a double click goes back to it.");
  slider_->setObjectName(name + ".slider");
  slider_->setFocusPolicy(Qt::StrongFocus);
  slider_->setRange(0, kind_.slider_steps);
  slider_->setPageStep(kind_.slider_steps / 20);
  slider_->setMinimumHeight(24);
  slider_->setMinimumWidth(64);
  number_->setObjectName(name + ".number");
  number_->setDecimals(kind_.decimals);
  number_->setRange(0.0, kLargest);
  number_->setSingleStep(1.0 / kind_.steps_per_unit);
  number_->setSuffix(QString(" ") + kind_.unit);
  number_->setKeyboardTracking(false);  // 0.5 is not first 0, then 0.5: a zero may be refused
  number_->setFocusPolicy(Qt::StrongFocus);
  number_->setAlignment(Qt::AlignRight);
  number_->setButtonSymbols(QAbstractSpinBox::NoButtons);  // the slider and the arrow keys do that
  // Not as wide as kLargest would need: the same for all gains, so that their sliders end in one line.
  number_->setFixedWidth(fontMetrics().horizontalAdvance("00.000 N/(mm s)") + 16);
  for (QWidget* widget :
       {static_cast<QWidget*>(label_), static_cast<QWidget*>(slider_), static_cast<QWidget*>(number_)}) {
    widget->setToolTip(tip);
  }
  number_->installEventFilter(this);
  setAxisName(letter);

  connect(slider_, &QSlider::sliderPressed, this, [this] { new_drag_ = true; });
  connect(slider_, &QSlider::sliderReleased, this, [this] { new_drag_ = true; });
  connect(slider_, &QSlider::valueChanged, this,
          [this](int position) { send(static_cast<double>(position) / kind_.steps_per_unit); });
  connect(number_, &QDoubleSpinBox::valueChanged, this, [this](double value) { send(value); });
  connect(slider_, &MarkedSlider::resetAsked, this, [this] {
    new_drag_ = true;
    send(own_);
  });
}

void GainRow::present(double value, double own) {
  own_ = own;
  const QSignalBlocker silent_slider(slider_), silent_number(number_);  // to show a value is not to ask for it
  slider_->setMark(own * kind_.steps_per_unit);
  if (!slider_->isSliderDown())
    slider_->setValue(static_cast<int>(std::min(std::round(value * kind_.steps_per_unit), 1e9)));
  number_->setValue(value);
}

void GainRow::setAxisName(const QString& axis) {
  const QString spoken = QString("%1 %2").arg(translated(kind_.name), axis);
  label_->setText(axis);
  slider_->setAccessibleName(tr("%1, slider").arg(spoken));
  number_->setAccessibleName(tr("%1, %2").arg(spoken, kind_.unit));
}

void GainRow::setWarning(const QString& reason) {
  if (number_->property("amber").toBool() == !reason.isEmpty()) return;
  number_->setProperty("amber", !reason.isEmpty());
  style()->unpolish(number_);
  style()->polish(number_);
}

bool GainRow::eventFilter(QObject* watched, QEvent* event) {
  if (watched == number_ && event->type() == QEvent::Wheel && !number_->hasFocus()) {
    event->ignore();
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

void GainRow::send(double value) {
  const bool dragging = slider_->isSliderDown();
  const bool fresh =
      new_drag_ || (!dragging && (!since_last_.isValid() || since_last_.elapsed() > kPauseBetweenSteps_ms));
  new_drag_ = false;
  since_last_.start();
  emit changed(value, fresh);
}

}  // namespace underact::gui
