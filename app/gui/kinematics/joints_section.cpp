#include <QCoreApplication>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/kinematics/distance_bar.h"
#include "app/gui/kinematics/joint_row.h"
#include "app/gui/kinematics/sections.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/number_table.h"
#include "core/base/units.h"

namespace underact::gui {

JointsSection::JointsSection(QWidget* parent)
    : Section("joints", tr("Joints"), tr("The joint angles q of the DH table, as measured by the encoders."), parent),
      note_(quietLabel("panel.kinematics.joints.note", {}, this)) {
  for (int joint = 0; joint < static_cast<int>(rows_.size()); ++joint) {
    const auto index = static_cast<std::size_t>(joint);
    rows_[index] = new JointRow(joint, {}, {}, this);
    connect(rows_[index], &JointRow::asked, this, [this, joint](double angle_deg) { emit asked(joint, angle_deg); });
    connect(rows_[index], &JointRow::stepped, this, [this, joint](double by_deg) { emit stepped(joint, by_deg); });
    column().addWidget(rows_[index]);
  }
  note_->setMinimumHeight(2 * fontMetrics().lineSpacing());  // room for each sentence: nothing moves when it changes
  note_->setAlignment(Qt::AlignTop);
  column().addWidget(note_);
}

void JointsSection::setArm(const arm::Preset& preset, const arm::Model& model) {
  const std::array<QString, 6> names{tr("turret"),   tr("thigh"),    tr("shin"),
                                     tr("gimbal 1"), tr("gimbal 2"), tr("gimbal 3")};
  for (std::size_t joint = 0; joint < rows_.size(); ++joint) {
    rows_[joint]->setVisible(joint < model.joints.size());
    if (joint >= model.joints.size()) continue;
    const bool slides = model.rows[joint].type == chain::JointType::Prismatic;
    const bool driven = model.joints[joint].driven;
    const int number = static_cast<int>(joint) + 1;
    if (arm::isDevice(preset)) {
      rows_[joint]->setJoint(names[joint],
                             (driven ? tr("Angle q%1 of thesis table 3.1: measured and driven.")
                                     : tr("Angle q%1 of thesis table 3.1: measured, not driven."))
                                 .arg(number),
                             false);
    } else {
      const QString name = QString::fromStdString(model.joints[joint].name);
      rows_[joint]->setJoint(name.isEmpty() ? (slides ? tr("slide") : tr("turn")) : name,
                             (driven ? tr("Joint %1 of the arm's file: measured and driven.")
                                     : tr("Joint %1 of the arm's file: measured, not driven."))
                                 .arg(number),
                             slides);
    }
    per_unit_[joint] = slides ? kMetrePerMillimetre : kRadPerDegree;
    const double max = slides ? 10.0 : 2.0 * kPi;  // where the file states no limit
    rows_[joint]->setLimits(std::max(-max, preset.limits.min_rad[joint]) / per_unit_[joint],
                            std::min(max, preset.limits.max_rad[joint]) / per_unit_[joint]);
  }
}

void JointsSection::setMovable(const QString& refusal) {
  refusal_ = refusal;
  for (JointRow* row : rows_) row->setEnabled(refusal.isEmpty());
}

void JointsSection::setRemark(const QString& remark) {
  updateText(note_, !refusal_.isEmpty() ? refusal_
                    : !remark.isEmpty() ? remark
                                        : tr("Each slider moves the simulated hand, which moves the arm."));
}

void JointsSection::present(const KinematicsNow& now) {
  for (std::size_t joint = 0; joint < rows_.size(); ++joint) {
    if (per_unit_[joint] > 0.0) rows_[joint]->present(now.q_rad[joint] / per_unit_[joint]);
  }
}

SingularitiesSection::SingularitiesSection(QWidget* parent)
    : Section("singularities", tr("Distance to singularities"),
              tr("At a singularity the arm loses a degree of freedom. Below its mark, a bar turns amber and says "
                 "\"near\"."),
              parent) {
  const auto add = [this](const char* key, const QString& name, const QString& tip, const DistanceBar::Scale& scale) {
    auto* bar = new DistanceBar(QString("panel.kinematics.singularity.%1").arg(key), name, tip, scale, this);
    column().addWidget(bar);
    return bar;
  };
  shoulder_ = add("shoulder", tr("Shoulder"),
                  tr("Distance of the wrist centre from axis 1: |L1 cos q2 + L2 sin(q2 + q3)|. At 0, joint 1 no longer "
                     "moves the tip. Near: below %1 mm.")
                      .arg(kNearShoulder_m * kMillimetrePerMetre),
                  {kNearShoulder_m * kMillimetrePerMetre, 200.0, 1, tr(" mm")});
  elbow_ = add("elbow", tr("Elbow"),
               tr("Distance of q3 from ±90°, where the arm is stretched or folded: det J_p = L1 L2 cos q3 (L1 cos q2 + "
                  "L2 sin(q2 + q3)). Near: below %1°.")
                   .arg(kNearElbow_deg),
               {kNearElbow_deg, 90.0, 1, "°"});
  wrist_ = add("wrist", tr("Wrist"),
               tr("Distance of q5 from 0° or 180°, where axes 4 and 6 coincide and only q4 + q6 (or q6 − q4) is "
                  "defined. Near: below %1°.")
                   .arg(kNearWrist_deg),
               {kNearWrist_deg, 90.0, 1, "°"});
}

void SingularitiesSection::setReach(double reach_m) {
  shoulder_->setFarthest(reach_m * kMillimetrePerMetre);
}

void SingularitiesSection::setTheme(const Theme& theme) {
  for (DistanceBar* bar : {shoulder_, elbow_, wrist_}) bar->setTheme(theme);
}

void SingularitiesSection::present(const KinematicsNow& now) {
  shoulder_->present(now.distances.shoulder_m * kMillimetrePerMetre);
  elbow_->present(now.distances.elbow_rad / kRadPerDegree);
  wrist_->present(now.distances.wrist_rad / kRadPerDegree);
}

}  // namespace underact::gui
