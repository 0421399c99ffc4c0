#include "app/gui/calibration/staircase_chart.h"

#include "app/gui/kit/words.h"

namespace underact::gui {
namespace {

constexpr double kTrialDot = 3.0;
constexpr double kStaircaseRoom = 1.3;

QString percentLabel(double share) {
  return QObject::tr("%1 %").arg(100.0 * share);
}

}  // namespace

MarkChart* staircaseChart(QWidget* parent) {
  return new MarkChart("panel.calibration.chart", tr("Difference of stiffness against trial"),
                       tr("The difference of each trial. Filled: right; hollow: wrong; ringed: reversal."), {12, 11},
                       parent);
}

MarkSheet staircaseSheet(const calibration::Measurement& run) {
  const QString trials = QString::number(run.answers.size());
  const auto threshold = thresholdOf(run.staircase);
  MarkSheet sheet;
  sheet.spoken = threshold ? tr("%1 trials; the threshold is %2").arg(trials, percentLabel(threshold->difference))
                           : tr("%1 trials; no threshold").arg(trials);
  sheet.y_title = tr("difference");
  sheet.words = {{0, Qt::AlignHCenter, tr("trial")}, {0, Qt::AlignLeft, "1"}, {0, Qt::AlignRight, trials}};
  sheet.key = tr("● right  ○ wrong  ◎ reversal");
  sheet.widest = percentLabel(0.005);
  sheet.path_line = {&Theme::ink, 0.5};
  if (threshold) sheet.band = {threshold->low, threshold->difference, threshold->high};
  std::vector<double> differences{run.staircase.rule.first};
  for (const calibration::Answered& one : run.answers) {
    differences.push_back(one.trial.difference);
    const QPointF at(static_cast<double>(sheet.path.size() + 1), one.trial.difference);
    sheet.path.push_back(at);
    sheet.marks.push_back(
        {at, kTrialDot, {&Theme::ink}, 1.2, MarkSheet::Colour{&Theme::ink, one.isRight() ? 1.0 : 0.0}});
    if (one.turned) sheet.marks.push_back({at, 2.0 * kTrialDot, {&Theme::force_limited}, 1.5});
  }
  sheet.x.to = static_cast<double>(run.answers.size()) + 1.0;
  sheet.y = MarkSheet::around(differences, kStaircaseRoom);
  sheet.y.text = percentLabel;
  return sheet;
}

}  // namespace underact::gui
