#include "app/gui/kit/value_row.h"

#include <QGridLayout>
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

#include "app/gui/kit/number_box.h"

namespace underact::gui {
namespace {

constexpr int kPauseBetweenSteps_ms = 1000;  // a series of keys or wheel steps ends after this pause

}  // namespace

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

ValueRow::ValueRow(const ValueKind& kind, const QString& name, QWidget* parent)
    : QWidget(parent),
      kind_(kind),
      grid_(new QGridLayout(this)),
      label_(new QLabel(this)),
      slider_(new MarkedSlider(this)),
      number_(new NumberBox(this)) {
  setObjectName(name);
  label_->setBuddy(number_);
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setHorizontalSpacing(8);
  grid_->setVerticalSpacing(0);
  grid_->setColumnStretch(1, 1);
  grid_->addWidget(label_, 0, 0);
  grid_->addWidget(slider_, 0, 1);
  grid_->addWidget(number_, 0, 2);

  const QString mark = tr("The mark shows the scene's own value; a double click restores it.");
  const QString tip = kind.tip + "\n" + (kind.mark.isEmpty() ? mark : kind.mark);
  slider_->setObjectName(name + ".slider");
  slider_->setFocusPolicy(Qt::StrongFocus);
  slider_->setRange(0, kind.slider_steps);
  slider_->setPageStep(std::max(1, kind.slider_steps / 20));
  slider_->setMinimumHeight(24);
  slider_->setMinimumWidth(64);
  number_->setObjectName(name + ".number");
  number_->setDecimals(kind.decimals);
  number_->setRange(0.0, kind.max);
  number_->setSingleStep(1.0 / kind.steps_per_unit);
  if (!kind.unit.isEmpty()) number_->setSuffix(" " + kind.unit);
  number_->setKeyboardTracking(false);  // typing 0.5 must not first set 0, which may be refused
  number_->setFocusPolicy(Qt::StrongFocus);
  number_->setAlignment(Qt::AlignRight);
  number_->setButtonSymbols(QAbstractSpinBox::NoButtons);  // the slider and the arrow keys replace them
  // One width for all rows rather than that of the maximum, so that their sliders line up.
  number_->setFixedWidth(fontMetrics().horizontalAdvance("00.000 N/(mm s)") + 16);
  for (QWidget* widget :
       {static_cast<QWidget*>(label_), static_cast<QWidget*>(slider_), static_cast<QWidget*>(number_)}) {
    widget->setToolTip(tip);
  }
  number_->installEventFilter(this);

  connect(slider_, &QSlider::sliderPressed, this, [this] { new_drag_ = true; });
  connect(slider_, &QSlider::sliderReleased, this, [this] { new_drag_ = true; });
  connect(slider_, &QSlider::valueChanged, this,
          [this](int position) { send(static_cast<double>(position) / kind_.steps_per_unit); });
  connect(number_, &QDoubleSpinBox::valueChanged, this, [this](double value) { send(value); });
  connect(slider_, &MarkedSlider::resetAsked, this, [this] {
    if (!own_) return;
    new_drag_ = true;
    send(*own_);
  });
}

void ValueRow::present(double value, const std::optional<double>& own) {
  own_ = own;
  const QSignalBlocker silent_slider(slider_), silent_number(number_);  // showing a value must not emit a change
  slider_->setMark(own ? *own * kind_.steps_per_unit : -1.0);
  if (!slider_->isSliderDown())
    slider_->setValue(static_cast<int>(std::min(std::round(value * kind_.steps_per_unit), 1e9)));
  // Setting the same value again would erase what is being typed.
  if (number_->value() != value) number_->setValue(value);
}

void ValueRow::setLabel(const QString& label, const QString& spoken, const QString& widest) {
  label_->setText(label);
  label_->setMinimumWidth(fontMetrics().horizontalAdvance(widest));
  slider_->setAccessibleName(tr("%1, slider").arg(spoken));
  number_->setAccessibleName(kind_.unit.isEmpty() ? spoken : tr("%1, %2").arg(spoken, kind_.unit));
}

void ValueRow::setEnds(const QString& min, const QString& max) {
  auto* ends = new QHBoxLayout;
  ends->setSpacing(8);
  for (const QString& text : {min, max}) {
    auto* word = new QLabel(text, this);
    word->setProperty("role", "quiet");
    if (text == max) ends->addStretch(1);
    ends->addWidget(word);
  }
  grid_->addLayout(ends, 1, 1);
}

void ValueRow::setWarning(const QString& reason) {
  if (number_->property("amber").toBool() == !reason.isEmpty()) return;
  number_->setProperty("amber", !reason.isEmpty());
  style()->unpolish(number_);
  style()->polish(number_);
}

bool ValueRow::eventFilter(QObject* watched, QEvent* event) {
  if (watched == number_ && event->type() == QEvent::Wheel && !number_->hasFocus()) {
    event->ignore();
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

void ValueRow::send(double value) {
  const bool dragging = slider_->isSliderDown();
  const bool fresh =
      new_drag_ || (!dragging && (!since_last_.isValid() || since_last_.elapsed() > kPauseBetweenSteps_ms));
  new_drag_ = false;
  since_last_.start();
  emit changed(value, fresh);
}

}  // namespace underact::gui
