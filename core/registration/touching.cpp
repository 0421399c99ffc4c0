#include "core/registration/touching.h"

#include <algorithm>
#include <utility>

namespace underact::registration {

Touching::Touching(std::vector<Vec3> points_D) : marks_D_(std::move(points_D)), held_(marks_D_.size()) {}

Touching::Event Touching::add(std::int64_t time_ns, const Vec3& p_WT, bool pressed) {
  const bool goes_down = !std::exchange(was_pressed_, pressed) && pressed;
  Event event = Event::None;
  if (goes_down && !isHolding() && due_ < marks_D_.size()) {
    press();
    event = Event::Began;
  }
  const std::optional<HeldTip> held = still_.add(time_ns, p_WT);
  if (!held) return event;
  if (held->moved) return Event::Moved;
  held_[due_] = held;
  due_ = firstUntouched();
  return Event::Touched;
}

void Touching::press() {
  if (due_ < marks_D_.size() && !isHolding()) still_.begin();
}

void Touching::choose(std::size_t mark) {
  if (mark >= marks_D_.size()) return;
  still_.end();
  due_ = mark;
}

bool Touching::isDone() const {
  return firstUntouched() == held_.size() && due_ == held_.size();
}

std::vector<Touch> Touching::touches() const {
  std::vector<Touch> touches;
  for (std::size_t at = 0; at < held_.size(); ++at) {
    if (held_[at]) touches.push_back({marks_D_[at], held_[at]->p_WT, held_[at]->spread_m});
  }
  return touches;
}

std::size_t Touching::firstUntouched() const {
  const auto first = std::find(held_.begin(), held_.end(), std::nullopt);
  return static_cast<std::size_t>(first - held_.begin());
}

}  // namespace underact::registration
