#include "app/gui/visitor/carousel.h"

namespace underact::gui {

Carousel::Step Carousel::at(double time_s, bool touched) {
  if (touched) {
    touched_s_ = time_s;
    has_visitor_ = true;
  }
  if (has_visitor_ && time_s - touched_s_ >= kAlone_s) {
    has_visitor_ = false;
    return Step::Reset;
  }
  return time_s - scene_s_ >= dwell_s_ ? Step::Next : Step::Stay;
}

}  // namespace underact::gui
