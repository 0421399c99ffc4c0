#include "app/gui/sessions/stylus_buttons.h"

namespace underact::gui {

constexpr std::int64_t kBounce_ns = 30'000'000;

unsigned ButtonEdges::add(const servo::TickRecord& record) {
  unsigned pressed = 0;
  for (unsigned number = 0; number < kStylusButtons; ++number) {
    Button& button = buttons_[number];
    const bool down = (record.buttons >> number & 1U) != 0;
    if (down && !button.down && record.time_ns - button.up_since_ns >= kBounce_ns) pressed |= 1U << number;
    if (!down && button.down) button.up_since_ns = record.time_ns;
    button.down = down;
  }
  return pressed;
}

}  // namespace underact::gui
