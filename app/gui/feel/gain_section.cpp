#include "app/gui/feel/gain_section.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/kit/message_label.h"
#include "app/gui/kit/tight_layout.h"
#include "app/gui/model/setting_words.h"

namespace underact::gui {
namespace {

using scene::Gains;

constexpr Vec3 Gains::*kGains[] = {&Gains::kp_N_per_mm, &Gains::kd_N_s_per_mm, &Gains::ki_N_per_mm_s};

bool areEqual(const Vec3& v) {
  return v.x() == v.y() && v.y() == v.z();
}
bool areEqual(const Gains& gains) {
  return std::all_of(std::begin(kGains), std::end(kGains), [&](auto gain) { return areEqual(gains.*gain); });
}

/// Of the one row of linked axes.
QString allAxes(const scene::Control& control) {
  return control.space == tick::Space::Joint ? QString("q1–q3") : QString("x y z");
}

/// "x", or "q1" if the control law works on the joints.
QString axisName(const scene::Control& control, int axis) {
  return control.space == tick::Space::Joint ? QString("q%1").arg(axis + 1) : QString(QChar('x' + axis));
}

}  // namespace

GainSection::GainSection(QWidget* parent) : QWidget(parent), link_(new QCheckBox(tr("L&ink x, y and z"), this)) {
  auto* column = tight<QVBoxLayout>(this, 8);
  link_->setObjectName("panel.feel.link");
  link_->setAccessibleName(tr("Link x, y and z"));
  link_->setToolTip(tr("Changing one axis changes all three."));
  column->addWidget(link_);
  connect(link_, &QCheckBox::toggled, this, &GainSection::showRows);
  for (int gain = 0; gain < kGainKinds; ++gain) {
    auto* part = new QWidget(this);
    auto* rows = tight<QVBoxLayout>(part, 4);
    QLabel* title = sectionTitle(
        QString("%1 %2").arg(QCoreApplication::translate("gain", gainKind(gain).name), gainKind(gain).key), part);
    title->setToolTip(settingTip(gainKind(gain).path));
    rows->addWidget(title);
    for (int axis = 0; axis < 3; ++axis) {
      auto* row = new GainRow(gain, axis, part);
      connect(row, &GainRow::changed, this,
              [this, gain, axis](double value, bool fresh) { emit asked(gain, axis, value, fresh); });
      rows->addWidget(row);
      rows_[static_cast<std::size_t>(gain)][static_cast<std::size_t>(axis)] = row;
    }
    parts_[static_cast<std::size_t>(gain)] = part;
    column->addWidget(part);
  }
}

void GainSection::begin(const scene::Control& control) {
  link_->setChecked(areEqual(control.gains));
}

void GainSection::present(const scene::Control& now, const scene::Control& own) {
  for (std::size_t gain = 0; gain < kGainKinds; ++gain) {
    for (int axis = 0; axis < 3; ++axis) {
      GainRow* const row = rows_[gain][static_cast<std::size_t>(axis)];
      row->present((now.gains.*kGains[gain])[axis], (own.gains.*kGains[gain])[axis]);
    }
  }
  if (!areEqual(now.gains)) link_->setChecked(false);  // so that changing one axis does not overwrite the others
  now_ = now;
  showRows();
  const bool in_joints = now.space == tick::Space::Joint;
  link_->setText(in_joints ? tr("L&ink q1, q2 and q3") : tr("L&ink x, y and z"));
  link_->setAccessibleName(link_->text().remove('&'));
  parts_[1]->setVisible(now.law != scene::LawType::P);
  parts_[2]->setVisible(now.law == scene::LawType::PID);
}

/// One row for all axes while they are linked.
void GainSection::showRows() {
  const bool linked = link_->isChecked();
  for (const auto& axes : rows_) {
    for (int axis = 0; axis < 3; ++axis) {
      GainRow* const row = axes[static_cast<std::size_t>(axis)];
      row->setAxisName(axis == 0 && linked ? allAxes(now_) : axisName(now_, axis));
      if (axis > 0) row->setVisible(!linked);
    }
  }
}

void GainSection::setWarning(int axis, const QString& reason) {
  warnings_[static_cast<std::size_t>(axis)] = reason;
  const auto first =
      std::find_if(warnings_.begin(), warnings_.end(), [](const QString& one) { return !one.isEmpty(); });
  const QString any = first == warnings_.end() ? QString() : *first;
  for (std::size_t each = 0; each < warnings_.size(); ++each)
    rows_[0][each]->setWarning(each == 0 && link_->isChecked() ? any : warnings_[each]);
}

bool GainSection::isHeld() const {
  return std::any_of(rows_.begin(), rows_.end(), [](const auto& axes) {
    return std::any_of(axes.begin(), axes.end(), [](const GainRow* row) { return row->isHeld(); });
  });
}

GainSection::Wanted GainSection::changed(const scene::Control& control, int gain, int axis, double value) const {
  const QString what = settingLabel(gainKind(gain).path);
  if (link_->isChecked()) return {Vec3::Constant(value), what};
  Vec3 axes = control.gains.*kGains[gain];
  axes[axis] = value;
  return {axes, QString("%1 %2").arg(what, axisName(control, axis))};
}

}  // namespace underact::gui
