#pragma once
#include <span>

namespace underact::lesson {

// What a step may ask of the window, by the names that the window has for it (a story holds them against it).

/// "front", ...: the actions view.NAME.
std::span<const char* const> cameraNames();
/// "ghosts", ...: the actions layer.NAME.
std::span<const char* const> layerNames();
/// "kinematics", ...: the actions dock.NAME.
std::span<const char* const> panelNames();

}  // namespace underact::lesson
