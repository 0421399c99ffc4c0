#include "app/gui/second_arm/second_arm_panel.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <utility>

#include "app/gui/arms/second_arm.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/chooser.h"
#include "app/gui/kit/file_question.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/panel_scroll.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/kit/readout.h"
#include "app/gui/kit/tight_layout.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/scene_library.h"
#include "core/base/units.h"

namespace underact::gui {
namespace {

QString modeText(servo::Mode mode) {
  switch (mode) {
    case servo::Mode::Idle:
      return SecondArmPanel::tr("stopped");
    case servo::Mode::Running:
      return SecondArmPanel::tr("running");
    case servo::Mode::Stopping:
      return SecondArmPanel::tr("stopping");
    case servo::Mode::Faulted:
      return SecondArmPanel::tr("fault");
  }
  return {};
}

}  // namespace

SecondArmPanel::SecondArmPanel(const Parts& parts, QWidget* parent)
    : Panel(parent), parts_(parts), second_(parts.second), search_(new ArmSearch(this)) {
  addActions();
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(12, 8, 12, 8);
  column->setSpacing(8);
  on_ = new QCheckBox(tr("A second arm"), content);
  nameWidget(on_, "panel.second.on", tr("A second arm"), parts_.actions.find("second.on")->toolTip());
  connect(on_, &QCheckBox::toggled, this, [this](bool on) { parts_.actions.perform("second.on", on); });
  column->addWidget(on_);
  column->addWidget(told_ = messageLabel("panel.second.told", tr("Message from the second arm"), "alarm", content));
  told_->hide();
  column->addWidget(choices_ = buildChoices());
  readout_ = new Readout("panel.second.value", content);
  device_ = readout_->addRow(tr("Arm"), tr("The arm in use."));
  mode_ = readout_->addRow(tr("Servo"), tr("State of its servo. Start and Stop apply to both arms."));
  force_ = readout_->addRow(tr("Force"), tr("The force sent to the second arm."));
  tip_ = readout_->addRow(tr("Tip"), tr("Position of its tip in its own frame W."));
  column->addWidget(readout_);
  column->addStretch(1);
  fillWithScroll(this, content);
  connect(search_, &ArmSearch::found, this, &SecondArmPanel::fillArms);
  connect(&second_, &SecondArm::changed, this, &SecondArmPanel::presentChoices);
  connect(&second_, &SecondArm::told, this, &SecondArmPanel::tell);
  presentChoices();
}

void SecondArmPanel::addActions() {
  parts_.actions.add(
      {"second.on",
       tr("A s&econd arm"),
       {},
       tr("Adds an arm beside the first, with its own servo and scene. Start and Stop apply to both arms."),
       {},
       {},
       true},
      [this](const QVariantList& on) {
        told_->hide();
        second_.setOn(on.value(0).toBool());
        if (second_.isOn()) bringForward();
        return true;
      });
  parts_.actions.addCommand("second.use", [this](const QVariantList& name) {
    if (!second_.isOn()) return false;
    told_->hide();
    const Problems problems = second_.choose(name.value(0).toString());
    if (!problems.empty()) tell(tr("The second arm is unchanged. %1").arg(sentencesOf(problems)));
    presentChoices();
    return problems.empty();
  });
  parts_.actions.addCommand("second.scene", [this](const QVariantList& path) {
    told_->hide();
    second_.openScene(path.value(0).toString());
    return true;
  });
  parts_.actions.addCommand("second.side", [this](const QVariantList& left) {
    second_.setSide(left.value(0).toBool() ? SecondArm::Side::Left : SecondArm::Side::Right);
    presentChoices();
    return true;
  });
  parts_.actions.addCommand("second.mirror", [this](const QVariantList& on) {
    second_.setMirrors(on.value(0).toBool());
    presentChoices();
    return true;
  });
}

QWidget* SecondArmPanel::buildChoices() {
  auto* box = new QWidget(this);
  auto* form = tight<QFormLayout>(box);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  arm_ = chooser("panel.second.arm", tr("Second arm"), tr("The arm to use; the Devices panel lists more."), box);
  scene_ =
      chooser("panel.second.scene", tr("Scene of the second arm"), tr("What the second arm is constrained to."), box);
  side_ = chooser("panel.second.side", tr("Side of the second arm"),
                  tr("The side of the first arm on which it stands."), box);
  side_->addItems({tr("left"), tr("right")});
  file_ = pushButton("panel.second.file", tr("Another scene file…"), tr("Opens a scene file for the second arm."), box);
  mirrors_ = new QCheckBox(tr("Mirrors my hand"), box);
  nameWidget(mirrors_, "panel.second.mirror", tr("Mirrors my hand"),
             tr("Moves a simulated second arm as the mirror image of the first hand."));
  opening_ = messageLabel("panel.second.opening", tr("Progress"), "quiet", box);
  form->addRow(tr("Arm"), arm_);
  form->addRow(tr("Scene"), scene_);
  form->addRow(file_);
  form->addRow(tr("Side"), side_);
  form->addRow(mirrors_);
  form->addRow(opening_);
  connect(arm_, &QComboBox::activated, this,
          [this] { parts_.actions.perform("second.use", arm_->currentData().toString()); });
  connect(scene_, &QComboBox::activated, this,
          [this] { parts_.actions.perform("second.scene", scene_->currentData().toString()); });
  connect(side_, &QComboBox::activated, this, [this](int row) { parts_.actions.perform("second.side", row == 0); });
  connect(mirrors_, &QCheckBox::toggled, this, [this](bool on) { parts_.actions.perform("second.mirror", on); });
  connect(file_, &QPushButton::clicked, this, [this] {
    askForFile(window(), "dialog.second_scene", tr("A scene for the second arm"), sceneFolder(),
               tr("Scenes (*.json);;All files (*)"),
               [this](const QString& path) { parts_.actions.perform("second.scene", path); });
  });
  return box;
}

void SecondArmPanel::fillArms() {
  const QSignalBlocker quiet(arm_);
  arm_->clear();
  for (const ArmEntry& entry : search_->entries()) {
    if (!entry.name.isEmpty()) arm_->addItem(entry.title, entry.name);
  }
  const QString name = second_.isOn() ? second_.arms().wanted() : QString("simulated");
  if (arm_->findData(name) < 0) arm_->addItem(name, name);  // named by its address, or no longer present
  arm_->setCurrentIndex(arm_->findData(name));
}

void SecondArmPanel::presentChoices() {
  const QSignalBlocker quiet_on(on_), quiet_scene(scene_), quiet_side(side_), quiet_mirrors(mirrors_);
  const bool is_on = second_.isOn();
  QAction* const action = parts_.actions.find("second.on");
  if (action->isChecked() != is_on) action->setChecked(is_on);
  on_->setChecked(is_on);
  choices_->setEnabled(is_on);
  readout_->setVisible(is_on);
  const QString path = second_.scenePath();
  if (!path.isEmpty() && scene_->findData(path) < 0) scene_->addItem(sceneEntry(path).title, path);
  if (!path.isEmpty()) scene_->setCurrentIndex(scene_->findData(path));
  side_->setCurrentIndex(second_.side() == SecondArm::Side::Left ? 0 : 1);
  side_->setEnabled(!second_.placed());
  side_->setToolTip(second_.placed() ? tr("Set by the registrations of both arms.")
                                     : tr("The side of the first arm on which it stands."));
  mirrors_->setChecked(second_.mirrors());
  mirrors_->setEnabled(is_on && second_.arms().simulated() != nullptr);
  const QString opening = is_on ? second_.arms().opening() : QString();
  opening_->setText(!opening.isEmpty()    ? tr("Opening %1…").arg(opening)
                    : second_.isLoading() ? tr("Loading the scene…")
                                          : QString());
  fillArms();
}

void SecondArmPanel::tell(const QString& sentence) {
  told_->setText(sentence);
  told_->show();
  bringForward();
}

QString SecondArmPanel::busyReason() const {
  return second_.isOn() ? tr("The second arm is on. Switch it off first.") : QString();
}

void SecondArmPanel::present(const servo::Snapshot&) {
  if (!second_.isOn() || !isSeen()) return;
  const servo::Snapshot snapshot = second_.servo().snapshot();
  const servo::DeviceInfo info = second_.servo().device();
  readout_->set(device_, sentenceText(info.title) + (info.untested ? tr(" (untested)") : QString()));
  readout_->set(mode_, modeText(snapshot.mode));
  readout_->set(force_, tr("%1 N").arg(numberText(snapshot.report.force.f_T_W().norm(), 2)));
  readout_->set(tip_, placeText(snapshot.report.p_WT * kMillimetrePerMetre));
}

void SecondArmPanel::showEvent(QShowEvent* event) {
  Panel::showEvent(event);
  if (!std::exchange(has_scenes_, true)) {  // reading them all takes a while: once they can be chosen from
    const QSignalBlocker quiet(scene_);
    scene_->clear();
    for (const SceneEntry& entry : shippedScenes()) scene_->addItem(entry.title, entry.path);
    presentChoices();
  }
  search_->search();
}

}  // namespace underact::gui
