// What the editor does; how it is put together is in map_editor_build.cpp.
#include "app/gui/hands/map_editor.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>

#include "app/gui/hands/axis_bar.h"
#include "app/gui/hands/hand_words.h"
#include "app/gui/hands/moving_hands.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/value_row.h"
#include "app/gui/kit/words.h"
#include "core/base/units.h"
#include "device/hands/map_file.h"

namespace underact::gui {

namespace hands = device::hands;

void MapEditor::setDevice(const QString& id) {
  if (id == id_) return;
  id_ = id;
  rebuild();
}

void MapEditor::setTheme(const Theme& theme) {
  for (AxisBar* bar : bars_) bar->setTheme(theme);
}

const HandEntry* MapEditor::entry() const {
  return hands_.find(id_);
}

QString MapEditor::field(const char* part) const {
  return QString("%1.%2").arg(hands::wayName(static_cast<hands::Way>(way_)), part);
}

void MapEditor::set(const QString& field, const QVariant& value, bool fresh) {
  actions_.perform("hands.set", field, value, fresh);
}

/// Pressed once more it ends.
void MapEditor::learn(const QString& field) {
  if (hands_.learning() == field)
    hands_.endLearning();
  else
    actions_.perform("hands.learn", field);
}

void MapEditor::chooseWay(std::size_t way) {
  way_ = way;
  hands_.endLearning();
  rebuild();
}

void MapEditor::rebuild() {
  const HandEntry* const now = entry();
  setVisible(now != nullptr && now->seen.missing.empty());
  if (now == nullptr) return;
  title_->setText(tr("What moves what: %1").arg(sentenceText(now->seen.name)));
  ways_[way_]->setChecked(true);
  way_title_->setText(wayTitle(static_cast<hands::Way>(way_)));
  fillSources(*now);
  fillButtons(*now);
  const hands::AxisMap &map = now->map.ways[way_], &usual = now->seen.usual.ways[way_];
  const bool turns = way_ >= hands::kMoves;
  inverted_->setChecked(map.inverted);
  zone_->present(100.0 * map.dead_zone, 100.0 * usual.dead_zone);
  fine_->present(map.exponent - 1.0, usual.exponent - 1.0);
  speed_->setVisible(!turns);
  turn_speed_->setVisible(turns);
  if (turns)
    turn_speed_->present(map.top / kRadPerDegree, usual.top / kRadPerDegree);
  else
    speed_->present(map.top * kMillimetrePerMetre, usual.top * kMillimetrePerMetre);
  undo_->setEnabled(hands_.undoStack().canUndo());
  redo_->setEnabled(hands_.undoStack().canRedo());
  reset_->setEnabled(!(now->map == now->seen.usual));
  presentLearning();
}

void MapEditor::fillSources(const HandEntry& now) {
  const QSignalBlocker quiet(source_);
  const hands::Source& current = now.map.ways[way_].source;
  source_->clear();
  for (const hands::Source& source : sourcesFor(now.seen, current))
    source_->addItem(sourceTitle(now.seen, source), QString::fromStdString(hands::sourceText(source)));
  source_->setCurrentIndex(source_->findData(QString::fromStdString(hands::sourceText(current))));
}

void MapEditor::fillButtons(const HandEntry& now) {
  for (std::size_t press = 0; press < hands::kPresses; ++press) {
    QComboBox* const box = presses_[press];
    const QSignalBlocker quiet(box);
    box->clear();
    const int buttons = std::max(std::min(now.seen.readings.buttons, hands::kMostButtons), now.map.presses[press] + 1);
    for (int button = -1; button < buttons; ++button) {
      const auto index = static_cast<std::size_t>(std::max(button, 0));
      const auto& names = now.seen.button_names;
      const bool is_none = button >= 0 && index < names.size() && names[index].empty();
      if (!is_none || button == now.map.presses[press]) box->addItem(buttonText(now.seen, button), button);
    }
    box->setCurrentIndex(box->findData(now.map.presses[press]));
  }
}

void MapEditor::presentLearning() {
  const QString learning = hands_.learning();
  asked_->setText(hands_.asked());
  asked_->setVisible(!learning.isEmpty());
  learn_->setText(learning == hands::wayName(static_cast<hands::Way>(way_)) ? tr("Cancel") : tr("Learn…"));
  for (std::size_t press = 0; press < hands::kPresses; ++press)
    press_learns_[press]->setText(learning == hands::pressName(static_cast<hands::Press>(press)) ? tr("Cancel")
                                                                                                 : tr("Learn…"));
}

void MapEditor::present() {
  const HandEntry* const now = entry();
  if (now == nullptr) return;
  for (std::size_t way = 0; way < hands::kWays; ++way) {
    const hands::AxisMap& map = now->map.ways[way];
    const double moved = hands::deflection(map.source, now->seen.readings);
    bars_[way]->present(map.inverted ? -moved : moved, hands::share(map, now->seen.readings), map.dead_zone);
  }
}

}  // namespace underact::gui
