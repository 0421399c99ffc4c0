#include "app/gui/sessions/buttons_section.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QSettings>
#include <QVBoxLayout>
#include <algorithm>

namespace underact::gui {
namespace {

QString settingOf(int button) {
  return QString("recording/stylus_button_%1").arg(button + 1);
}

QString buttonTip(int button) {
  return button == 0 ? QObject::tr(
                           "The stylus button nearer the tip. On the simulated arm it is the Space key, while the view "
                           "has the focus (F2).")
                     : QObject::tr("The stylus button farther from the tip. The simulated arm has none.");
}

}  // namespace

ButtonsSection::ButtonsSection(QWidget* parent)
    : Section("buttons", tr("Stylus buttons"), tr("What each stylus button does."), parent, "sessions") {
  auto* form = new QFormLayout;
  form->setSpacing(4);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  const QString names[] = {tr("At the ti&p"), tr("Se&cond")};
  const QSettings stored;
  for (int button = 0; button < kStylusButtons; ++button) {
    auto* box = new QComboBox(this);
    box->setObjectName(QString("panel.sessions.button.%1").arg(button + 1));
    box->setAccessibleName(QString(names[button]).remove('&'));
    box->setToolTip(buttonTip(button));
    box->setFocusPolicy(Qt::StrongFocus);  // the wheel scrolls the panel
    box->addItems({tr("No action"), tr("Start or stop recording"), tr("Set a marker")});
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(8);
    box->setCurrentIndex(std::clamp(stored.value(settingOf(button), 0).toInt(), 0, box->count() - 1));
    connect(box, &QComboBox::currentIndexChanged, this,
            [button](int index) { QSettings().setValue(settingOf(button), index); });
    auto* label = new QLabel(names[button], this);
    label->setBuddy(box);
    label->setToolTip(box->toolTip());
    form->addRow(label, box);
    uses_[static_cast<std::size_t>(button)] = box;
  }
  column().addLayout(form);
  setOpen(false);  // set once and rarely changed
}

ButtonUse ButtonsSection::use(int button) const {
  const QComboBox* box = uses_[static_cast<std::size_t>(button)];
  return box->isEnabled() ? static_cast<ButtonUse>(box->currentIndex()) : ButtonUse::Nothing;
}

void ButtonsSection::add(const servo::TickRecord& record) {
  const unsigned down = edges_.add(record);
  for (int button = 0; button < kStylusButtons; ++button) {
    if ((down >> button & 1U) != 0 && use(button) != ButtonUse::Nothing) emit pressed(use(button));
  }
}

void ButtonsSection::setHoldToRun(bool on) {
  uses_[0]->setEnabled(!on);
  uses_[0]->setToolTip(on ? tr("Hold to run is on: this button enables the force and does nothing else.")
                          : buttonTip(0));
}

}  // namespace underact::gui
