#include "app/gui/input_devices/press_rows.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <algorithm>

#include "app/gui/input_devices/input_devices.h"
#include "app/gui/input_devices/input_words.h"
#include "app/gui/kit/chooser.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/kit/tight_layout.h"
#include "device/input/map_file.h"

namespace underact::gui {

namespace input = device::input;

PressRows::PressRows(QWidget* parent) : QWidget(parent) {
  auto* grid = tight<QGridLayout>(this);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(4);
  grid->addWidget(sectionTitle(tr("Buttons"), this), 0, 0, 1, 3);
  for (std::size_t press = 0; press < input::kPresses; ++press) {
    const QString title = pressTitle(static_cast<input::ButtonRole>(press)),
                  name = input::pressName(static_cast<input::ButtonRole>(press));
    const QByteArray object = ("panel.hands.press." + name).toLatin1();
    presses_[press] = chooser(object.constData(), title, tr("The button of the device with this function."), this);
    learns_[press] = pushButton("panel.hands.learn." + name, tr("Learn…"),
                                tr("Assigns the button that you press next."), this, tr("Learn %1").arg(title));
    auto* label = new QLabel(title, this);
    label->setBuddy(presses_[press]);
    const int row = static_cast<int>(press) + 1;
    grid->addWidget(label, row, 0);
    grid->addWidget(presses_[press], row, 1);
    grid->addWidget(learns_[press], row, 2);
    connect(presses_[press], &QComboBox::activated, this,
            [this, name, press] { emit chosen(name, presses_[press]->currentData()); });
    connect(learns_[press], &QPushButton::clicked, this, [this, name] { emit learnAsked(name); });
  }
  grid->setColumnStretch(1, 1);
}

void PressRows::present(const InputDeviceEntry& now) {
  for (std::size_t press = 0; press < input::kPresses; ++press) {
    QComboBox* const box = presses_[press];
    const QSignalBlocker quiet(box);
    box->clear();
    const int buttons = std::max(std::min(now.seen.readings.buttons, input::kMaxButtons), now.map.presses[press] + 1);
    for (int button = -1; button < buttons; ++button) {
      const auto index = static_cast<std::size_t>(std::max(button, 0));
      const auto& names = now.seen.button_names;
      const bool is_none = button >= 0 && index < names.size() && names[index].empty();
      if (!is_none || button == now.map.presses[press]) box->addItem(buttonText(now.seen, button), button);
    }
    box->setCurrentIndex(box->findData(now.map.presses[press]));
  }
}

void PressRows::presentLearning(const QString& learning) {
  for (std::size_t press = 0; press < input::kPresses; ++press)
    learns_[press]->setText(learning == input::pressName(static_cast<input::ButtonRole>(press)) ? tr("Cancel")
                                                                                                : tr("Learn…"));
}

}  // namespace underact::gui
