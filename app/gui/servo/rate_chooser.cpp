#include "app/gui/servo/rate_chooser.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <algorithm>
#include <vector>

#include "app/gui/kit/chooser.h"
#include "app/gui/kit/tight_layout.h"

namespace underact::gui {

RateChooser::RateChooser(QWidget* parent)
    : QWidget(parent),
      box_(chooser("panel.servo.rate_choice", tr("Servo rate"),
                   tr("Ticks per second. Changing the rate releases the force for a moment; a running servo restarts "
                      "with its soft start."),
                   this)) {
  auto* row = tight<QHBoxLayout>(this, 8);
  auto* label = new QLabel(tr("Rate"), this);
  label->setBuddy(box_);
  label->setToolTip(box_->toolTip());
  row->addWidget(label);
  row->addWidget(box_, 1);
  connect(box_, &QComboBox::activated, this, [this](int index) { emit asked(box_->itemData(index).toInt()); });
}

void RateChooser::present(int rate_hz) {
  if (rate_hz == shown_hz_ && box_->currentData().toInt() == rate_hz) return;
  shown_hz_ = rate_hz;
  std::vector<int> rates{250, 500, 1000, 2000, 4000, 8000, 10'000};
  if (std::find(rates.begin(), rates.end(), rate_hz) == rates.end()) rates.push_back(rate_hz);
  std::sort(rates.begin(), rates.end());
  const QSignalBlocker silent(box_);
  box_->clear();
  for (const int one : rates) box_->addItem(tr("%1 Hz").arg(one), one);
  box_->setCurrentIndex(box_->findData(rate_hz));
}

}  // namespace underact::gui
