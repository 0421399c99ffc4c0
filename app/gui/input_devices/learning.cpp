#include "app/gui/input_devices/learning.h"

#include "app/gui/input_devices/input_words.h"
#include "app/gui/kit/words.h"
#include "device/input/learn.h"
#include "device/input/map_file.h"

namespace underact::gui {

namespace input = device::input;

namespace {

bool isPress(const QString& field) {
  return withField({}, field, 0).has_value();
}

}  // namespace

std::optional<Learning> Learning::of(const QString& id, const QString& field, const input::Readings& before) {
  const bool is_motion = withField({}, field + ".source", "nothing").has_value();
  return isPress(field) || is_motion ? std::optional(Learning(id, field, before)) : std::nullopt;
}

QString Learning::asked() const {
  for (std::size_t press = 0; press < input::kPresses; ++press) {
    const auto which = static_cast<input::ButtonRole>(press);
    if (field_ == input::pressName(which)) return tr("Press the button for “%1”.").arg(pressTitle(which));
  }
  if (first_ >= 0) return tr("Now press the button for the opposite direction.");
  for (std::size_t motion = 0; motion < input::kMotionAxes; ++motion) {
    const auto which = static_cast<input::MotionAxis>(motion);
    if (field_ == input::motionAxisName(which))
      return tr("Push the stick fully, or press the button, that %1.").arg(motionAxisPrompt(which));
  }
  return {};
}

std::optional<Learning::Step> Learning::take(const input::Map& map, const input::Readings& now) {
  const bool is_press = isPress(field_);
  const std::optional<int> button = input::learnButton(before_, now);
  before_.pressed &= now.pressed;  // a released button may be pressed again
  if (is_press || first_ >= 0) {
    if (!button || *button == first_) return {};
    if (is_press) return Step{withField(map, field_, *button)};
    const input::Source pair{input::SourceKind::Buttons, first_, *button};
    return Step{withField(map, field_ + ".source", QString::fromStdString(input::sourceText(pair))), false};
  }
  const std::optional<input::Learnt> learnt = input::learn(before_, now);
  if (!learnt) return {};
  Step step{withField(map, field_ + ".source", QString::fromStdString(input::sourceText(learnt->source)))};
  if (step.map) step.map = withField(*step.map, field_ + ".inverted", learnt->inverted);
  if (learnt->source.kind == input::SourceKind::Buttons) {
    first_ = learnt->source.plus;
    before_.pressed = now.pressed;
    step.is_last = false;
  }
  return step;
}

}  // namespace underact::gui
