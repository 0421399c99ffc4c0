#include "app/gui/feature/status_line.h"

#include <QAccessible>
#include <QHBoxLayout>
#include <QLabel>
#include <cmath>

#include "app/gui/kit/message_label.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/limit_names.h"
#include "app/gui/model/servo_rate.h"

namespace underact::gui {
namespace {

constexpr double kRateIsTrue = 0.02;  // a measured rate this close to the requested one is shown as that one

QString modeText(const servo::Snapshot& snapshot) {
  if (snapshot.waits_for_button) return QObject::tr("Hold the button");
  switch (snapshot.mode) {
    case servo::Mode::Idle:
      return QObject::tr("Stopped");
    case servo::Mode::Running:
      return QObject::tr("Running");
    case servo::Mode::Stopping:
      return QObject::tr("Stopping");
    case servo::Mode::Faulted:
      return QObject::tr("Fault");
  }
  return {};
}

}  // namespace

StatusLine::StatusLine(ServoFacts servo, double force_limit_N, QWidget* parent)
    : QWidget(parent), servo_(servo), force_limit_N_(force_limit_N) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 2, 12, 2);
  row->setSpacing(20);
  mode_ = field("status.mode", tr("Servo"), {}, tr("%1, %2").arg(tr("Running"), tr("4000 Hz")));
  device_ = field("status.device", tr("Arm"), {}, {});
  presentDevice();
  rate_ = field("status.rate", tr("Servo rate"), tr("Ticks per second."), tr("4000 Hz"));
  late_ = field("status.late", tr("Latency"),
                tr("99 % of the ticks in the last 10 s began no later than this after their deadline."),
                tr("latency p99 9999 µs"));
  scheduling_ = field("status.scheduling", tr("Scheduling"), {}, {});
  for (QLabel* detail : {rate_, late_, scheduling_}) detail->hide();  // in the tip of the state
  guard_ = field("status.guard", tr("Guard"), {}, {});
  guard_->setProperty("role", "amber-text");
  presentScheduling();
  presentGuard();
  force_ =
      field("status.force", tr("Force"), tr("The force sent to the arm, and its limit."), tr("force 0.00 / 0.00 N"));
  recording_ = field("status.recording", tr("Recording"), {}, {});
  recording_->hide();
  live_ = field("status.live", tr("Live data"), {}, {});
  live_->hide();
  tip_ = new QLabel(this);
  nameWidget(tip_, "status.tip", tr("Hint"));
  tip_->setProperty("role", "quiet");
  tip_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  tip_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  row->addWidget(tip_, 1);
}

QLabel* StatusLine::field(const char* name, const QString& spoken, const QString& tip, const QString& widest) {
  auto* label = new QLabel(this);
  nameWidget(label, name, spoken, tip);
  label->setMinimumWidth(fontMetrics().horizontalAdvance(widest));  // so that changing numbers do not move the layout
  layout()->addWidget(label);
  return label;
}

void StatusLine::setArmModel(const QString& name, const QString& provenance) {
  arm_model_ = name;
  provenance_ = provenance;
  presentDevice(is_recorded_);
}

void StatusLine::presentDevice(bool is_recorded) {
  is_recorded_ = is_recorded;
  const servo::DeviceInfo info = servo_.device();
  const QString title = sentenceText(info.title);
  const QString in_english = QString::fromStdString(info.title);  // the kind may be a part of it in any language
  const bool is_given = is_recorded || in_english.contains("simulated", Qt::CaseInsensitive);
  QString kind = info.simulated && !is_given ? tr(" (simulated)") : QString();
  if (info.untested) kind += tr(" (untested)");
  if (!is_recorded && info.simulated && !arm_model_.isEmpty()) kind += tr(": %1").arg(arm_model_);
  device_->setText(title + kind);
  device_->setToolTip(is_recorded      ? tr("A recording moves the stylus; no force is sent to an arm.")
                      : info.simulated ? tr("Simulated; no real arm moves. %1").arg(provenance_).trimmed()
                                       : QString());
}

void StatusLine::present(const servo::Snapshot& snapshot) {
  if (!since_measured_.isValid() || since_measured_.elapsed() >= kMeasureEvery_ms) {
    presentRate(snapshot);
    presentScheduling();
    presentGuard();
  }
  presentMode(snapshot);
  const double sent_N = snapshot.report.force.f_T_W().norm();
  const bool let_go = snapshot.report.cuts.frozen && snapshot.mode == servo::Mode::Running;
  const QString limit = snapshot.report.level > 0.0 || let_go ? mostLimiting(snapshot.report.cuts) : QString();
  updateText(force_, tr("force %1 / %2 N%3")
                         .arg(numberText(sent_N, 2), numberText(force_limit_N_, 2),
                              limit.isEmpty() ? QString() : tr(", limited: %1").arg(limit)));
}

