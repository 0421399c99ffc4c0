#include "app/gui/servo/servo_panel.h"

#include <QAction>
#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/panel_scroll.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/arm_choice.h"
#include "app/gui/model/servo_rate.h"
#include "app/gui/model/settings.h"
#include "app/gui/servo/check_dialog.h"
#include "app/gui/servo/rate_chooser.h"
#include "app/gui/servo/sections.h"

namespace underact::gui {
namespace {

constexpr int kTimesASecond = 4;  // updates of the numbers: more cannot be read

}  // namespace

ServoPanel::ServoPanel(const Parts& parts, QWidget* parent) : Panel(parent), parts_(parts) {
  addActions();
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(8, 8, 8, 8);
  column->setSpacing(4);
  buildSwitches(column);
  column->addWidget(limits_ = new LimitsSection(content));
  column->addWidget(time_ = new TimeSection(content));
  column->addWidget(scheduling_ = new SchedulingSection(content));
  column->addStretch(1);
  fillWithScroll(this, content);
  connect(&parts_.rate, &ServoRate::changed, this, &ServoPanel::rateChanged);
}

void ServoPanel::addActions() {
  parts_.actions.add({"session.hold_to_run",
                      tr("&Hold to run"),
                      {},
                      tr("There is force only while the stylus button is held."),
                      {},
                      {},
                      true},
                     [this](const QVariantList& on) {
                       parts_.control.setHoldToRun(on.value(0).toBool());
                       return true;
                     });
  parts_.actions.add({"servo.restart", tr("&Restart the servo"), QKeySequence("Shift+F5"),
                      tr("Ends the servo thread, reopens the arm and starts from the beginning with the same scene.")},
                     [this](const QVariantList&) { return restart(); });
  parts_.actions.addCommand("servo.rate",
                            [this](const QVariantList& rate_hz) { return setRate(rate_hz.value(0).toInt()); });
  parts_.actions.add({"servo.check",
                      tr("&Check the servo…"),
                      {},
                      tr("Measures the latency of the servo and compares it with the best this machine can do.")},
                     [this](const QVariantList&) {
                       if (check_ == nullptr) {
                         check_ = new CheckDialog(parts_.servo.rateHz(), parts_.servo.schedulingWanted(), window());
                         check_->setAttribute(Qt::WA_DeleteOnClose);
                       }
                       check_->show();
                       check_->raise();
                       return true;
                     });
}

QPushButton* ServoPanel::buttonFor(const QString& action, const QString& words) {
  auto* button = new QPushButton(words, this);
  nameWidget(button, QString(action).replace("servo.", "panel.servo."), words, parts_.actions.find(action)->toolTip());
  connect(button, &QPushButton::clicked, this, [this, action] { parts_.actions.perform(action); });
  return button;
}

void ServoPanel::buildSwitches(QVBoxLayout* column) {
  QAction* hold = parts_.actions.find("session.hold_to_run");
  auto* box = new QCheckBox(tr("Hold to run"), this);
  nameWidget(box, "panel.servo.hold_to_run", tr("Hold to run"),
             parts_.arms.simulated() == nullptr
                 ? hold->toolTip()
                 : tr("There is force only while the stylus button is held. On the simulated arm, that button is the "
                      "Space key while the view has the focus (F2)."));
  connect(box, &QCheckBox::toggled, this, [this](bool on) { parts_.actions.perform("session.hold_to_run", on); });
  connect(hold, &QAction::toggled, box, &QCheckBox::setChecked);
  parts_.actions.perform("session.hold_to_run", parts_.settings.hold_to_run);
  told_ = messageLabel("panel.servo.told", tr("Result of the restart or the rate change"), "", this);
  told_->hide();
  rate_ = new RateChooser(this);
  rate_->present(parts_.rate.hz());
  connect(rate_, &RateChooser::asked, this, [this](int rate_hz) { parts_.actions.perform("servo.rate", rate_hz); });
  column->addWidget(box);
  column->addWidget(rate_);
  column->addWidget(buttonFor("servo.restart", tr("Restart the servo")));
  column->addWidget(buttonFor("servo.check", tr("Check the servo…")));
  column->addWidget(told_);
}

bool ServoPanel::restart() {
  const Problems problems = parts_.control.restart();
  const bool done = problems.empty();
  tell(done ? tr("The servo was restarted. Press Start to turn the force on.")
            : tr("The arm could not be reopened. %1").arg(sentencesOf(problems)),
       !done);
  shown_ticks_ = -1;
  return done;
}

bool ServoPanel::setRate(int rate_hz) {
  const Problems problems = parts_.rate.choose(rate_hz);
  if (!problems.empty()) tell(tr("The rate was not changed. %1").arg(sentencesOf(problems)), true);
  rate_->present(parts_.rate.hz());
  return problems.empty();
}

void ServoPanel::rateChanged(int was_hz, int is_hz) {
  told_->hide();
  rate_->present(is_hz);
  limits_->setRate(parts_.servo.snapshot().ticks, was_hz, is_hz);
  since_measured_.invalidate();
  measured_hz_ = is_hz;  // until it is measured
  shown_ticks_ = -1;
}

void ServoPanel::tell(const QString& sentence, bool alarm) {
  told_->setText(sentence);
  told_->setProperty("role", alarm ? "alarm" : "quiet");
  told_->style()->polish(told_);
  told_->show();
  if (alarm) bringForward();  // so that the message is seen, wherever the command came from
}

void ServoPanel::measureRate(const servo::Snapshot& snapshot) {
  if (since_measured_.isValid() && since_measured_.elapsed() < kMeasureEvery_ms) return;
  const double elapsed_s = since_measured_.isValid() ? 1e-9 * static_cast<double>(since_measured_.nsecsElapsed()) : 0.0;
  if (elapsed_s > 0.0) measured_hz_ = static_cast<double>(snapshot.ticks - ticks_at_measure_) / elapsed_s;
  since_measured_.start();
  ticks_at_measure_ = snapshot.ticks;
}

void ServoPanel::remember(Settings& settings) {
  settings.hold_to_run = parts_.servo.holdToRun();
}

void ServoPanel::present(const servo::Snapshot& snapshot) {
  measureRate(snapshot);
  if (snapshot.mode == servo::Mode::Running) told_->hide();  // Start has been pressed since
  if (!isSeen()) return;
  const int rate_hz = parts_.servo.rateHz();
  limits_->present(snapshot, rate_hz);
  const std::int64_t since = snapshot.ticks - shown_ticks_;
  if (shown_ticks_ >= 0 && since >= 0 && since < rate_hz / kTimesASecond) return;
  shown_ticks_ = snapshot.ticks;
  const system::Scheduling scheduling = parts_.servo.scheduling();
  time_->present(snapshot, parts_.servo.timing(), rate_hz, scheduling.name == "manual" ? 0.0 : measured_hz_);
  scheduling_->present(scheduling);
}

void ServoPanel::add(const servo::TickRecord& record) {
  limits_->add(record);
}

void ServoPanel::setTheme(const Theme& theme) {
  time_->setTheme(theme);
  limits_->setTheme(theme);
}

}  // namespace underact::gui
