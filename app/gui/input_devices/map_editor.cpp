#include "app/gui/input_devices/map_editor.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/gui/input_devices/axis_bar.h"
#include "app/gui/input_devices/input_devices.h"
#include "app/gui/input_devices/input_words.h"
#include "app/gui/input_devices/press_rows.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/chooser.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/kit/tight_layout.h"
#include "app/gui/kit/value_row.h"
#include "app/gui/kit/words.h"
#include "core/base/units.h"
#include "device/input/map_file.h"

namespace underact::gui {

namespace input = device::input;

namespace {

QString markText() {
  return MapEditor::tr("The mark shows the default value. Double-click to restore it.");
}

}  // namespace

MapEditor::MapEditor(InputDevices& hands, Actions& actions, QWidget* parent)
    : QWidget(parent), hands_(hands), actions_(actions), title_(sectionTitle({}, this)) {
  setObjectName("panel.hands.editor");
  setAccessibleName(tr("Mapping"));
  auto* column = tight<QVBoxLayout>(this, 8);
  title_->setWordWrap(true);
  column->addWidget(title_);
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(4);
  buildMotionAxes(grid);
  column->addLayout(grid);
  column->addWidget(buildOne());
  column->addWidget(asked_ = messageLabel("panel.hands.asked", tr("What to do now"), "amber", this));
  column->addWidget(presses_ = new PressRows(this));
  column->addWidget(buildFoot());
  connect(presses_, &PressRows::chosen, this,
          [this](const QString& field, const QVariant& button) { set(field, button); });
  connect(presses_, &PressRows::learnAsked, this, &MapEditor::learn);
}

void MapEditor::buildMotionAxes(QGridLayout* grid) {
  auto* group = new QButtonGroup(this);
  for (std::size_t motion = 0; motion < input::kMotionAxes; ++motion) {
    const QString title = motionAxisTitle(static_cast<input::MotionAxis>(motion)),
                  name = input::motionAxisName(static_cast<input::MotionAxis>(motion));
    auto* button = new QToolButton(this);
    button->setObjectName("panel.hands.way." + name);
    button->setText(title);
    button->setAccessibleName(title);
    button->setToolTip(tr("Shows what %1.").arg(motionAxisPrompt(static_cast<input::MotionAxis>(motion))));
    button->setCheckable(true);
    button->setProperty("role", "choice");
    button->setFocusPolicy(Qt::StrongFocus);
    button->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);
    group->addButton(button);
    motions_[motion] = button;
    bars_[motion] = new AxisBar("panel.hands.bar." + name, title, this);
    const int row = static_cast<int>(motion);
    grid->addWidget(button, row, 0);
    grid->addWidget(bars_[motion], row, 1);
    connect(button, &QToolButton::clicked, this, [this, motion] { chooseMotionAxis(motion); });
  }
  grid->setColumnStretch(1, 1);
}

QWidget* MapEditor::buildOne() {
  auto* box = new QWidget(this);
  auto* column = tight<QVBoxLayout>(box, 4);
  column->addWidget(motion_title_ = sectionTitle({}, box));
  source_ = chooser("panel.hands.source", tr("Moved by"), tr("The stick, buttons or triggers for this motion."), box);
  learn_ = pushButton("panel.hands.learn", tr("Learn…"), tr("Assigns the stick or button that you use next."), box);
  inverted_ = new QCheckBox(tr("Inverted"), box);
  inverted_->setObjectName("panel.hands.inverted");
  inverted_->setAccessibleName(tr("Inverted"));
  inverted_->setToolTip(tr("Right becomes left, up becomes down."));
  auto* line = new QHBoxLayout;
  line->setSpacing(8);
  line->addWidget(source_, 1);
  line->addWidget(learn_);
  column->addLayout(line);
  column->addWidget(inverted_);
  const QString widest = tr("Dead zone");
  const auto row = [&](const char* name, const QString& title, ValueKind kind) {
    kind.mark = markText();
    auto* made = new ValueRow(kind, QString("panel.hands.") + name, box);
    made->setLabel(title, title, widest);
    column->addWidget(made);
    return made;
  };
  zone_ =
      row("dead_zone", tr("Dead zone"), {tr("Share of the stick's travel that has no effect."), "%", 1, 50, 0, 90.0});
  fine_ = row("fine", tr("Fine"),
              {tr("How fine the motion is near the centre: the speed grows with the deflection to the power of 1 + "
                  "this value. 0: linear."),
               "", 10, 30, 1, input::kFinest - 1.0});
  speed_ = row("speed", tr("Speed"),
               {tr("Speed of the tip at full deflection."), tr("mm/s"), 1, 300, 0,
                input::kFastest_m_per_s * kMillimetrePerMetre});
  turn_speed_ = row(
      "turn_speed", tr("Speed"),
      {tr("Rotational speed at full deflection."), tr("°/s"), 1, 180, 0, input::kFastest_rad_per_s / kRadPerDegree});
  connect(source_, &QComboBox::activated, this, [this] { set(field("source"), source_->currentData()); });
  connect(learn_, &QPushButton::clicked, this,
          [this] { learn(input::motionAxisName(static_cast<input::MotionAxis>(motion_))); });
  connect(inverted_, &QCheckBox::clicked, this, [this](bool on) { set(field("inverted"), on); });
  connect(zone_, &ValueRow::changed, this, [this](double v, bool fresh) { set(field("dead_zone"), v / 100.0, fresh); });
  connect(fine_, &ValueRow::changed, this, [this](double v, bool fresh) { set(field("exponent"), v + 1.0, fresh); });
  connect(speed_, &ValueRow::changed, this,
          [this](double v, bool fresh) { set(field("top"), v * kMetrePerMillimetre, fresh); });
  connect(turn_speed_, &ValueRow::changed, this,
          [this](double v, bool fresh) { set(field("top"), v * kRadPerDegree, fresh); });
  return box;
}

