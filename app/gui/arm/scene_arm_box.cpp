#include "app/gui/arm/scene_arm_box.h"

#include <QComboBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <utility>

#include "app/gui/kit/file_question.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/problems_dialog.h"
#include "app/gui/kit/tight_layout.h"
#include "app/gui/model/document.h"
#include "core/scene/load_meshes.h"
#include "core/scene/scene_arm.h"

namespace underact::gui {
namespace {

QString arm(const scene::Description& scene) {
  return QString::fromStdString(scene.arm);
}

}  // namespace

Result<scene::Description> withArm(scene::Description scene, const QString& name_or_path) {
  scene.arm_text.clear();
  scene.arm_file.reset();
  scene.arm = name_or_path.toStdString();
  const Problems problems = scene::readSceneArm(scene);
  if (!problems.empty()) return problems;
  return scene;
}

SceneArmBox::SceneArmBox(Document& document, QWidget* window, QWidget* parent)
    : QWidget(parent), document_(document), window_(window), arms_(new QComboBox(this)) {
  auto* const label = new QLabel(tr("Scene &for"), this);
  label->setBuddy(arms_);
  auto* const file = new QPushButton(tr("&File…"), this);
  for (const arm::Preset& preset : arm::sceneArms()) {  // by the names that scene files have
    const QString name = QString::fromStdString(preset.name);
    arms_->addItem(name, name);
    arms_->setItemData(arms_->count() - 1, QString::fromStdString(preset.title), Qt::ToolTipRole);
  }
  nameWidget(arms_, "panel.arm.choose", tr("The arm that the scene is for"),
             tr("Haptic arms, and arms that are only simulated. The scene keeps the choice when it is saved."));
  arms_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  arms_->setMinimumContentsLength(12);
  nameWidget(file, "panel.arm.file", tr("An arm from a file"),
             tr("An arm file of your own: a DH table, axes (both JSON) or URDF."));
  auto* const row = tight<QHBoxLayout>(this, 4);
  row->setContentsMargins(12, 8, 12, 0);  // as the values below
  row->addWidget(label);
  row->addWidget(arms_, 1);
  row->addWidget(file);
  connect(arms_, &QComboBox::activated, this, [this](int index) { take(arms_->itemData(index).toString()); });
  connect(file, &QPushButton::clicked, this, &SceneArmBox::chooseFile);
  connect(&document_, &Document::opened, this, &SceneArmBox::present);
  connect(&document_, &Document::edited, this, &SceneArmBox::present);
  present();
}

void SceneArmBox::present() {
  const scene::Description& scene = document_.scene();
  const QSignalBlocker silent(arms_);
  const int ships = static_cast<int>(arm::sceneArms().size());
  while (arms_->count() > ships) arms_->removeItem(ships);
  if (scene::isArmFile(scene.arm))
    arms_->addItem(tr("File %1").arg(QFileInfo(arm(scene)).fileName()),
                   QString::fromStdString(scene::pathOf(scene.arm, scene)));
  const int index = scene::isArmFile(scene.arm) ? ships : arms_->findData(arm(scene));
  arms_->setCurrentIndex(index);
  setEnabled(document_.isOpen() && !document_.showsRecorded());
}

bool SceneArmBox::take(const QString& name_or_path) {
  const bool is_file = scene::isArmFile(name_or_path.toStdString());
  const QString chosen = is_file ? QFileInfo(name_or_path).absoluteFilePath() : name_or_path;
  const auto refuse = [&](const Problems& problems) {
    showProblemsBox("dialog.scene_arm_problems", tr("Arm not taken"),
                    tr("The scene keeps its arm. %1:").arg(QFileInfo(name_or_path).fileName()), problems, window_);
    present();
    return false;
  };
  if (!document_.isOpen())
    return refuse({{phrase(QT_TRANSLATE_NOOP("problem", "Open a scene first; then it can be given another arm."))}});
  Result<scene::Description> after = withArm(document_.scene(), chosen);
  if (!after) return refuse(after.problems());
  const Problems problems =
      document_.edit(after.value(), tr("arm %1").arg(QFileInfo(name_or_path).baseName()), document_.newGesture());
  return problems.empty() || refuse(problems);
}

void SceneArmBox::chooseFile() {
  askForFile(window_, "dialog.scene_arm", tr("Choose an arm file"), QFileInfo(document_.path()).absolutePath(),
             tr("Arm files (*.json *.urdf *.xml);;All files (*)"), [this](const QString& path) { take(path); });
}

}  // namespace underact::gui
