#include "app/gui/ghost/ghost_strip.h"

#include <QAccessible>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <array>
#include <cmath>

#include "app/gui/ghost/ghost_hand.h"
#include "app/gui/ghost/ghost_words.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/chooser.h"
#include "app/gui/kit/icons.h"
#include "app/gui/kit/larger_font.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/number_box.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/document.h"
#include "app/gui/model/session_words.h"
#include "core/base/units.h"

namespace underact::gui {
namespace {

constexpr std::array kSpeeds{0.1, 0.25, 0.5, 0.75, 1.0, 1.5, 2.0};
constexpr double kDistanceType = 1.7;
constexpr int kFramesANumber = 3;  // while playing: numbers that change more often cannot be read

QLabel* label(const char* name, const QString& spoken, QWidget* parent) {
  auto* made = new QLabel(parent);
  made->setObjectName(name);
  made->setAccessibleName(spoken);
  return made;
}

/// Shows the label only while it has a text.
void tell(QLabel* label, const QString& text) {
  updateText(label, text);
  if (label->isHidden() != text.isEmpty()) label->setVisible(!text.isEmpty());
}

}  // namespace

GhostStrip::GhostStrip(GhostHand& ghost, const Document& document, Actions& actions, QWidget* parent)
    : QWidget(parent), ghost_(ghost), document_(document), actions_(actions) {
  setObjectName("ghost");
  setAccessibleName(tr("Following a recorded hand"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 4, 12, 6);
  column->setSpacing(4);
  buildTransport(column);
  buildChoices(column);
  buildTold(column);
  hide();
  connect(&ghost, &GhostHand::opened, this, &QWidget::show);
  connect(&ghost, &GhostHand::closed, this, &QWidget::hide);
  connect(&ghost, &GhostHand::changed, this, [this] {
    presentOptions();
    presentNotes();
  });
  connect(&ghost, &GhostHand::ended, this, &GhostStrip::sayResult);
  connect(&document, &Document::opened, this, &GhostStrip::presentNotes);
  connect(&document, &Document::edited, this, &GhostStrip::presentNotes);
}

QCheckBox* GhostStrip::box(const char* name, const QString& words, const QString& tip) {
  auto* made = new QCheckBox(words, this);
  made->setObjectName(name);
  made->setAccessibleName(words);
  made->setToolTip(tip);
  connect(made, &QCheckBox::clicked, this, [this, name](bool on) { actions_.perform(name, on); });
  return made;
}

void GhostStrip::buildTransport(QVBoxLayout* column) {
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  row->addWidget(play_ = iconButton("ghost.play", actions_.find("ghost.play"), tr("Play the ghost"), this));
  row->addWidget(restart_ =
                     iconButton("ghost.restart", actions_.find("ghost.restart"), tr("From the beginning"), this));
  row->addWidget(time_ = label("ghost.time", tr("Time of the ghost"), this));
  speed_ = new QComboBox(this);
  speed_->setObjectName("ghost.speed");
  nameChooser(speed_, tr("Speed"), tr("Speed of the ghost, as a multiple of the recorded speed."));
  for (const double speed : kSpeeds) speed_->addItem(tr("%1 ×").arg(speed), speed);
  speed_->setFocusPolicy(Qt::StrongFocus);
  connect(speed_, &QComboBox::activated, this,
          [this](int index) { actions_.perform("ghost.speed", kSpeeds[static_cast<std::size_t>(index)]); });
  row->addWidget(speed_);
  row->addSpacing(4);
  row->addWidget(mirror_ =
                     box("ghost.mirror", tr("Mirrored"),
                         tr("Mirrors the ghost like the scenes for the left hand. Off: the hand as it was recorded.")));
  row->addStretch(1);
  now_ = label("ghost.now", tr("Distance to the ghost"), this);
  QFont large = larger(font(), kDistanceType);
  large.setBold(true);
  now_->setFont(large);
  now_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  now_->setMinimumWidth(QFontMetrics(large).horizontalAdvance("000.0 mm"));
  row->addWidget(now_);
  auto* close =
      pushButton("ghost.close", tr("Close"), actions_.find("ghost.close")->toolTip(), this, tr("Remove the ghost"));
  connect(close, &QPushButton::clicked, actions_.find("ghost.close"), &QAction::trigger);
  row->addWidget(close);
  column->addLayout(row);
}

void GhostStrip::buildChoices(QVBoxLayout* column) {
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  row->addWidget(wait_ = box("ghost.wait", tr("Wait for me beyond"),
                             tr("The ghost waits while you are farther away than this, and continues when you are "
                                "within half the distance.")));
  beyond_ = new NumberBox(this);
  beyond_->setObjectName("ghost.wait_beyond");
  beyond_->setAccessibleName(tr("Distance beyond which the ghost waits"));
  beyond_->setSuffix(tr(" mm"));
  beyond_->setDecimals(0);
  beyond_->setRange(1.0, 100.0);
  beyond_->setKeyboardTracking(false);  // not a half-typed number
  connect(beyond_, &QDoubleSpinBox::valueChanged, this,
          [this](double beyond_mm) { actions_.perform("ghost.wait_beyond", beyond_mm); });
  row->addWidget(beyond_);
  row->addWidget(
      near_ = box("ghost.near", tr("Wait at the start"), tr("The ghost waits at its beginning until you are there.")));
  row->addWidget(loop_ = box("ghost.loop", tr("Loop"),
                             tr("The ghost starts again at the end; each round is counted separately.")));
  row->addStretch(1);
  column->addLayout(row);
}

void GhostStrip::buildTold(QVBoxLayout* column) {
  auto* result = new QHBoxLayout;
  result->setSpacing(8);
  result->addWidget(told_ = messageLabel("ghost.told", tr("What to do, and your result"), "", this), 1);
  copy_ = pushButton("ghost.copy", tr("Copy"), tr("Copies the result of the last round to the clipboard."), this,
                     tr("Copy the result"));
  connect(copy_, &QPushButton::clicked, this, [this] {
    if (actions_.perform("ghost.copy")) copy_->setText(tr("Copied"));
  });
  told_->setMinimumHeight(copy_->sizeHint().height());  // nothing moves when it appears
  result->addWidget(copy_);
  column->addLayout(result);
  column->addWidget(last_ = messageLabel("ghost.last", tr("Previous round"), "quiet", this));
  auto* notes = new QHBoxLayout;
  notes->setSpacing(8);
  notes->addWidget(notes_ = messageLabel("ghost.notes", tr("About the recording"), "amber", this), 1);
  scene_ = pushButton("ghost.scene", tr("Open that scene"),
                      tr("Opens the scene of the recording in place of the current one."), this);
  connect(scene_, &QPushButton::clicked, this, [this] { actions_.perform("ghost.scene"); });
  notes->addWidget(scene_);
  column->addLayout(notes);
  for (QWidget* later : {static_cast<QWidget*>(last_), static_cast<QWidget*>(copy_), static_cast<QWidget*>(notes_),
                         static_cast<QWidget*>(scene_)})
    later->hide();
}

void GhostStrip::present(const servo::Snapshot&) {
  if (!ghost_.isOpen()) return;
  if (!ghost_.isPlaying() || ++frame_ % kFramesANumber == 0) presentNumbers();
  if (ghost_.isPlaying() == shows_pause_) return;
  shows_pause_ = ghost_.isPlaying();
  play_->setIcon(icon(shows_pause_ ? "pause" : "play", theme_));
  play_->setAccessibleName(shows_pause_ ? tr("Pause the ghost") : tr("Play the ghost"));
}

void GhostStrip::presentNumbers() {
  const ghost::State& state = ghost_.state();
  updateText(time_, clockText(std::round(state.time_s)) + " / " +
                        clockText(std::round(ghost_.ghost().trajectory.duration_s())));
  updateText(now_, state.tick_ns ? millimetres(kMillimetrePerMetre * state.distance_m) : QString());
  updateText(told_, toldText(state, ghost_.options()));
  tell(last_, lastText(state));
  copy_->setVisible(state.last_round.has_value());
}

void GhostStrip::presentOptions() {
  const ghost::Options& options = ghost_.options();
  const QSignalBlocker silent_speed(speed_), silent_wait(wait_), silent_near(near_), silent_loop(loop_),
      silent_mirror(mirror_),
      silent_beyond(beyond_);  // showing a value does not command it
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
  QStringList notes{jumpsText(ghost_.ghost().trajectory.jumps)};
  if (ghost_.isElsewhere()) notes << elsewhereText(ghost_.ghost(), document_.scene().title);
  notes.removeAll(QString());
  tell(notes_, notes.join('\n'));
  scene_->setVisible(ghost_.isElsewhere());
}

void GhostStrip::sayResult() {
  copy_->setText(tr("Copy"));
  presentNumbers();
  told_->setAccessibleDescription(resultText(*ghost_.state().last_round));  // the name says what the text is
  QAccessibleEvent alert(told_, QAccessible::Alert);
  QAccessible::updateAccessibility(&alert);
}

void GhostStrip::setTheme(const Theme& theme) {
  theme_ = theme;
  play_->setIcon(icon(shows_pause_ ? "pause" : "play", theme));
  restart_->setIcon(icon("reset", theme));
}

}  // namespace underact::gui
