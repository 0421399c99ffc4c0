#include "app/gui/replay/replay_bar.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <limits>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/chooser.h"
#include "app/gui/kit/icons.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/kit/tight_layout.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/player.h"
#include "app/gui/replay/comparison_table.h"
#include "app/gui/replay/scrub_slider.h"

namespace underact::gui {
namespace {

constexpr int kFramesAPlace = 3;  // while playing: numbers that change more often cannot be read
constexpr std::array kReplaySpeeds{0.1, 0.25, 0.5, 1.0, 2.0, 4.0};

/// "1:02.345"
QString timeText(double time_s) {
  const auto minutes = static_cast<qint64>(time_s / 60.0);
  return QString("%1:%2").arg(minutes).arg(time_s - 60.0 * static_cast<double>(minutes), 6, 'f', 3, QLatin1Char('0'));
}

}  // namespace

ReplayBar::ReplayBar(Player& player, Actions& actions, QWidget* parent)
    : QWidget(parent), player_(player), actions_(actions) {
  setObjectName("panel.replay");
  setAccessibleName(tr("Replay"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 4, 12, 6);
  column->setSpacing(2);
  buildLoading(column);
  replay_ = new QWidget(this);
  auto* rows = tight<QVBoxLayout>(replay_, 4);
  column->addWidget(replay_);
  buildTransport(rows);
  buildChoices(rows);
  rows->addWidget(comparison_ = new ComparisonTable(replay_));
  comparison_->hide();
  show(false, false);
  connect(&player, &Player::loading, this, [this] { show(true, player_.isOpen()); });
  connect(&player, &Player::failed, this, [this] { show(player_.isLoading(), player_.isOpen()); });
  connect(&player, &Player::cancelled, this, [this] { show(false, player_.isOpen()); });
  connect(&player, &Player::opened, this, &ReplayBar::begin);
  connect(&player, &Player::closed, this, [this] { show(player_.isLoading(), false); });
  connect(&player, &Player::changed, this, &ReplayBar::presentSpeed);
  connect(&player, &Player::whatIfChanged, comparison_, &QWidget::setVisible);
}

void ReplayBar::buildLoading(QVBoxLayout* column) {
  loading_ = new QWidget(this);
  auto* row = tight<QHBoxLayout>(loading_, 12);
  reading_ = new QLabel(tr("Reading the session"), loading_);
  progress_ = new QProgressBar(loading_);
  nameWidget(progress_, "panel.replay.progress", tr("Reading progress"));
  progress_->setRange(0, 1000);
  auto* cancel = new QPushButton(tr("Cancel"), loading_);
  nameWidget(cancel, "panel.replay.cancel", tr("Cancel opening the session"));
  connect(cancel, &QPushButton::clicked, &player_, &Player::cancelLoading);
  row->addWidget(reading_);
  row->addWidget(progress_, 1);
  row->addWidget(cancel);
  column->addWidget(loading_);
}

QToolButton* ReplayBar::button(const char* action, const QString& spoken) {
  return iconButton(QString("panel.replay.") + action, actions_.find(QString("replay.") + action), spoken, replay_);
}

QCheckBox* ReplayBar::box(const char* action, const QString& words) {
  auto* made = new QCheckBox(words, replay_);
  QAction* does = actions_.find(QString("replay.") + action);
  nameWidget(made, QString("panel.replay.") + action, words, does->toolTip());
  connect(made, &QCheckBox::clicked, this,
          [this, action](bool on) { actions_.perform(QString("replay.") + action, on); });
  connect(does, &QAction::toggled, made, &QCheckBox::setChecked);
  return made;
}

void ReplayBar::buildTransport(QVBoxLayout* column) {
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  row->addWidget(back_ = button("back", tr("One tick back")));
  row->addWidget(play_ = button("play", tr("Play")));
  row->addWidget(forward_ = button("forward", tr("One tick forward")));
  scrub_ = new ScrubSlider(replay_);
  nameWidget(scrub_, "panel.replay.scrub", tr("Position in the recording"),
             tr("Click or drag to jump. Strokes above the line are markers, crosses are faults."));
  connect(scrub_, &QSlider::valueChanged, this, [this](int to) { player_.seek(to); });
  row->addWidget(scrub_, 1);
  time_ = new QLabel(replay_);
  nameWidget(time_, "panel.replay.time", tr("Time in the recording"));
  row->addWidget(time_);
  column->addLayout(row);
}

void ReplayBar::buildChoices(QVBoxLayout* column) {
  auto* row = new QHBoxLayout;
  row->setSpacing(12);
  speed_ = new QComboBox(replay_);
  speed_->setObjectName("panel.replay.speed");
  nameChooser(speed_, tr("Speed"),
              tr("Speed of the hand relative to the recording. At 1 × the samples are exactly the recorded ones."));
  for (const double speed : kReplaySpeeds) speed_->addItem(tr("%1 ×").arg(speed), speed);
  speed_->setCurrentIndex(3);
  speed_->setFocusPolicy(Qt::StrongFocus);
  connect(speed_, &QComboBox::activated, this,
          [this](int index) { player_.setSpeed(kReplaySpeeds[static_cast<std::size_t>(index)]); });
  row->addWidget(speed_);
  row->addWidget(box("loop", tr("Loop")));
  for (const auto& [action, words] : {std::pair{"loop_in", tr("In")}, {"loop_out", tr("Out")}}) {
    QToolButton* made = button(action, actions_.find(QString("replay.") + action)->text().remove('&'));
    made->setText(words);
    row->addWidget(made);
  }
  row->addWidget(box("what_if", tr("What if")));
  here_ = new QLabel(replay_);
  nameWidget(here_, "panel.replay.here", tr("Recorded force and error"));
  here_->setProperty("role", "quiet");
  here_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  row->addWidget(here_, 1);
  auto* close = new QPushButton(tr("Close"), replay_);
  nameWidget(close, "panel.replay.close", tr("Close session"), actions_.find("replay.close")->toolTip());
  connect(close, &QPushButton::clicked, actions_.find("replay.close"), &QAction::trigger);
  row->addWidget(close);
  column->addLayout(row);
}

void ReplayBar::show(bool loads, bool plays) {
  loading_->setVisible(loads);
  replay_->setVisible(plays);
  setVisible(loads || plays);
}

void ReplayBar::begin() {
  const QSignalBlocker silent(scrub_);
  const std::int64_t last = std::min<std::int64_t>(player_.lastRow(), std::numeric_limits<int>::max());
  scrub_->setRange(0, static_cast<int>(last));
  scrub_->setSingleStep(1);
  scrub_->setPageStep(player_.recorded().rate_hz);
  scrub_->setValue(0);
  scrub_->setMarks(player_.recorded().marks);
  time_->setMinimumWidth(fontMetrics().horizontalAdvance(timeText(player_.secondsAt(last)) + " / " +
                                                         timeText(player_.secondsAt(last)) + "  "));
  show(false, true);
  presentPlace();
}

void ReplayBar::presentPlace() {
  const std::int64_t row = player_.row();
  if (!scrub_->isSliderDown()) {
    const QSignalBlocker silent(scrub_);
    scrub_->setValue(static_cast<int>(row));
  }
  scrub_->setLoop(player_.loops() ? std::optional(std::pair(player_.loopIn(), player_.loopOut())) : std::nullopt);
  updateText(time_, timeText(player_.secondsAt(row)) + " / " + timeText(player_.secondsAt(player_.lastRow())));
  const device::RecordedRow& recorded = player_.recorded().rows[static_cast<std::size_t>(row)];
  const QString text =
      tr("%1: recorded force %2 N, error %3 mm")
          .arg(QString::fromStdString(player_.recorded().name), numberText(static_cast<double>(recorded.force_N), 2),
               numberText(1e3 * static_cast<double>(recorded.error_m), 1));
  updateText(here_, here_->fontMetrics().elidedText(text, Qt::ElideRight, here_->width()));
}

void ReplayBar::presentSpeed() {
  const auto found = std::find(kReplaySpeeds.begin(), kReplaySpeeds.end(), player_.speed());
  const QSignalBlocker silent(speed_);
  speed_->setCurrentIndex(found == kReplaySpeeds.end() ? -1 : static_cast<int>(found - kReplaySpeeds.begin()));
}

QString ReplayBar::busyReason() const {
  return player_.isOpen() ? tr("A session is being replayed. Close the replay first.") : QString();
}

void ReplayBar::present(const servo::Snapshot&) {
  if (player_.isLoading()) progress_->setValue(static_cast<int>(player_.share() * progress_->maximum()));
  if (!player_.isOpen()) return;
  const bool is_due = !player_.isPlaying() || ++frame_ % kFramesAPlace == 0;
  if (is_due) {
    presentPlace();
    comparison_->present(player_.comparison(), player_.recorded().rate_hz);
  }
  if (player_.isPlaying() == shows_pause_) return;
  shows_pause_ = player_.isPlaying();
  play_->setIcon(icon(shows_pause_ ? "pause" : "play", theme_));
  play_->setAccessibleName(shows_pause_ ? tr("Pause") : tr("Play"));
}

void ReplayBar::setTheme(const Theme& theme) {
  theme_ = theme;
  play_->setIcon(icon(shows_pause_ ? "pause" : "play", theme));
  back_->setIcon(icon("back", theme));
  forward_->setIcon(icon("forward", theme));
  scrub_->setTheme(theme);
}

}  // namespace underact::gui