void StatusLine::presentMode(const servo::Snapshot& snapshot) {
  const bool runs = snapshot.mode == servo::Mode::Running && !snapshot.waits_for_button;
  updateText(mode_, runs && !rate_->text().isEmpty() ? tr("%1, %2").arg(modeText(snapshot), rate_->text())
                                                     : modeText(snapshot));
  presentDetails();
  const char* role = snapshot.waits_for_button               ? "amber-text"
                     : snapshot.mode == servo::Mode::Running ? "running"
                     : snapshot.mode == servo::Mode::Faulted ? "alarm-text"
                                                             : "";
  if (mode_->property("role").toString() != role) {
    mode_->setProperty("role", role);
    mode_->setStyleSheet(mode_->styleSheet());  // makes the style read the property again
  }
}

/// The tip of the state: what happened, or how the servo keeps its time.
void StatusLine::presentDetails() {
  QStringList lines{fault_};
  if (fault_.isEmpty()) {
    lines = {tr("The state of the servo, and its ticks per second."), late_->text(), scheduling_->text(),
             scheduling_->toolTip()};
  }
  lines.removeAll(QString());
  const QString tip = lines.join("\n");
  if (mode_->toolTip() == tip) return;
  mode_->setToolTip(tip);
  mode_->setAccessibleDescription(tip);
}

/// It changes when the servo restarts.
void StatusLine::presentScheduling() {
  const system::Scheduling scheduling = servo_.scheduling();
  updateText(scheduling_, schedulingText(scheduling));
  QStringList lines{sentenceText(scheduling.hint), phrasesOf(scheduling.also)};
  lines.removeAll(QString());
  scheduling_->setToolTip(lines.join("\n"));
}

/// Shown only for an arm that can be guarded and is not.
void StatusLine::presentGuard() {
  const Sentence unguarded = servo_.unguarded();
  const bool was_hidden = guard_->isHidden();
  guard_->setVisible(!unguarded.empty());
  if (unguarded.empty()) return;
  updateText(guard_, tr("not guarded"));
  guard_->setToolTip(sentenceText(unguarded));
  guard_->setAccessibleDescription(sentenceText(unguarded));
  if (!was_hidden) return;
  QAccessibleEvent alert(guard_, QAccessible::Alert);
  QAccessible::updateAccessibility(&alert);
}

void StatusLine::presentRate(const servo::Snapshot& snapshot) {
  const double elapsed_s = since_measured_.isValid() ? 1e-9 * static_cast<double>(since_measured_.nsecsElapsed()) : 0.0;
  const double measured_hz =
      elapsed_s > 0.0 ? static_cast<double>(snapshot.ticks - ticks_at_measure_) / elapsed_s : servo_.rateHz();
  since_measured_.start();
  ticks_at_measure_ = snapshot.ticks;
  const bool by_hand = servo_.scheduling().name == "manual";
  const bool as_asked = by_hand || std::abs(measured_hz - servo_.rateHz()) <= kRateIsTrue * servo_.rateHz();
  updateText(rate_, as_asked ? tr("%1 Hz").arg(servo_.rateHz())
                             : tr("%1 Hz of %2").arg(numberText(measured_hz, 0)).arg(servo_.rateHz()));
  updateText(late_, tr("latency p99 %1 µs").arg(numberText(servo_.timing().lateLately().p99_us, 0)));
}

void StatusLine::setFault(const QString& sentence) {
  fault_ = sentence;
  presentDetails();
  setAccessibleDescription(sentence);
}

void StatusLine::setRecording(const QString& words, const QString& tip, bool needs_a_look) {
  recording_->setVisible(!words.isEmpty());
  recording_->setToolTip(tip);
  if (recording_->text() == words) return;
  recording_->setText(words);
  recording_->setAccessibleDescription(tip);
  recording_->setProperty("role", needs_a_look ? "amber-text" : "");
  recording_->setStyleSheet(recording_->styleSheet());
  if (!needs_a_look || words.isEmpty()) return;
  QAccessibleEvent alert(recording_, QAccessible::Alert);
  QAccessible::updateAccessibility(&alert);
}

void StatusLine::setLive(const QString& where, const QString& details) {
  updateText(live_, where);
  if (live_->toolTip() != details) live_->setToolTip(details);
  live_->setVisible(!where.isEmpty());
}

void StatusLine::setTip(const QString& tip) {
  tip_->setText(fontMetrics().elidedText(tip, Qt::ElideRight, tip_->width()));
}

}  // namespace underact::gui