QWidget* MapEditor::buildFoot() {
  auto* box = new QWidget(this);
  auto* line = tight<QHBoxLayout>(box, 8);
  const auto button = [&](const char* name, const QString& text, const QString& tip) {
    auto* made = pushButton(QString("panel.hands.") + name, text, tip, box);
    connect(made, &QPushButton::clicked, this, [this, name] { actions_.perform(QString("hands.") + name); });
    line->addWidget(made);
    return made;
  };
  undo_ = button("undo", tr("Undo"), tr("Undoes the last change to a mapping."));
  redo_ = button("redo", tr("Redo"), tr("Redoes the change that was undone."));
  reset_ = button("reset", tr("Defaults"), tr("Resets this device to its default mapping."));
  line->addStretch(1);
  return box;
}

void MapEditor::setDevice(const QString& id) {
  if (id == id_) return;
  id_ = id;
  rebuild();
}

void MapEditor::setTheme(const Theme& theme) {
  for (AxisBar* bar : bars_) bar->setTheme(theme);
}

const InputDeviceEntry* MapEditor::entry() const {
  return hands_.find(id_);
}

QString MapEditor::field(const char* part) const {
  return QString("%1.%2").arg(input::motionAxisName(static_cast<input::MotionAxis>(motion_)), part);
}

void MapEditor::set(const QString& field, const QVariant& value, bool fresh) {
  actions_.perform("hands.set", field, value, fresh);
}

/// Starts learning a field; ends it if pressed again.
void MapEditor::learn(const QString& field) {
  if (hands_.learning() == field)
    hands_.endLearning();
  else
    actions_.perform("hands.learn", field);
}

void MapEditor::chooseMotionAxis(std::size_t motion) {
  motion_ = motion;
  hands_.endLearning();
  rebuild();
}

void MapEditor::rebuild() {
  const InputDeviceEntry* const now = entry();
  setVisible(now != nullptr && now->seen.missing.empty());
  if (now == nullptr) return;
  title_->setText(tr("Mapping of %1").arg(sentenceText(now->seen.name)));
  motions_[motion_]->setChecked(true);
  motion_title_->setText(motionAxisTitle(static_cast<input::MotionAxis>(motion_)));
  fillSources(*now);
  presses_->present(*now);
  const input::AxisMap &map = now->map.motions[motion_], &default_value = now->seen.default_value.motions[motion_];
  const bool turns = motion_ >= input::kMoves;
  inverted_->setChecked(map.inverted);
  zone_->present(100.0 * map.dead_zone, 100.0 * default_value.dead_zone);
  fine_->present(map.exponent - 1.0, default_value.exponent - 1.0);
  speed_->setVisible(!turns);
  turn_speed_->setVisible(turns);
  if (turns)
    turn_speed_->present(map.top / kRadPerDegree, default_value.top / kRadPerDegree);
  else
    speed_->present(map.top * kMillimetrePerMetre, default_value.top * kMillimetrePerMetre);
  undo_->setEnabled(hands_.undoStack().canUndo());
  redo_->setEnabled(hands_.undoStack().canRedo());
  reset_->setEnabled(!(now->map == now->seen.default_value));
  presentLearning();
}

void MapEditor::fillSources(const InputDeviceEntry& now) {
  const QSignalBlocker quiet(source_);
  const input::Source& current = now.map.motions[motion_].source;
  source_->clear();
  for (const input::Source& source : sourcesFor(now.seen, current))
    source_->addItem(sourceTitle(now.seen, source), QString::fromStdString(input::sourceText(source)));
  source_->setCurrentIndex(source_->findData(QString::fromStdString(input::sourceText(current))));
}

void MapEditor::presentLearning() {
  const QString learning = hands_.learning();
  showMessage(asked_, hands_.asked());
  learn_->setText(learning == input::motionAxisName(static_cast<input::MotionAxis>(motion_)) ? tr("Cancel")
                                                                                             : tr("Learn…"));
  presses_->presentLearning(learning);
}

void MapEditor::present() {
  const InputDeviceEntry* const now = entry();
  if (now == nullptr) return;
  for (std::size_t motion = 0; motion < input::kMotionAxes; ++motion) {
    const input::AxisMap& map = now->map.motions[motion];
    const double moved = input::deflection(map.source, now->seen.readings);
    bars_[motion]->present(map.inverted ? -moved : moved, input::share(map, now->seen.readings), map.dead_zone);
  }
}

}  // namespace underact::gui
