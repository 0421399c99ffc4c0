#include "app/gui/calibration/staircase_chart.h"

#include <algorithm>

namespace underact::gui {
namespace {

constexpr double kTicks[] = {0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0};
constexpr double kDot = 3.0;

QString percentLabel(double share) {
  return QObject::tr("%1 %").arg(100.0 * share);
}

}  // namespace

StaircaseChart::StaircaseChart(QWidget* parent)
    : MarkChart("panel.calibration.chart", tr("Difference of stiffness against trial"),
                tr("The difference of each trial. Filled: right; hollow: wrong; ringed: the way turned (reversal)."),
                parent) {}

QSize StaircaseChart::minimumSizeHint() const {
  return {12 * fontMetrics().averageCharWidth() + 96, 11 * fontMetrics().lineSpacing()};
}

void StaircaseChart::present(const calibration::Measurement& run) {
  run_ = run;
  scale_ = {run.staircase.rule.first, run.staircase.rule.first};
  for (const calibration::Answered& one : run.answers)
    scale_ = {std::min(scale_.least, one.trial.difference), std::max(scale_.most, one.trial.difference)};
  scale_ = {scale_.least / 1.3, scale_.most * 1.3};
  const auto threshold = thresholdOf(run.staircase);
  setAccessibleDescription(
      threshold ? tr("%1 trials; the threshold is %2").arg(run.answers.size()).arg(percentLabel(threshold->difference))
                : tr("%1 trials; no threshold").arg(run.answers.size()));
  update();
}

QRectF StaircaseChart::plot() const {
  return axes(percentLabel(0.005), 2.0 * lineHeight() + 8.0);
}

double StaircaseChart::yOf(double difference) const {
  return plot().bottom() - plot().height() * scale_.shareOf(difference);
}

double StaircaseChart::xOf(double trial) const {
  return plot().left() + plot().width() * trial / (static_cast<double>(run_.answers.size()) + 1.0);
}

void StaircaseChart::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  drawAxes(painter);
  drawThreshold(painter);
  drawTrials(painter);
}

void StaircaseChart::drawAxes(QPainter& painter) const {
  const double line = lineHeight();
  drawTitle(painter, tr("difference"));
  const QRectF below(plot().left(), plot().bottom() + 4.0, plot().width(), line);
  painter.drawText(below, Qt::AlignHCenter, tr("trial"));
  painter.drawText(below, Qt::AlignLeft, "1");
  painter.drawText(below, Qt::AlignRight, QString::number(run_.answers.size()));
  painter.drawText(QRectF(0.0, below.bottom() + 4.0, width(), line), Qt::AlignHCenter, tr("● right  ○ wrong  ◎ turn"));
  for (const double tick : kTicks) {
    if (tick >= scale_.least && tick <= scale_.most) drawLevel(painter, plot(), yOf(tick), percentLabel(tick));
  }
}

void StaircaseChart::drawThreshold(QPainter& painter) const {
  const auto threshold = thresholdOf(run_.staircase);
  if (!threshold) return;
  QColor band = theme_.target;
  band.setAlphaF(0.18F);
  const QRectF all(QPointF(plot().left(), yOf(threshold->high)), QPointF(plot().right(), yOf(threshold->low)));
  painter.fillRect(all.intersected(plot()), band);
  painter.setPen(QPen(theme_.target, 1.5));
  painter.drawLine(QPointF(plot().left(), yOf(threshold->difference)),
                   QPointF(plot().right(), yOf(threshold->difference)));
}

void StaircaseChart::drawTrials(QPainter& painter) const {
  std::vector<QPointF> way;
  for (std::size_t index = 0; index < run_.answers.size(); ++index)
    way.emplace_back(xOf(static_cast<double>(index) + 1.0), yOf(run_.answers[index].trial.difference));
  drawWay(painter, way, QPen(ink(0.5), 1.0));
  for (std::size_t index = 0; index < run_.answers.size(); ++index) {
    const calibration::Answered& one = run_.answers[index];
    painter.setPen(QPen(theme_.ink, 1.2));
    painter.setBrush(one.isRight() ? theme_.ink : palette().color(QPalette::Window));
    painter.drawEllipse(way[index], kDot, kDot);
    if (!one.turned) continue;
    painter.setPen(QPen(theme_.force_limited, 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(way[index], 2.0 * kDot, 2.0 * kDot);
  }
}

}  // namespace underact::gui
