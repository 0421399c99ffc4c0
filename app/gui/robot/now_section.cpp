#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/gui/kit/number_box.h"
#include "app/gui/kit/readout.h"
#include "app/gui/kit/words.h"
#include "app/gui/robot/sections.h"
#include "core/base/units.h"

namespace underact::gui {
namespace {

constexpr double kAtLimit = 1e-6;  // rad, or m: the solver places a joint exactly on its limit
constexpr double kMillijoule = 1e3;

QString jointText(const chain::Joint& joint, double value) {
  const bool turns = joint.type == chain::JointType::Revolute;
  const QString number =
      turns ? numberText(value / kRadPerDegree, 1) + "°" : numberText(value * kMillimetrePerMetre, 1) + " mm";
  if (value <= joint.min + kAtLimit) return QObject::tr("at minimum, %1").arg(number);
  if (value >= joint.max - kAtLimit) return QObject::tr("at maximum, %1").arg(number);
  return number;
}

}  // namespace

RobotNowSection::RobotNowSection(QWidget* parent)
    : Section("now", tr("Now"), tr("What the solver found in the tick shown."), parent, "robot"),
      readout_(new Readout("panel.robot.now", this)) {
  readout_->layout()->setContentsMargins(0, 0, 0, 0);
  column().addWidget(readout_);
}

void RobotNowSection::setRobot(const manipulator::Manipulator& manipulator, bool is_sent) {
  const bool same_rows = joint_rows_.size() == manipulator.chain.joints.size() && is_sent_ == is_sent;
  manipulator_ = manipulator;
  is_sent_ = is_sent;
  if (same_rows) return;
  readout_->clear();
  joint_rows_.clear();
  found_ =
      readout_->addRow(tr("Solved by"), tr("A closed form, or the iteration with its number of steps in this tick."));
  left_ = readout_->addRow(
      tr("Remaining step"),
      tr("The largest step that any joint would still take by itself, in rad or fractions of the reach."));
  energy_ = readout_->addRow(tr("Energy"), tr("V = e·K e / 2 plus the energy of the joint springs, in this tick."));
  moment_ =
      is_sent
          ? readout_->addRow(tr("Moment, sent"), tr("m = Kθ e_o about the tip of the stylus. All joints of this arm "
                                                    "are driven, so that it is rendered beside the force."))
          : readout_->addRow(tr("Moment, not sent"), tr("m = Kθ e_o about the tip of the stylus. The arm has no "
                                                        "motors for it: it is shown, but never sent."));
  target_ = readout_->addRow(tr("Target"),
                             tr("At the end effector, or moving there at no more than 2 m/s after a minimum has "
                                "vanished or a better one was adopted. Not unique: every position is equally good."));
  better_ = readout_->addRow(
      tr("Better pose"),
      tr("A lower minimum found by a second search; it is adopted once it has saved a tenth of the energy for 50 ms."));
  for (std::size_t index = 0; index < manipulator.chain.joints.size(); ++index) {
    joint_rows_.push_back(
        readout_->addRow(tr("Joint q%1").arg(index + 1), tr("The value of the joint; 0 is the home pose.")));
  }
}

void RobotNowSection::present(const tick::ConstraintReport& held) {
  const target::Robot& robot = held.robot;
  if (robot.joints != joint_rows_.size()) return;  // an edit that the servo has not taken up yet
  if (manipulator_.law == manipulator::ForceLaw::Thesis52) {
    readout_->set(found_, tr("nearest point, thesis 5.2"));
  } else if (manipulator_.options.method == manipulator::Method::ClosedForm) {
    readout_->set(found_, tr("closed form"));
  } else {
    readout_->set(found_, tr("iteration, %1 of %2 steps").arg(robot.steps).arg(manipulator_.options.max_steps));
  }
  const bool arrived = !(robot.left > manipulator_.options.tolerance);
  readout_->set(left_, arrived ? tr("converged") : localNumber(robot.left, 'e', 1));
  readout_->set(energy_, tr("%1 mJ").arg(numberText(kMillijoule * robot.energy_J, 3)));
  readout_->set(moment_, tr("%1 N mm").arg(numberText(kMillimetrePerMetre * robot.moment_W.norm(), 1)));
  readout_->set(target_, held.status == target::Status::Degenerate ? tr("not unique")
                         : robot.slewing                           ? tr("moving to the end effector")
                                                                   : tr("at the end effector"));
  readout_->set(better_, robot.better_J > 0.0
                             ? tr("known: saves %1 mJ").arg(numberText(kMillijoule * robot.better_J, 3))
                             : tr("none known"));
  for (std::size_t index = 0; index < joint_rows_.size(); ++index) {
    readout_->set(joint_rows_[index], jointText(manipulator_.chain.joints[index], robot.theta[index]));
  }
}

}  // namespace underact::gui
