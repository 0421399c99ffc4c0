#include "app/gui/input_devices/input_devices_panel.h"

#include <QLabel>
#include <QListWidget>
#include <QMainWindow>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "app/gui/arms/fix_dialog.h"
#include "app/gui/input_devices/input_devices.h"
#include "app/gui/input_devices/input_words.h"
#include "app/gui/input_devices/map_editor.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/panel_scroll.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/kit/words.h"

namespace underact::gui {
namespace {

constexpr int kId = Qt::UserRole;

QString inputDeviceState(const InputDeviceEntry& entry) {
  if (!entry.seen.missing.empty()) return InputDevicesPanel::tr("not ready");
  if (!entry.used) return InputDevicesPanel::tr("switched off");
  return entry.moves ? InputDevicesPanel::tr("moves the stylus") : InputDevicesPanel::tr("ready");
}

QString titleOf(const InputDeviceEntry& entry) {
  return QString("%1 – %2").arg(sentenceText(entry.seen.name), inputDeviceState(entry));
}

}  // namespace

InputDevicesPanel::InputDevicesPanel(const Parts& parts, QWidget* parent)
    : Panel(parent),
      parts_(parts),
      hands_(*new InputDevices(parts.servo, parts.hand, parts.hands, parts.actions, parts.window)) {
  addActions();
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(12, 8, 12, 8);
  column->setSpacing(8);
  column->addWidget(state_ = messageLabel("panel.hands.state", tr("State of the input devices"), "", content));
  column->addWidget(trouble_ = messageLabel("panel.hands.trouble", tr("What is wrong"), "amber", content));
  list_ = new QListWidget(content);
  list_->setObjectName("panel.hands.list");
  list_->setAccessibleName(tr("Input devices"));
  list_->setToolTip(tr("The input devices that are plugged in. An unticked device is ignored."));
  list_->setProperty("role", "ticks");  // their boxes are painted in its own ground, which is black where it is none
  list_->setFrameShape(QFrame::NoFrame);
  list_->setWordWrap(true);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setFixedHeight(6 * fontMetrics().lineSpacing());
  column->addWidget(list_);
  column->addWidget(about_ = messageLabel("panel.hands.about", tr("About the selected device"), "quiet", content));
  fix_ = pushButton("panel.hands.fix", tr("How to fix it…"), tr("Shows the command that fixes the problem."), content);
  column->addWidget(fix_, 0, Qt::AlignLeft);
  column->addWidget(editor_ = new MapEditor(hands_, parts_.actions, content));
  column->addStretch(1);
  fillWithScroll(this, content);
  connect(&hands_, &InputDevices::changed, this, &InputDevicesPanel::rebuild);
  connect(list_, &QListWidget::currentRowChanged, this, [this] {
    hands_.endLearning();
    describe();
  });
  connect(list_, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
    parts_.actions.perform("hands.use", item->data(kId), item->checkState() == Qt::Checked);
  });
  connect(fix_, &QPushButton::clicked, this, [this] { parts_.actions.perform("hands.fix"); });
  rebuild();
}

void InputDevicesPanel::addActions() {
  Actions& actions = parts_.actions;
  actions.addCommand("hands.use", [this](const QVariantList& args) {
    if (hands_.find(args.value(0).toString()) == nullptr) return false;
    hands_.use(args.value(0).toString(), args.value(1).toBool());
    return true;
  });
  actions.addCommand("hands.set", [this](const QVariantList& args) {
    const InputDeviceEntry* const entry = hands_.find(current());
    if (entry == nullptr) return false;
    const auto map = withField(entry->map, args.value(0).toString(), args.value(1));
    const bool fresh = args.size() < 3 || args[2].toBool();
    const bool done = map && hands_.change(current(), *map, args[0].toString(), fresh);
    if (!done) editor_->rebuild();  // undoes what was typed
    return done;
  });
  actions.addCommand("hands.learn",
                     [this](const QVariantList& args) { return hands_.learn(current(), args.value(0).toString()); });
  actions.addCommand("hands.undo", [this](const QVariantList&) {
    const bool can = hands_.undoStack().canUndo();
    hands_.undoStack().undo();
    return can;
  });
  actions.addCommand("hands.redo", [this](const QVariantList&) {
    const bool can = hands_.undoStack().canRedo();
    hands_.undoStack().redo();
    return can;
  });
  actions.addCommand("hands.reset", [this](const QVariantList&) { return hands_.reset(current()); });
  actions.addCommand("hands.fix", [this](const QVariantList&) { return fix(); });
}

QString InputDevicesPanel::current() const {
  const QListWidgetItem* const item = list_->currentItem();
  return item == nullptr ? QString() : item->data(kId).toString();
}

/// Selects the first device that is plugged in, so that its bars show its motion.
void InputDevicesPanel::rebuild() {
  const QString before = current();
  {
    const QSignalBlocker quiet(list_);
    list_->clear();
    list_->addItem(tr("Mouse and keyboard – always on"));
    list_->item(0)->setData(kId, QString());
    for (const InputDeviceEntry& entry : hands_.entries()) {
      auto* item = new QListWidgetItem(titleOf(entry), list_);
      item->setData(kId, entry.id());
      item->setToolTip(kindText(entry.seen.kind));
      item->setCheckState(entry.used ? Qt::Checked : Qt::Unchecked);
    }
    int row = list_->count() > 1 ? 1 : 0;
    for (int one = 1; one < list_->count(); ++one) {
      if (list_->item(one)->data(kId).toString() == before) row = one;
    }
    list_->setCurrentRow(row);
  }
  describe();
}

void InputDevicesPanel::describe() {
  const InputDeviceEntry* const entry = hands_.find(current());
  const bool lacks = entry != nullptr && !entry->seen.missing.empty();
  fix_->setVisible(lacks && !entry->seen.missing.front().command.empty());
  if (lacks)
    showMessage(about_, sentenceText(entry->seen.missing.front().sentence));
  else if (entry == nullptr)
    showMessage(about_,
                tr("Drag the stylus in the view, or click the view and press the arrow keys. Shift+F1 lists all "
                   "keys. A game controller or 3D mouse appears in this list when you plug it in."));
  else
    showMessage(about_, tr("A %1, untested. Its mapping is saved.").arg(kindText(entry->seen.kind)));
  editor_->setDevice(entry == nullptr ? QString() : entry->id());
  editor_->rebuild();
}

void InputDevicesPanel::before() {
  hands_.poll();
}

void InputDevicesPanel::present(const servo::Snapshot&) {
  if (!isSeen()) return;
  const QString rest = hands_.restReason();
  showMessage(state_, rest.isEmpty() ? tr("Every device in use moves the simulated hand.") : rest);
  showMessage(trouble_, hands_.trouble());
  const QSignalBlocker quiet(list_);
  for (int row = 1; row < list_->count(); ++row) {
    const InputDeviceEntry* const entry = hands_.find(list_->item(row)->data(kId).toString());
    if (entry != nullptr && list_->item(row)->text() != titleOf(*entry)) list_->item(row)->setText(titleOf(*entry));
  }
  editor_->present();
}

void InputDevicesPanel::setTheme(const Theme& theme) {
  editor_->setTheme(theme);
}

bool InputDevicesPanel::fix() {
  const InputDeviceEntry* const entry = hands_.find(current());
  if (entry == nullptr || entry->seen.missing.empty()) return false;
  (new FixDialog(sentenceText(entry->seen.name), entry->seen.missing, this))->show();
  return true;
}

}  // namespace underact::gui
