#include <utility>

#include "app/gui/hands/hand_words.h"
#include "app/gui/hands/moving_hands.h"
#include "device/hands/learn.h"

namespace underact::gui {

namespace hands = device::hands;

constexpr int kGiveUp_ms = 15'000;

bool MovingHands::learn(const QString& id, const QString& field) {
  const HandEntry* const entry = find(id);
  const bool is_press = withField({}, field, 0).has_value(),
             is_way = withField({}, field + ".source", "nothing").has_value();
  if (entry == nullptr || (!is_press && !is_way)) return false;
  learning_ = Learning{id, field, entry->seen.readings, -1};
  gives_up_.start(kGiveUp_ms);
  emit changed();
  return true;
}

void MovingHands::endLearning() {
  if (!std::exchange(learning_, {})) return;
  gives_up_.stop();
  emit changed();
}

QString MovingHands::asked() const {
  if (!learning_) return {};
  for (std::size_t press = 0; press < hands::kPresses; ++press) {
    const auto which = static_cast<hands::Press>(press);
    if (learning_->field == hands::pressName(which))
      return tr("Press the button that is to be “%1”.").arg(pressTitle(which));
  }
  if (learning_->first >= 0) return tr("Now press the button for the other way.");
  for (std::size_t way = 0; way < hands::kWays; ++way) {
    const auto which = static_cast<hands::Way>(way);
    if (learning_->field == hands::wayName(which))
      return tr("Push the stick all the way, or press the button, that %1.").arg(wayGoal(which));
  }
  return {};
}

void MovingHands::learnFrom(const HandEntry& entry) {
  Learning& learning = *learning_;
  const hands::Readings now = entry.seen.readings;
  const QString id = learning.id, field = learning.field;
  const auto changeTo = [&](const std::optional<hands::Map>& map, bool fresh) {
    if (map) change(id, *map, field, fresh);
  };
  const bool is_press = withField({}, field, 0).has_value();
  const std::optional<int> button = hands::learnButton(learning.before, now);
  learning.before.pressed &= now.pressed;  // one that was let go may be pressed again
  if (is_press || learning.first >= 0) {
    if (!button || *button == learning.first) return;
    const hands::Source pair{hands::SourceKind::Buttons, learning.first, *button};
    const QString at = is_press ? field : field + ".source";
    const QVariant what = is_press ? QVariant(*button) : QVariant(QString::fromStdString(hands::sourceText(pair)));
    changeTo(withField(entry.map, at, what), is_press);
    return endLearning();
  }
  const std::optional<hands::Learnt> learnt = hands::learn(learning.before, now);
  if (!learnt) return;
  std::optional<hands::Map> map =
      withField(entry.map, field + ".source", QString::fromStdString(hands::sourceText(learnt->source)));
  if (map) map = withField(*map, field + ".inverted", learnt->inverted);
  changeTo(map, true);
  if (learnt->source.kind != hands::SourceKind::Buttons) return endLearning();
  learning.first = learnt->source.plus;
  learning.before.pressed = now.pressed;
  emit changed();
}

}  // namespace underact::gui
