#pragma once
#include <functional>

namespace underact::gui {

/// Starts the program once more, as it was started. Stories put something else there.
std::function<void()>& programStarter();

}  // namespace underact::gui
