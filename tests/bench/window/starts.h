#pragma once

namespace underact::gui {

/// Starts the program again and again with one scene, and prints when its first picture was there, how much of the
/// processor that took, and what is resident when the plots have run for some seconds: medians and extremes.
void measureStarts();

}  // namespace underact::gui
