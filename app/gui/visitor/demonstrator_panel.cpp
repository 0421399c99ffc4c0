#include "app/gui/visitor/demonstrator_panel.h"

#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSpinBox>
#include <QTimer>
#include <QVBoxLayout>

#include "app/gui/kit/message_label.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/kit/stop_key.h"
#include "app/gui/model/scene_library.h"

namespace underact::gui {
namespace {

QSpinBox* number(const char* name, const QString& spoken, int min, int max, int value, QWidget* parent) {
  auto* box = new QSpinBox(parent);
  nameWidget(box, name, spoken);
  box->setRange(min, max);
  box->setValue(value);
  box->setKeyboardTracking(false);
  return box;
}

}  // namespace

DemonstratorPanel::DemonstratorPanel(const VisitorSettings& visitor_settings, QWidget* window)
    : QDialog(window),
      scenes_(new QListWidget(this)),
      dwell_(number("demonstrator.dwell", tr("Seconds per scene"), kShortestDwell_s, kLongestDwell_s,
                    visitor_settings.dwell_s, this)),
      force_(number("demonstrator.force", tr("Maximum force, percent of the arm's continuous force"), kMinForce_percent,
                    kMaxForce_percent, visitor_settings.force_percent, this)),
      told_(messageLabel("demonstrator.told", tr("Note"), "amber", this)) {
  setObjectName("demonstrator");
  setWindowTitle(tr("Demonstrator"));
  setAttribute(Qt::WA_DeleteOnClose);
  nameWidget(scenes_, "demonstrator.scenes", tr("Scenes for visitors"));
  scenes_->setProperty("role", "ticks");
  for (const QString& path : visitor_settings.scenes) addScene(path, true);
  for (const SceneEntry& entry : shippedScenes()) {
    if (!visitor_settings.scenes.contains(entry.path)) addScene(entry.path, false);
  }
  dwell_->setSuffix(tr(" s"));
  dwell_->setSingleStep(10);
  force_->setSuffix(tr(" %"));
  force_->setSingleStep(10);
  told_->hide();
  auto* form = new QFormLayout;
  form->addRow(tr("Each scene for"), dwell_);
  form->addRow(tr("Maximum force"), force_);
  auto* stop = pushButton("demonstrator.stop", tr("Stop"), tr("Stops the servo: the force goes to zero."), this);
  stop->setProperty(StopKey::kStops, true);
  auto* leave =
      pushButton("demonstrator.leave", tr("Leave visitor mode"), tr("Restores the window as it was before."), this);
  auto* close = pushButton("demonstrator.close", tr("Close"), tr("Closes this panel; visitor mode continues."), this);
  auto* buttons = new QHBoxLayout;
  for (QPushButton* button : {stop, leave, close}) buttons->addWidget(button);
  auto* column = new QVBoxLayout(this);
  column->addWidget(scenes_, 1);
  column->addLayout(form);
  column->addWidget(told_);
  column->addLayout(buttons);
  connect(stop, &QPushButton::clicked, this, &DemonstratorPanel::stopAsked);
  connect(leave, &QPushButton::clicked, this, &DemonstratorPanel::leaveAsked);
  connect(close, &QPushButton::clicked, this, &QDialog::close);
  connect(dwell_, &QSpinBox::valueChanged, this, &DemonstratorPanel::changed);
  connect(force_, &QSpinBox::valueChanged, this, &DemonstratorPanel::changed);
  connect(scenes_, &QListWidget::itemChanged, this, &DemonstratorPanel::changed);
}

void DemonstratorPanel::addScene(const QString& path, bool is_chosen) {
  auto* item = new QListWidgetItem(sceneEntry(path).title, scenes_);
  item->setData(Qt::UserRole, path);
  item->setToolTip(QFileInfo(path).fileName());
  item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
  item->setCheckState(is_chosen ? Qt::Checked : Qt::Unchecked);
}

VisitorSettings DemonstratorPanel::visitorSettings() const {
  VisitorSettings visitor_settings;
  visitor_settings.dwell_s = dwell_->value();
  visitor_settings.force_percent = force_->value();
  for (int row = 0; row < scenes_->count(); ++row) {
    const QListWidgetItem* item = scenes_->item(row);
    if (item->checkState() == Qt::Checked) visitor_settings.scenes << item->data(Qt::UserRole).toString();
  }
  return visitor_settings;
}

void DemonstratorPanel::tell(const QString& sentence) {
  showMessage(told_, sentence);
}

}  // namespace underact::gui
