#include <QCoreApplication>
#include <QVBoxLayout>

#include "app/gui/kit/number_table.h"
#include "app/gui/kit/readout.h"
#include "app/gui/kit/words.h"
#include "app/gui/plot/lateness_chart.h"
#include "app/gui/servo/sections.h"

namespace underact::gui {
namespace {

enum RateRow { kAskedRate, kMeasuredRate };
enum LateRow { kLate, kFirstCause, kLeftOut = kFirstCause + static_cast<int>(servo::kLateCauses), kDropped };
enum TimeRow { kSinceStart, kLately, kTickTime };

struct CauseWords {
  servo::LateCause cause;
  const char *label, *tip;
};

constexpr CauseWords kCauses[] = {
    {servo::LateCause::Overrun, QT_TRANSLATE_NOOP("cause", "previous tick too long"),
     QT_TRANSLATE_NOOP("cause", "The previous tick took longer than a period.")},
    {servo::LateCause::Device, QT_TRANSLATE_NOOP("cause", "waiting for the arm"),
     QT_TRANSLATE_NOOP("cause", "Most of the delay was spent waiting for the arm.")},
    {servo::LateCause::PageFault, QT_TRANSLATE_NOOP("cause", "page fault"),
     QT_TRANSLATE_NOOP("cause", "The servo thread accessed memory that the system had to load first.")},
    {servo::LateCause::Preempted, QT_TRANSLATE_NOOP("cause", "preempted"),
     QT_TRANSLATE_NOOP("cause", "Another thread ran on the servo's core.")},
    {servo::LateCause::Woken, QT_TRANSLATE_NOOP("cause", "woken late"),
     QT_TRANSLATE_NOOP("cause", "None of these: the system, or the host of a virtual machine, woke the thread late.")}};

Readout* withoutMargins(Readout* readout) {
  readout->layout()->setContentsMargins(0, 0, 0, 0);
  return readout;
}

}  // namespace

TimeSection::TimeSection(QWidget* parent)
    : Section("time", tr("Time"), tr("How evenly the servo loop runs."), parent, "servo"),
      rate_(withoutMargins(new Readout("panel.servo.rate", this))),
      late_(withoutMargins(new Readout("panel.servo.late", this))),
      percentiles_(new NumberTable(
          "panel.servo.times", {{"p50", "99999"}, {"p99", "99999"}, {"p99.9", "99999"}, {tr("max"), "999999"}}, this)),
      chart_(new LatenessChart(this)) {
  rate_->addRow(tr("Nominal rate"), tr("Ticks per second, as set above or on the command line (--rate)."));
  rate_->addRow(tr("measured"), tr("Ticks per second, measured by the computer's clock."));
  percentiles_->addRow(tr("latency"), tr("Latency of the ticks since the servo was started at this rate, in µs. p99: "
                                         "99 of 100 ticks start no later than this."));
  percentiles_->addRow(tr("last 10 s"), tr("Latency of the ticks of the last 10 s, in µs."));
  percentiles_->addRow(tr("tick time"), tr("How long a tick takes from the sample to the force, in µs."));
  late_->addRow(tr("Late ticks"), tr("Ticks that started late by a period or more. The lost time is not made up for."));
  for (const CauseWords& cause : kCauses) {
    late_->addRow(QString(QChar(0x2013)) + " " + QCoreApplication::translate("cause", cause.label),
                  QCoreApplication::translate("cause", cause.tip));
  }
  late_->addRow(
      tr("Skipped"),
      tr("Deadlines that had passed when a late tick started. They are skipped, not made up for in a burst."));
  late_->addRow(tr("Lost rows"),
                tr("Ticks missing from plots and recordings because the window was busy. The servo was not affected."));
  column().addWidget(rate_);
  column().addWidget(quietLabel("panel.servo.unit", tr("Microseconds:"), this));
  column().addWidget(percentiles_);
  column().addWidget(chart_);
  column().addWidget(late_);
}

void TimeSection::present(const servo::Snapshot& snapshot, const servo::Timing& timing, int rate_hz,
                          double measured_hz) {
  rate_->set(kAskedRate, tr("%1 Hz").arg(rate_hz));
  rate_->set(kMeasuredRate, measured_hz == 0.0 ? tr("by hand") : tr("%1 Hz").arg(numberText(measured_hz, 0)));
  const auto row = [this](int index, const servo::Percentiles& us) {
    const double values[] = {us.p50_us, us.p99_us, us.p999_us, us.max_us};
    for (int column = 0; column < 4; ++column) {
      percentiles_->set(index, column, numberText(values[column], values[column] < 9.95 ? 1 : 0));
    }
  };
  row(kSinceStart, timing.lateness());
  row(kLately, timing.lateLately());
  row(kTickTime, timing.tickTime());
  chart_->present(timing.latenessHistogram(), 1e6 / rate_hz);
  late_->set(kLate, QString::number(snapshot.late.total));
  int line = kFirstCause;
  for (const CauseWords& cause : kCauses) {
    late_->set(line++, QString::number(snapshot.late.by_cause[static_cast<std::size_t>(cause.cause)]));
  }
  late_->set(kLeftOut, QString::number(snapshot.late.left_out));
  late_->set(kDropped, QString::number(snapshot.dropped));
}

void TimeSection::setTheme(const Theme& theme) {
  chart_->setTheme(theme);
}

}  // namespace underact::gui
