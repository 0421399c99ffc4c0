#include <QComboBox>
#include <QFormLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "app/gui/kit/chooser.h"
#include "app/gui/model/setting_words.h"
#include "app/gui/robot/sections.h"

namespace underact::gui {

PullSection::PullSection(QWidget* parent)
    : Section(
          "pull", tr("What it pulls with"),
          tr("The robot's joints take the least energy V = e·K e / 2, and the stylus is drawn to its tip: F = K e."),
          parent, "robot") {
  const ValueKind kind{.tip = settingTip("/constraints/*/ko_N_mm_per_rad"),
                       .unit = "N mm/rad",
                       .steps_per_unit = 1,
                       .slider_steps = 500,
                       .decimals = 1,
                       .most = 1e6};
  ko_ = new ValueRow(kind, "panel.robot.ko", this);
  ko_->setLabel(tr("Kθ"), tr("Turning stiffness"), tr("Kθ"));
  orientation_ = chooser("panel.robot.orientation", tr("What of the stylus's turn the tip follows"),
                         settingTip("/constraints/*/orientation"), this);
  orientation_->addItems(
      {tr("nothing of the turn"), tr("direction of z (axis)"), tr("angle about the joint"), tr("the whole turn")});
  law_ = chooser("panel.robot.law", tr("Force law"), settingTip("/constraints/*/force_law"), this);
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
