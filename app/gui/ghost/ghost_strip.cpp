#include "app/gui/ghost/ghost_strip.h"

#include <QAccessible>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <cmath>

#include "app/gui/ghost/ghost_hand.h"
#include "app/gui/ghost/ghost_words.h"
#include "app/gui/kit/icons.h"
#include "app/gui/kit/number_box.h"
#include "app/gui/kit/told_label.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/document.h"
#include "app/gui/model/session_words.h"
#include "core/base/units.h"

namespace underact::gui {
namespace {

constexpr int kFramesANumber = 3;  // while it plays: numbers that change more often cannot be read

/// A label that is there while it says something.
void tell(QLabel* label, const QString& text) {
  putText(label, text);
  if (label->isHidden() != text.isEmpty()) label->setVisible(!text.isEmpty());
}

}  // namespace

void GhostStrip::present(const servo::Snapshot&) {
  if (!ghost_.isOpen()) return;
  if (!ghost_.isPlaying() || ++frame_ % kFramesANumber == 0) presentNumbers();
  if (ghost_.isPlaying() == shows_pause_) return;
  shows_pause_ = ghost_.isPlaying();
  play_->setIcon(icon(shows_pause_ ? "pause" : "play", theme_));
  play_->setAccessibleName(shows_pause_ ? tr("Pause the ghost") : tr("Let the ghost go"));
}

void GhostStrip::presentNumbers() {
  const follow::State& state = ghost_.state();
  putText(time_, clockText(std::round(state.time_s)) + " / " + clockText(std::round(ghost_.ghost().way.duration_s())));
  putText(now_, state.tick_ns ? millimetres(kMillimetrePerMetre * state.distance_m) : QString());
  putText(told_, toldText(state, ghost_.options()));
  tell(last_, lastText(state));
  copy_->setVisible(state.last_round.has_value());
}

void GhostStrip::presentOptions() {
  const follow::Options& options = ghost_.options();
  const QSignalBlocker silent_speed(speed_), silent_wait(wait_), silent_near(near_), silent_loop(loop_),
      silent_mirror(mirror_),
      silent_beyond(beyond_);  // to show a value is not to ask for it
  speed_->setCurrentIndex(speed_->findData(options.speed));
  wait_->setChecked(options.waits);
  near_->setChecked(options.begins_near);
  loop_->setChecked(options.loops);
  mirror_->setChecked(ghost_.isMirrored());
  mirror_->setVisible(ghost_.isMirrored() || document_.isLeftHanded());
  beyond_->setValue(kMillimetrePerMetre * options.waits_beyond_m);
  presentNumbers();
}

void GhostStrip::presentNotes() {
  if (!ghost_.isOpen()) return;
  QStringList notes{jumpsText(ghost_.ghost().way.jumps)};
  if (ghost_.isElsewhere()) notes << elsewhereText(ghost_.ghost(), document_.scene().title);
  notes.removeAll(QString());
  tell(notes_, notes.join('\n'));
  scene_->setVisible(ghost_.isElsewhere());
}

void GhostStrip::sayResult() {
  copy_->setText(tr("Copy"));
  presentNumbers();
  told_->setAccessibleDescription(resultText(*ghost_.state().last_round));  // its name says what stands there
  QAccessibleEvent said(told_, QAccessible::Alert);
  QAccessible::updateAccessibility(&said);
}

void GhostStrip::setTheme(const Theme& theme) {
  theme_ = theme;
  play_->setIcon(icon(shows_pause_ ? "pause" : "play", theme));
  restart_->setIcon(icon("reset", theme));
}

}  // namespace underact::gui
