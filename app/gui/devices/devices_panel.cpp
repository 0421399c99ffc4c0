#include "app/gui/devices/devices_panel.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/arms/fix_dialog.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/panel_scroll.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/kit/remark.h"
#include "app/gui/kit/tight_layout.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/arm_choice.h"

namespace underact::gui {
namespace {

constexpr int kPollArms_ms = 2000;  // while the panel is visible
constexpr int kEntry = Qt::UserRole;

QString stateOf(const ArmEntry& entry, bool is_in_use) {
  if (is_in_use) return DevicesPanel::tr("in use");
  if (entry.name.isEmpty()) return {};
  return entry.missing.empty() ? DevicesPanel::tr("ready") : DevicesPanel::tr("not ready");
}

}  // namespace

DevicesPanel::DevicesPanel(const Parts& parts, QWidget* parent)
    : Panel(parent), parts_(parts), search_(new ArmSearch(this)) {
  addActions();
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(12, 8, 12, 8);
  column->setSpacing(8);
  in_use_ = messageLabel("panel.devices.in_use", tr("The arm in use"), "", content);
  column->addWidget(in_use_);
  column->addWidget(told_ = messageLabel("panel.devices.told", tr("Result of the choice"), "alarm", content));
  told_->hide();
  column->addWidget(buildOpening());
  column->addWidget(buildChosen());
  column->addWidget(buildOther());
  column->addWidget(buildRegistration());
  column->addStretch(1);
  fillWithScroll(this, content);
  poll_timer_.setInterval(kPollArms_ms);
  connect(&poll_timer_, &QTimer::timeout, this, [this] {
    if (isSeen()) search_->search();
  });
  poll_timer_.start();
  connect(search_, &ArmSearch::found, this, &DevicesPanel::rebuild);
  connect(&parts_.arms, &ArmChoice::began, this, &DevicesPanel::presentArm);
  connect(&parts_.arms, &ArmChoice::changed, this, &DevicesPanel::presentArm);
  connect(&parts_.arms, &ArmChoice::failed, this, [this](const QString& name, const Problems& problems) {
    tell(tr("“%1” could not be opened. %2").arg(name, sentencesOf(problems)));
    search_->search();  // it may be unplugged
  });
  presentArm();
}

void DevicesPanel::addActions() {
  parts_.actions.addCommand("devices.use", [this](const QVariantList& name) { return use(name.value(0).toString()); });
  parts_.actions.add({"devices.simulated",
                      tr("Use the si&mulated arm"),
                      {},
                      tr("Closes the arm in use. The mouse moves the simulated arm again.")},
                     [this](const QVariantList&) { return use("simulated"); });
  parts_.actions.add({"devices.look", tr("&Look for arms"), {}, tr("Looks again for arms that are plugged in.")},
                     [this](const QVariantList&) {
                       bringForward();
                       search_->search();
                       return true;
                     });
  parts_.actions.addCommand("devices.fix", [this](const QVariantList&) { return fix(); });
  parts_.actions.addCommand("devices.report", [this](const QVariantList&) { return report(); });
  parts_.actions.addCommand("devices.cancel", [this](const QVariantList&) {
    parts_.arms.cancel();
    return true;
  });
}

QWidget* DevicesPanel::buildChosen() {
  auto* box = new QWidget(this);
  auto* column = tight<QVBoxLayout>(box);
  column->addWidget(sectionTitle(tr("Plugged in"), box));
  list_ = new QListWidget(box);
  nameWidget(list_, "panel.devices.list", tr("Arms"));
  list_->setFrameShape(QFrame::NoFrame);
  list_->setWordWrap(true);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setMinimumHeight(9 * fontMetrics().lineSpacing());
  column->addWidget(list_);
  column->addWidget(about_ = messageLabel("panel.devices.about", tr("About the selected arm"), "quiet", box));
  use_ = pushButton("panel.devices.use", tr("Use this arm"),
                    tr("Opens this arm with the servo stopped. Press Start to turn the force on."), box);
  fix_ = pushButton("panel.devices.fix", tr("How to fix it…"), tr("Shows the command that fixes the problem."), box);
  report_ = pushButton("panel.devices.report", tr("Test and report…"),
                       tr("Shows the command that tests the arm and writes a report for the developers."), box);
  QPushButton* again =
      pushButton("panel.devices.look", tr("Look again"), tr("Looks again for arms that are plugged in."), box);
  connect(use_, &QPushButton::clicked, this, [this] {
    if (const ArmEntry* entry = current()) parts_.actions.perform("devices.use", entry->name);
  });
  connect(fix_, &QPushButton::clicked, this, [this] { parts_.actions.perform("devices.fix"); });
  connect(report_, &QPushButton::clicked, this, [this] { parts_.actions.perform("devices.report"); });
  connect(again, &QPushButton::clicked, this, [this] { parts_.actions.perform("devices.look"); });
  for (QPushButton* button : {use_, fix_, report_, again}) column->addWidget(button);
  connect(list_, &QListWidget::currentRowChanged, this, &DevicesPanel::describe);
  connect(list_, &QListWidget::itemActivated, this, [this] { use_->click(); });
  return box;
}

QWidget* DevicesPanel::buildOther() {
  auto* box = new QWidget(this);
  auto* column = tight<QVBoxLayout>(box);
  column->addWidget(sectionTitle(tr("Another arm"), box));
  other_ = new QLineEdit(box);
  nameWidget(other_, "panel.devices.other", tr("Name of the arm"));
  other_->setPlaceholderText(tr("KIND:ADDRESS"));
  other_->setToolTip(
      tr("The name as listed by “underact-cli devices”, with a serial number, a path or an address after the colon: "
         "wooden:/dev/hidraw3."));
  QPushButton* open = pushButton("panel.devices.open", tr("Open"), tr("Opens the arm with this name."), box);
  const auto use = [this] {
    if (!other_->text().trimmed().isEmpty()) parts_.actions.perform("devices.use", other_->text().trimmed());
  };
  connect(other_, &QLineEdit::returnPressed, this, use);
  connect(open, &QPushButton::clicked, this, use);
  auto* row = new QHBoxLayout;
  row->addWidget(other_, 1);
  row->addWidget(open);
  column->addLayout(row);
  return box;
}

QWidget* DevicesPanel::buildRegistration() {
  auto* box = new QWidget(this);
  auto* column = tight<QVBoxLayout>(box);
  column->addWidget(sectionTitle(tr("Registration"), box));
  registered_ = messageLabel("panel.devices.registration", tr("Pose of the arm on the desk"), "quiet", box);
  const QAction* const action = parts_.actions.find("registration.open");
  box->setHidden(action == nullptr);  // a window without registration
  QPushButton* open = pushButton("panel.devices.register", tr("Register the arm…"),
                                 action == nullptr ? QString() : action->toolTip(), box);
  connect(open, &QPushButton::clicked, this, [this] { parts_.actions.perform("registration.open"); });
  const auto present = [this] { registered_->setText(parts_.where_it_stands.text()); };
  connect(&parts_.where_it_stands, &Remark::changed, this, present);
  present();
  column->addWidget(registered_);
  column->addWidget(open);
  return box;
}

QWidget* DevicesPanel::buildOpening() {
  opening_ = messageLabel("panel.devices.opening", tr("Arm being opened"), "quiet", this);
  bar_ = new QProgressBar(this);
  nameWidget(bar_, "panel.devices.bar", tr("Opening"));
  bar_->setRange(0, 0);  // how long an arm takes is unknown
  bar_->setTextVisible(false);
  cancel_ = pushButton("panel.devices.cancel", tr("Cancel"),
                       tr("Stops opening this arm. The simulated arm stays in use."), this);
  connect(cancel_, &QPushButton::clicked, this, [this] { parts_.actions.perform("devices.cancel"); });
  auto* box = new QWidget(this);
  auto* column = tight<QVBoxLayout>(box);
  for (QWidget* widget : {static_cast<QWidget*>(opening_), static_cast<QWidget*>(bar_), static_cast<QWidget*>(cancel_)})
    column->addWidget(widget);
  return box;
}

const ArmEntry* DevicesPanel::current() const {
  const int row = list_->currentRow();
  const bool is_there = row >= 0 && row < static_cast<int>(search_->entries().size());
  return is_there ? &search_->entries()[static_cast<std::size_t>(row)] : nullptr;
}

bool DevicesPanel::use(const QString& name) {
  told_->hide();
  const Problems problems = parts_.arms.choose(name);
  if (!problems.empty()) tell(tr("The arm was not changed. %1").arg(sentencesOf(problems)));
  return problems.empty();
}

bool DevicesPanel::fix() {
  const ArmEntry* entry = current();
  if (entry == nullptr || entry->missing.empty()) return false;
  (new FixDialog(entry->title, entry->missing, this))->show();
  return true;
}

bool DevicesPanel::report() {
  const ArmEntry* entry = current();
  if (entry == nullptr || !entry->isUsable()) return false;
  const QString command = QString("underact-cli devices --report \"%1\" --out report.txt").arg(entry->name);
  const std::vector<device::Missing> words{
      {tr("The arm must not be in use: switch to the simulated arm first. The command reads from the arm for two "
          "seconds, without any force, and writes a report. Add what you felt, and send the file to the developers.")
           .toStdString(),
       command.toStdString()}};
  (new FixDialog(entry->title, words, this))->show();
  return true;
}

void DevicesPanel::rebuild() {
  const ArmEntry* before = current();
  const QString chosen = before != nullptr ? before->title : QString();
  list_->clear();
  for (const ArmEntry& entry : search_->entries()) {
    const QString state = stateOf(entry, entry.name == parts_.arms.name());
    auto* item = new QListWidgetItem(state.isEmpty() ? entry.title : tr("%1 – %2").arg(entry.title, state), list_);
    item->setData(kEntry, entry.title);
    if (entry.title == chosen) list_->setCurrentItem(item);
  }
  if (list_->currentRow() < 0 && list_->count() > 0) list_->setCurrentRow(0);
  describe();
}

void DevicesPanel::describe() {
  const ArmEntry* entry = current();
  QStringList sentences;
  bool has_command = false;
  if (entry != nullptr) {
    for (const device::Missing& one : entry->missing) {
      sentences << sentenceText(one.sentence);
      has_command |= !one.command.empty();
    }
  }
  showMessage(about_, sentences.join("\n"));
  use_->setEnabled(entry != nullptr && !entry->name.isEmpty() && entry->name != parts_.arms.name());
  fix_->setEnabled(has_command);
  report_->setEnabled(entry != nullptr && entry->isUsable() && entry->kind != "simulated");
}

void DevicesPanel::presentArm() {
  const servo::DeviceInfo info = parts_.servo.device();
  const QString title = sentenceText(info.title);
  in_use_->setText(
      info.untested
          ? tr("In use: %1. Untested on hardware: start with a soft scene and keep a hand on Stop.").arg(title)
          : tr("In use: %1.").arg(title));
  const QString opening = parts_.arms.opening();
  opening_->parentWidget()->setVisible(!opening.isEmpty());
  opening_->setText(tr("Opening %1…").arg(opening));
  parts_.actions.find("devices.simulated")->setEnabled(!opening.isEmpty() || parts_.arms.name() != "simulated");
  rebuild();
}

void DevicesPanel::tell(const QString& sentence) {
  told_->setText(sentence);
  told_->show();
  bringForward();
}

void DevicesPanel::showEvent(QShowEvent* event) {
  Panel::showEvent(event);
  search_->search();
}

}  // namespace underact::gui
