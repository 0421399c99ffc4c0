#include <QComboBox>
#include <QFormLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "app/gui/kit/chooser.h"
#include "app/gui/robot/sections.h"

namespace underact::gui {

PullSection::PullSection(QWidget* parent)
    : Section(
          "pull", tr("What it pulls with"),
          tr("The robot's joints take the least energy V = e·K e / 2, and the stylus is drawn to its tip: F = K e."),
          parent, "robot") {
  const ValueKind kind{.tip = tr("How hard the tip's turn follows the stylus's: it adds Kθ e_o² / 2 to the energy, so "
                                 "that the joints, and with them the tip, go where the stylus points."),
                       .unit = "N mm/rad",
                       .steps_per_unit = 1,
                       .slider_steps = 500,
                       .decimals = 1,
                       .most = 1e6};
  ko_ = new ValueRow(kind, "panel.robot.ko", this);
  ko_->setLabel(tr("Kθ"), tr("Turning stiffness"), tr("Kθ"));
  orientation_ = chooser("panel.robot.orientation", tr("What of the stylus's turn the tip follows"),
                         tr("Nothing: e = (p, 0). The direction of z: e_o = z_V − z_T. The angle about the one joint "
                            "that turns, as in the thesis. The whole turn: e_o is its rotation vector."),
                         this);
  orientation_->addItems(
      {tr("nothing of the turn"), tr("direction of z (axis)"), tr("angle about the joint"), tr("the whole turn")});
  law_ = chooser("panel.robot.law", tr("Force law"),
                 tr("Energy: F = K e at the joints of least energy; no work is done on a loop. Thesis 5.2, for one "
                    "joint: F = kp e − (ko e_θ / L) t; it does work on a loop."),
                 this);
  law_->addItems({tr("energy, F = K e"), tr("thesis 5.2")});
  column().addWidget(ko_);
  auto* form = new QFormLayout;
  form->setHorizontalSpacing(12);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(tr("Follows"), orientation_);
  form->addRow(tr("Force law"), law_);
  column().addLayout(form);
  connect(ko_, &ValueRow::changed, this, &PullSection::koAsked);
  connect(orientation_, &QComboBox::currentIndexChanged, this,
          [this](int row) { emit orientationAsked(static_cast<manipulator::Orientation>(row)); });
  connect(law_, &QComboBox::currentIndexChanged, this,
          [this](int row) { emit lawAsked(static_cast<manipulator::ForceLaw>(row)); });
}

void PullSection::present(const scene::VirtualManipulator& robot, const std::optional<double>& own_ko_N_mm_per_rad) {
  const QSignalBlocker silent_orientation(orientation_), silent_law(law_);
  ko_->present(robot.ko_N_mm_per_rad, own_ko_N_mm_per_rad);
  ko_->setEnabled(robot.orientation != manipulator::Orientation::None);  // nothing would use it
  orientation_->setCurrentIndex(static_cast<int>(robot.orientation));
  law_->setCurrentIndex(static_cast<int>(robot.force_law));
}

}  // namespace underact::gui
