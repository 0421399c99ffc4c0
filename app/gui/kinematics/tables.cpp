// The sections with numbers: DH table, angle conventions, Jacobian.
#include <QCheckBox>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/kinematics/sections.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/number_table.h"
#include "app/gui/kit/tight_layout.h"
#include "app/gui/kit/words.h"
#include "core/base/units.h"

namespace underact::gui {
namespace {

constexpr int kMaxJoints = arm::kMaxJoints;
const QString kWideAngle = "−000.0", kWideLength = "−000.0", kWideGain = "−0.000";

QString degrees(double angle_rad) {
  return numberText(angle_rad / kRadPerDegree, 1);
}

QString millimetreNumber(double length_m) {
  return numberText(length_m * kMillimetrePerMetre, 1);
}

template <class Matrix>
void setAll(NumberTable& table, const Matrix& J) {
  for (int row = 0; row < J.rows(); ++row) {
    for (int column = 0; column < J.cols(); ++column) table.set(row, column, numberText(J(row, column), 3));
  }
}

}  // namespace

DhSection::DhSection(QWidget* parent)
    : Section("dh", tr("DH table"),
              tr("Modified (Craig) convention: from frame i−1 to i by Rx(α) Dx(a) Rz(θ) Dz(d); θ includes the current "
                 "joint angle. Thesis table 3.1; Craig, eq. 3.6."),
              parent),
      table_(new NumberTable("panel.kinematics.dh",
                             {{tr("α [°]"), kWideAngle},
                              {tr("a [mm]"), kWideLength},
                              {tr("θ [°]"), kWideAngle},
                              {tr("d [mm]"), kWideLength}},
                             this)) {
  for (int row = 1; row <= kMaxJoints; ++row) {
    table_->addRow(
        QString("i = %1").arg(row),
        DhSection::tr("Twist α and length a of link %1, angle θ and offset d of joint %2.").arg(row - 1).arg(row));
  }
  column().addWidget(table_);
}

void DhSection::setArm(const arm::Model& model) {
  table_->showOnly(static_cast<int>(model.rows.size()), 4);
}

void DhSection::present(const KinematicsNow& now, const arm::Model& model) {
  for (std::size_t index = 0; index < model.rows.size(); ++index) {
    const chain::DhRow& row = model.rows[index];
    const bool slides = row.type == chain::JointType::Prismatic;
    const auto line = static_cast<int>(index);
    table_->set(line, 0, degrees(row.alpha_rad));
    table_->set(line, 1, millimetreNumber(row.a_m));
    table_->set(line, 2, degrees(row.theta_rad + (slides ? 0.0 : now.q_rad[index])));
    table_->set(line, 3, millimetreNumber(row.d_m + (slides ? now.q_rad[index] : 0.0)));
  }
}

AnglesSection::AnglesSection(QWidget* parent)
    : Section("angles", tr("Angle conventions"),
              tr("The same configuration in the joint angles of the DH table and in those of the device. The device "
                 "measures the shin from the base, not from the thigh. Thesis figure 3.5; the signs have not been "
                 "verified on hardware."),
              parent),
      table_(new NumberTable("panel.kinematics.angles",
                             {{tr("DH [°]"), kWideAngle},
                              {tr("device [°]"), "device [°]"},
                              {{}, AnglesSection::tr("q3 = shin − thigh") + "   ", true}},
                             this)) {
  const std::array<std::array<QString, 2>, 6> words{
      {{AnglesSection::tr("turret"), AnglesSection::tr("q1 = −turret")},
       {AnglesSection::tr("thigh"), AnglesSection::tr("q2 = thigh")},
       {AnglesSection::tr("shin"), AnglesSection::tr("q3 = shin − thigh")},
       {AnglesSection::tr("gimbal 1"), AnglesSection::tr("q4 = −g1")},
       {AnglesSection::tr("gimbal 2"), AnglesSection::tr("q5 = g2 + 90°")},
       {AnglesSection::tr("gimbal 3"), AnglesSection::tr("q6 = −g3 − 90°")}}};
  for (int row = 0; row < 6; ++row) {
    const auto& [name, relation] = words[static_cast<std::size_t>(row)];
    table_->addRow(QString("q%1 %2").arg(row + 1).arg(name),
                   AnglesSection::tr("%1 (thesis figure 3.5).").arg(relation));
    table_->set(row, 2, "  " + relation);
  }
  column().addWidget(table_);
}

void AnglesSection::present(const KinematicsNow& now) {
  for (std::size_t joint = 0; joint < 6; ++joint) {
    table_->set(static_cast<int>(joint), 0, degrees(now.q_rad[joint]));
    table_->set(static_cast<int>(joint), 1, degrees(now.device_rad[joint]));
  }
}

JacobianSection::JacobianSection(QWidget* parent)
    : Section("jacobian", tr("Jacobian"),
              tr("Velocity v of the tip (m/rad) and angular velocity ω of the stylus (rad/rad) per joint rate, in the "
                 "workspace frame: (v, ω) = J dq/dt; joint torques are τ = Jᵀ F. Derived from eq. 3.5."),
              parent),
      only_position_(new QCheckBox(tr("&Position only, J_p (3 × 3)"), this)),
      tables_(new QStackedWidget(this)) {
  std::vector<NumberTable::Column> columns;
  for (int joint = 1; joint <= kMaxJoints; ++joint) columns.push_back({QString("q%1").arg(joint), kWideGain});
  whole_ = new NumberTable("panel.kinematics.jacobian.whole", columns, this);
  position_ = new NumberTable("panel.kinematics.jacobian.position", {columns.begin(), columns.begin() + 3}, this);
  for (const char axis : {'x', 'y', 'z'}) {
    const QString tip = tr("Velocity of the tip along %1 of W per joint rate, m/rad.").arg(QChar(axis));
    whole_->addRow(QString("v%1").arg(QChar(axis)), tip);
    position_->addRow(QString("v%1").arg(QChar(axis)), tip);
  }
  for (const char axis : {'x', 'y', 'z'}) {
    whole_->addRow(QString("ω%1").arg(QChar(axis)),
                   tr("Angular velocity of the stylus about %1 of W per joint rate, rad/rad.").arg(QChar(axis)));
  }
  tables_->addWidget(whole_);
  auto* upper = new QWidget(this);  // the small table is at the top, aligned with the large one
  auto* upper_column = tight<QVBoxLayout>(upper);
  upper_column->addWidget(position_);
  upper_column->addStretch(1);
  tables_->addWidget(upper);
  nameWidget(only_position_, "panel.kinematics.jacobian.position_only", tr("Only the position part of the Jacobian"),
             tr("Joints 4 to 6 rotate the stylus about its tip without moving it: v = J_p (q1, q2, q3)'."));
  connect(only_position_, &QCheckBox::toggled, this, [this](bool on) { tables_->setCurrentIndex(on ? 1 : 0); });
  figures_ = new NumberTable("panel.kinematics.figures", {{{}, "0.000, 0.000, 0.000 m/rad", true}}, this);
  figures_->addRow(tr("det J_p"), tr("L1 L2 cos q3 (L1 cos q2 + L2 sin(q2 + q3)), per rad³; 0 at a singularity."));
  figures_->addRow(tr("Manipulability"), tr("Yoshikawa's measure of manipulability, |det J_p|."));
  figures_->addRow(tr("Condition number"),
                   tr("Ratio of the largest to the smallest singular value of J_p; 1: the same in all directions."));
  figures_->addRow(tr("Singular values"),
                   tr("Of J_p: displacement of the tip along each axis of the motion ellipsoid per radian of joint "
                      "rotation. The force along the same axis per N m of joint torque is the reciprocal."));
  column().addWidget(only_position_);
  column().addWidget(tables_);
  column().addWidget(figures_);
}

void JacobianSection::setArm(const arm::Preset& preset, const arm::Model& model) {
  const bool moves_by_three = arm::watchedJoints(preset.geometry).push_freely;
  whole_->showOnly(6, static_cast<int>(model.rows.size()));
  only_position_->setVisible(moves_by_three);
  if (!moves_by_three) only_position_->setChecked(false);
}

void JacobianSection::present(const KinematicsNow& now) {
  setAll(*whole_, now.J);
  setAll(*position_, now.J_p);
  const arm::Dexterity& dexterity = now.dexterity;
  figures_->set(0, 0, tr("%1 m³").arg(numberText(dexterity.det_m3, 6)));
  figures_->set(1, 0, tr("%1 m³").arg(numberText(dexterity.manipulability_m3, 6)));
  figures_->set(2, 0, numberText(dexterity.condition, 2));
  figures_->set(3, 0,
                tr("%1, %2, %3 m/rad")
                    .arg(numberText(dexterity.gain_m[0], 3), numberText(dexterity.gain_m[1], 3),
                         numberText(dexterity.gain_m[2], 3)));
}

}  // namespace underact::gui
