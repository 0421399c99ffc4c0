#include "app/gui/kinematics/joint_row.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QSignalBlocker>
#include <QStyle>
#include <QStyleOptionSlider>
#include <QWheelEvent>
#include <cmath>

#include "app/gui/kit/message_label.h"
#include "app/gui/kit/tight_layout.h"
#include "app/gui/kit/words.h"

namespace underact::gui {
namespace {

constexpr int kStepsPerDegree = 10;
constexpr double kBeyond_deg = 10.0;   // of the slider, on both sides of the limits
constexpr double kAtLimit_deg = 0.35;  // tolerance for the encoders and friction

}  // namespace

void LimitSlider::setLimits(double min_deg, double max_deg) {
  min_deg_ = min_deg;
  max_deg_ = max_deg;
  const QSignalBlocker silent(this);
  setRange(static_cast<int>(std::floor(min_deg - kBeyond_deg)) * kStepsPerDegree,
           static_cast<int>(std::ceil(max_deg + kBeyond_deg)) * kStepsPerDegree);
  update();
}

void LimitSlider::paintEvent(QPaintEvent* event) {
  QSlider::paintEvent(event);
  QStyleOptionSlider option;
  initStyleOption(&option);
  const QRect groove = style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderGroove, this);
  const int handle = style()->pixelMetric(QStyle::PM_SliderLength, &option, this);
  QPainter painter(this);
  painter.setPen(Qt::NoPen);
  painter.setBrush(palette().color(QPalette::WindowText));
  for (const double limit_deg : {min_deg_, max_deg_}) {
    const double share = (kStepsPerDegree * limit_deg - minimum()) / std::max(1, maximum() - minimum());
    const double x = groove.left() + 0.5 * handle + share * (groove.width() - handle);
    painter.drawRect(QRectF(std::round(x) - 1.0, height() - 5.0, 2.0, 5.0));
  }
}

QString AngleBox::textFromValue(double value) const {
  return numberText(value, decimals());
}

JointRow::JointRow(int joint, const QString& name, const QString& tip, QWidget* parent)
    : QWidget(parent),
      joint_(joint),
      name_(new QLabel(this)),
      slider_(new LimitSlider(this)),
      number_(new AngleBox(this)),
      state_(new QLabel(this)) {
  const QString object_name = QString("panel.kinematics.joint.%1").arg(joint + 1);
  setObjectName(object_name);
  name_->setBuddy(number_);
  name_->setFixedWidth(fontMetrics().horizontalAdvance("q6 gimbal 3") + 4);
  slider_->setFocusPolicy(Qt::StrongFocus);
  slider_->setSingleStep(kStepsPerDegree);
  slider_->setPageStep(5 * kStepsPerDegree);
  slider_->setMinimumSize(64, 24);
  number_->setDecimals(1);
  number_->setSingleStep(1.0);
  number_->setKeyboardTracking(false);
  number_->setFocusPolicy(Qt::StrongFocus);
  number_->setAlignment(Qt::AlignRight);
  number_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  number_->setFixedWidth(fontMetrics().horizontalAdvance("−000.0°") + 20);
  nameWidget(state_, object_name + ".state", tr("Joint %1, limits").arg(joint + 1));
  state_->setFixedSize(fontMetrics().horizontalAdvance(tr("outside")) + 12, fontMetrics().lineSpacing());
  auto* row = tight<QHBoxLayout>(this, 4);
  row->addWidget(name_);
  row->addWidget(slider_, 1);
  row->addWidget(number_);
  row->addWidget(state_);

  setJoint(name, tip, false);
  connect(slider_, &QSlider::valueChanged, this, [this](int value) {
    const double change_deg = static_cast<double>(value - shown_) / kStepsPerDegree;
    shown_ = value;
    if (slider_->isSliderDown())
      emit asked(static_cast<double>(value) / kStepsPerDegree);
    else
      emit stepped(change_deg);
  });
  connect(number_, &QDoubleSpinBox::valueChanged, this, &JointRow::asked);
  connect(number_, &QDoubleSpinBox::editingFinished, this,
          [this] { number_->findChild<QLineEdit*>()->setModified(false); });
  connect(number_, &AngleBox::stepped, this, &JointRow::stepped);
}

void JointRow::setJoint(const QString& name, const QString& tip, bool slides) {
  slides_ = slides;
  setToolTip(tip);
  const QString text = QString("q%1 %2").arg(joint_ + 1).arg(name);
  name_->setText(fontMetrics().elidedText(text, Qt::ElideRight, name_->width()));
  name_->setToolTip(text + "\n" + tip);
  const QString object_name = objectName();
  nameWidget(slider_, object_name + ".slider", tr("Joint %1, %2, slider").arg(joint_ + 1).arg(name));
  nameWidget(number_, object_name + ".number",
             (slides ? tr("Joint %1, %2, millimetres") : tr("Joint %1, %2, degrees")).arg(joint_ + 1).arg(name));
  const QSignalBlocker silent(number_);
  number_->setRange(slides ? -1e4 : -360.0, slides ? 1e4 : 360.0);
  number_->setSuffix(slides ? tr(" mm") : QString("°"));
}

void JointRow::setLimits(double min_deg, double max_deg) {
  min_deg_ = min_deg;
  max_deg_ = max_deg;
  slider_->setLimits(min_deg, max_deg);
  const QString limits = (slides_ ? tr("Limits %1 to %2 mm") : tr("Limits %1° to %2°"))
                             .arg(numberText(min_deg, 1))
                             .arg(numberText(max_deg, 1));
  slider_->setToolTip(toolTip() + "\n" + limits + tr(", marked below the slider."));
  number_->setToolTip(slider_->toolTip());
}

void JointRow::present(double angle_deg) {
  const QSignalBlocker silent_slider(slider_), silent_number(number_);  // showing a value does not command it
  if (!slider_->isSliderDown()) {
    slider_->setValue(static_cast<int>(std::lround(angle_deg * kStepsPerDegree)));
    shown_ = slider_->value();
  }
  if (!number_->findChild<QLineEdit*>()->isModified()) number_->setValue(angle_deg);
  showState(angle_deg);
}

void JointRow::showState(double angle_deg) {
  const double inside_deg = std::min(angle_deg - min_deg_, max_deg_ - angle_deg);
  const bool outside = inside_deg < -kAtLimit_deg, at_limit = !outside && inside_deg < kAtLimit_deg;
  const QString word = outside ? tr("outside") : at_limit ? tr("at limit") : QString();
  if (state_->text() == word) return;
  state_->setText(word);
  state_->setProperty("role", outside ? "alarm-text" : "amber-text");
  state_->style()->unpolish(state_);
  state_->style()->polish(state_);
}

}  // namespace underact::gui
