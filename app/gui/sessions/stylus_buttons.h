#pragma once
#include <array>
#include <cstdint>

#include "core/servo/snapshot.h"

namespace underact::gui {

inline constexpr int kStylusButtons = 2;  // bit 0: nearer to the tip

/// Which stylus buttons went down, tick by tick. A button that was up for less than 30 ms has bounced.
class ButtonEdges {
 public:
  /// Bits of the buttons that went down in this tick.
  unsigned add(const servo::TickRecord& record);

 private:
  struct Button {
    bool down = true;  // one that is held when we begin to look was not pressed for us
    std::int64_t up_since_ns = 0;
  };
  std::array<Button, kStylusButtons> buttons_;
};

/// What a press of a stylus button does.
enum class ButtonUse { Nothing, Record, Mark };

}  // namespace underact::gui
