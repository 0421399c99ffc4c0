#pragma once
#include <array>
#include <cstdint>

#include "core/servo/snapshot.h"

namespace underact::gui {

inline constexpr int kStylusButtons = 2;  // bit 0: nearer to the tip

/// Detects presses of the stylus buttons, tick by tick. A button that was up for less than 30 ms has bounced.
class ButtonEdges {
 public:
  /// Bits of the buttons pressed in this tick.
  unsigned add(const servo::TickRecord& record);

 private:
  struct Button {
    bool down = true;  // one that is held at the start does not count as pressed
    std::int64_t up_since_ns = 0;
  };
  std::array<Button, kStylusButtons> buttons_;
};

/// The action of a stylus button.
enum class ButtonUse { Nothing, Record, Mark };

}  // namespace underact::gui
