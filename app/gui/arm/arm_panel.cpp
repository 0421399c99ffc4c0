#include "app/gui/arm/arm_panel.h"

#include <QVBoxLayout>

#include "app/gui/kit/readout.h"
#include "app/gui/kit/tight_layout.h"
#include "app/gui/kit/words.h"
#include "core/base/units.h"

namespace underact::gui {
namespace {

QString jointsText(const arm::JointAngles& q_rad, std::size_t first) {
  QStringList angles;
  for (std::size_t joint = first; joint < first + 3; ++joint) angles << numberText(q_rad[joint] / kRadPerDegree, 1);
  return QObject::tr("%1°").arg(angles.join(QString("°, ")));
}

QString faultText(FaultKind kind) {
  switch (kind) {
    case FaultKind::None:
      return QObject::tr("none");
    case FaultKind::NoSample:
      return QObject::tr("no answer");
    case FaultKind::StaleSample:
      return QObject::tr("old sample");
    case FaultKind::NotFinite:
      return QObject::tr("not a number");
    case FaultKind::TooFast:
      return QObject::tr("jump");
    case FaultKind::TooLate:
      return QObject::tr("too late");
    case FaultKind::StoodStill:
      return QObject::tr("stood still");
    case FaultKind::OddClock:
      return QObject::tr("clock error");
    case FaultKind::Asleep:
      return QObject::tr("asleep");
  }
  return {};
}

}  // namespace

ArmPanel::ArmPanel(QWidget* parent) : Panel(parent), readout_(new Readout("panel.arm.value", this)) {
  auto* column = tight<QVBoxLayout>(this);
  column->addWidget(readout_);
  column->addStretch(1);
  tip_ = readout_->addRow(tr("Tip"), tr("Position of the stylus tip in the workspace frame W: p_WT (x, y, z)."));
  first_joints_ =
      readout_->addRow(tr("Joints 1–3"), tr("Turret, thigh and shin: q1, q2, q3 as in the DH table; driven."));
  last_joints_ =
      readout_->addRow(tr("Joints 4–6"), tr("The gimbal: q4, q5, q6 as in the DH table; measured, not driven."));
  level_ =
      readout_->addRow(tr("Ramp"), tr("The share of the force that soft start and soft release pass on to the arm."));
  fault_ =
      readout_->addRow(tr("Fault"), tr("Why the servo stopped by itself. The line above the view says what to do."));
}

void ArmPanel::present(const servo::Snapshot& snapshot) {
  const tick::TickReport& report = snapshot.report;
  readout_->set(tip_, placeText(report.p_WT * kMillimetrePerMetre));
  readout_->set(first_joints_, jointsText(report.sample.q_rad, 0));
  readout_->set(last_joints_, jointsText(report.sample.q_rad, 3));
  readout_->set(level_, tr("%1 %").arg(numberText(report.level * 100.0, 0)));
  readout_->set(fault_, faultText(report.fault.kind));
}

}  // namespace underact::gui
