#include "app/gui/compare/compare_strip.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/kit/words.h"
#include "core/base/units.h"

namespace underact::gui {
namespace {

QString figuresText(const record::TickFigures& figures) {
  return CompareStrip::tr("mean %1 N, maximum %2 N, RMS error %3 mm")
      .arg(numberText(figures.meanForce_N(), 2), numberText(figures.peakForce_N(), 2),
           numberText(kMillimetrePerMetre * figures.rmsError_m(), 2));
}

}  // namespace

CompareStrip::CompareStrip(Actions& actions, QWidget* parent) : QWidget(parent) {
  setObjectName("compare");
  setAccessibleName(tr("Two scenes compared"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 4, 12, 6);
  column->setSpacing(4);
  told_ = messageLabel("compare.told", tr("Message about the comparison"), "alarm", this);
  difference_ = messageLabel("compare.difference", tr("Differences between the two scenes"), "", this);
  figures_ = messageLabel("compare.figures", tr("Force and error of both scenes"), "quiet", this);
  column->addWidget(told_);
  column->addWidget(difference_);
  column->addWidget(figures_);
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  const auto button = [&](const QString& name, const QString& text) {
    QAction* does = actions.find(name);
    auto* made = pushButton("compare.button." + name.section('.', 1), text, does->toolTip(), this);
    connect(made, &QPushButton::clicked, does, &QAction::trigger);
    row->addWidget(made);
  };
  button("compare.swap", tr("Swap"));
  button("compare.same", tr("Same as felt"));
  button("compare.open", tr("Another scene…"));
  row->addStretch(1);
  button("compare.on", tr("Close"));
  column->addLayout(row);
  tell({});
  hide();
}

void CompareStrip::setDifference(const QString& words, const QString& all) {
  difference_->setText(words);
  difference_->setToolTip(all);
}

void CompareStrip::tell(const QString& sentence) {
  showMessage(told_, sentence);
}

void CompareStrip::present(const record::TickFigures& felt, const record::TickFigures& beside) {
  const QString text =
      felt.ticks() == 0
          ? tr("Start the servo to compare the forces.")
          : tr("Since the last change. Felt scene: %1. Other scene: %2.").arg(figuresText(felt), figuresText(beside));
  if (figures_->text() != text) figures_->setText(text);
}

}  // namespace underact::gui
