#pragma once
#include <span>

namespace underact::lesson {

// What a step may ask of the window, by the names that the window uses (a test compares them).

/// "front", ...: the actions view.NAME.
std::span<const char* const> cameraNames();
/// "ghosts", ...: the actions layer.NAME.
std::span<const char* const> layerNames();
/// "kinematics", ...: the actions dock.NAME.
std::span<const char* const> panelNames();

}  // namespace underact::lesson
