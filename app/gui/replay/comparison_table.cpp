#include "app/gui/replay/comparison_table.h"

#include <QGridLayout>
#include <QLabel>

#include "app/gui/kit/message_label.h"
#include "app/gui/kit/tight_layout.h"
#include "app/gui/kit/words.h"
#include "core/base/units.h"

namespace underact::gui {
namespace {}  // namespace

ComparisonTable::ComparisonTable(QWidget* parent) : QWidget(parent), stretch_(new QLabel(this)) {
  setObjectName("panel.replay.comparison");
  setAccessibleName(tr("Recorded and now"));
  setToolTip(tr("Over the ticks since the last jump or edit in which both runs sent the whole force."));
  auto* grid = tight<QGridLayout>(this);
  grid->setHorizontalSpacing(20);
  grid->setVerticalSpacing(2);
  int column = 1;
  for (const QString& head : {tr("RMS error [mm]"), tr("maximum force [N]"), tr("mean force [N]")}) {
    auto* label = new QLabel(head, this);
    label->setProperty("role", "quiet");
    grid->addWidget(label, 0, column++, Qt::AlignRight);
  }
  grid->addWidget(new QLabel(tr("recorded"), this), 1, 0);
  grid->addWidget(new QLabel(tr("now"), this), 2, 0);
  recorded_ = {cell("panel.replay.recorded.rms", tr("RMS error, recorded")),
               cell("panel.replay.recorded.peak", tr("Maximum force, recorded")),
               cell("panel.replay.recorded.mean", tr("Mean force, recorded"))};
  now_ = {cell("panel.replay.now.rms", tr("RMS error, now")), cell("panel.replay.now.peak", tr("Maximum force, now")),
          cell("panel.replay.now.mean", tr("Mean force, now"))};
  for (int at = 0; at < 3; ++at) {
    grid->addWidget(recorded_[static_cast<std::size_t>(at)], 1, at + 1, Qt::AlignRight);
    grid->addWidget(now_[static_cast<std::size_t>(at)], 2, at + 1, Qt::AlignRight);
  }
  nameWidget(stretch_, "panel.replay.stretch", tr("Compared over"));
  stretch_->setProperty("role", "quiet");
  grid->addWidget(stretch_, 0, 0);
  grid->setColumnStretch(4, 1);
}

QLabel* ComparisonTable::cell(const char* name, const QString& spoken) {
  auto* label = new QLabel(this);
  nameWidget(label, name, spoken);
  return label;
}

void ComparisonTable::fill(const std::array<QLabel*, 3>& cells, const record::TickFigures& figures) {
  updateText(cells[0], numberText(kMillimetrePerMetre * figures.rmsError_m(), 2));
  updateText(cells[1], numberText(figures.peakForce_N(), 3));
  updateText(cells[2], numberText(figures.meanForce_N(), 3));
}

void ComparisonTable::present(const Comparison& comparison, int rate_hz) {
  fill(recorded_, comparison.recorded());
  fill(now_, comparison.now());
  updateText(stretch_, tr("over %1 s").arg(numberText(static_cast<double>(comparison.ticks()) / rate_hz, 1)));
}

}  // namespace underact::gui
