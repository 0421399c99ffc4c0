#include "app/gui/calibration/staircase_chart.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "app/gui/kit/spoken.h"

namespace underact::gui {
namespace {

constexpr double kTicks[] = {0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0};
constexpr double kDot = 3.0;

QString percentLabel(double share) {
  return QObject::tr("%1 %").arg(100.0 * share);
}

}  // namespace

StaircaseChart::StaircaseChart(QWidget* parent) : QWidget(parent) {
  speakAs(this, QAccessible::Chart);
  setObjectName("panel.calibration.chart");
  setAccessibleName(tr("Difference of stiffness against trial"));
  setToolTip(tr("The difference of each trial. Filled: right; hollow: wrong; ringed: the way turned (reversal)."));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::MinimumExpanding);
}

QSize StaircaseChart::minimumSizeHint() const {
  return {12 * fontMetrics().averageCharWidth() + 96, 11 * fontMetrics().lineSpacing()};
}

void StaircaseChart::present(const calibration::Measurement& run) {
  run_ = run;
  least_ = most_ = run.staircase.rule.first;
  for (const calibration::Answered& one : run.answers) {
    least_ = std::min(least_, one.trial.difference);
    most_ = std::max(most_, one.trial.difference);
  }
  least_ /= 1.3;
  most_ *= 1.3;
  const auto threshold = thresholdOf(run.staircase);
  setAccessibleDescription(
      threshold ? tr("%1 trials; the threshold is %2").arg(run.answers.size()).arg(percentLabel(threshold->difference))
                : tr("%1 trials; no threshold").arg(run.answers.size()));
  update();
}

void StaircaseChart::setTheme(const Theme& theme) {
  theme_ = theme;
  update();
}

QRectF StaircaseChart::plot() const {
  const double left = fontMetrics().horizontalAdvance(percentLabel(0.005)) + 8.0;
  const double line = fontMetrics().lineSpacing();
  return {left, line + 4.0, width() - left - 8.0, height() - 3.0 * line - 12.0};
}

double StaircaseChart::yOf(double difference) const {
  return plot().bottom() - plot().height() * std::log(difference / least_) / std::log(most_ / least_);
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
  const QColor words = mixed(palette().color(QPalette::Window), theme_.ink, 0.75);
  const double line = fontMetrics().lineSpacing();
  painter.setPen(words);
  painter.drawText(QRectF(0.0, 0.0, width(), line), Qt::AlignLeft, tr("difference"));
  const QRectF below(plot().left(), plot().bottom() + 4.0, plot().width(), line);
  painter.drawText(below, Qt::AlignHCenter, tr("trial"));
  painter.drawText(below, Qt::AlignLeft, "1");
  painter.drawText(below, Qt::AlignRight, QString::number(run_.answers.size()));
  painter.drawText(QRectF(0.0, below.bottom() + 4.0, width(), line), Qt::AlignHCenter, tr("● right  ○ wrong  ◎ turn"));
  for (const double tick : kTicks) {
    if (tick < least_ || tick > most_) continue;
    painter.setPen(words);
    painter.drawText(QRectF(0.0, yOf(tick) - 0.5 * line, plot().left() - 6.0, line), Qt::AlignRight | Qt::AlignVCenter,
                     percentLabel(tick));
    painter.setPen(QPen(mixed(palette().color(QPalette::Window), theme_.quiet, 0.6), 1.0));
    painter.drawLine(QPointF(plot().left(), yOf(tick)), QPointF(plot().right(), yOf(tick)));
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
  QPainterPath way;
  for (std::size_t index = 0; index < run_.answers.size(); ++index) {
    const QPointF at(xOf(static_cast<double>(index) + 1.0), yOf(run_.answers[index].trial.difference));
    index == 0 ? way.moveTo(at) : way.lineTo(at);
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(mixed(palette().color(QPalette::Window), theme_.ink, 0.5), 1.0));
  painter.drawPath(way);
  for (std::size_t index = 0; index < run_.answers.size(); ++index) {
    const calibration::Answered& one = run_.answers[index];
    const QPointF at(xOf(static_cast<double>(index) + 1.0), yOf(one.trial.difference));
    painter.setPen(QPen(theme_.ink, 1.2));
    painter.setBrush(one.isRight() ? theme_.ink : palette().color(QPalette::Window));
    painter.drawEllipse(at, kDot, kDot);
    if (!one.turned) continue;
    painter.setPen(QPen(theme_.force_limited, 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(at, 2.0 * kDot, 2.0 * kDot);
  }
}

}  // namespace underact::gui
