#include "app/gui/arm/arm_panel.h"

#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/kit/message_label.h"
#include "app/gui/kit/readout.h"
#include "app/gui/kit/tight_layout.h"
#include "app/gui/kit/words.h"
#include "core/base/units.h"

namespace underact::gui {
namespace {

constexpr int kMaxNotDrawn = 5;

/// So many joints, as far as there are so many: degrees, or mm.
QString jointsText(const arm::JointAngles& q, const std::vector<bool>& slides, std::size_t first, std::size_t count) {
  QStringList values;
  for (std::size_t joint = first; joint < std::min(first + count, slides.size()); ++joint) {
    values << (slides[joint] ? QObject::tr("%1 mm").arg(numberText(q[joint] * kMillimetrePerMetre, 1))
                             : QObject::tr("%1°").arg(numberText(q[joint] / kRadPerDegree, 1)));
  }
  return values.isEmpty() ? QString(QChar(0x2013)) : values.join(", ");
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
    case FaultKind::WindowBusy:
      return QObject::tr("window busy");
  }
  return {};
}

}  // namespace

ArmPanel::ArmPanel(QWidget* parent) : Panel(parent), readout_(new Readout("panel.arm.value", this)) {
  column_ = tight<QVBoxLayout>(this);
  column_->addWidget(readout_);
  not_drawn_ = messageLabel("panel.arm.not_drawn", tr("Meshes of the arm that are not drawn"), "warning", this);
  not_drawn_->hide();
  column_->addWidget(not_drawn_);
  column_->addStretch(1);
  tip_ = readout_->addRow(tr("Tip"), tr("Position of the stylus tip in the workspace frame W: p_WT (x, y, z)."));
  first_joints_ = readout_->addRow(
      tr("Joints 1–3"), tr("q1, q2 and q3 as in the DH table; of the Omni turret, thigh and shin, which are driven."));
  last_joints_ = readout_->addRow(
      tr("Further joints"),
      tr("q4 and the joints after it, as in the DH table; of the Omni the gimbal, which is measured, not driven."));
  level_ =
      readout_->addRow(tr("Ramp"), tr("The share of the force that soft start and soft release pass on to the arm."));
  fault_ =
      readout_->addRow(tr("Fault"), tr("Why the servo stopped by itself. The line above the view says what to do."));
}

void ArmPanel::addAbove(QWidget* widget) {
  column_->insertWidget(0, widget);
}

void ArmPanel::setArm(const arm::Model& model) {
  slides_.clear();
  for (const chain::DhRow& row : model.rows) slides_.push_back(row.type == chain::JointType::Prismatic);
}

bool ArmPanel::showNotDrawn(const Problems& problems) {
  QStringList lines;
  for (const Problem& problem : problems) {
    if (lines.size() == kMaxNotDrawn) {
      lines << tr("And %n more.", nullptr, static_cast<int>(problems.size()) - kMaxNotDrawn);
      break;
    }
    const QString sentence = sentenceText(problem.sentence);
    lines << (problem.place.line > 0 ? tr("Line %1: %2").arg(QString::number(problem.place.line), sentence) : sentence);
  }
  const QString text = lines.join('\n');
  const bool is_new = !text.isEmpty() && text != not_drawn_->text();
  showMessage(not_drawn_, text);
  return is_new;
}

void ArmPanel::present(const servo::Snapshot& snapshot) {
  const tick::TickReport& report = snapshot.report;
  readout_->set(tip_, placeText(report.p_WT * kMillimetrePerMetre));
  readout_->set(first_joints_, jointsText(report.sample.q_rad, slides_, 0, 3));
  readout_->set(last_joints_, jointsText(report.sample.q_rad, slides_, 3, arm::kMaxJoints));
  readout_->set(level_, tr("%1 %").arg(numberText(report.level * 100.0, 0)));
  readout_->set(fault_, faultText(report.fault.kind));
}

}  // namespace underact::gui
