#include "core/lesson/window_names.h"

#include <vector>

#include "core/lesson/layers.h"

namespace underact::lesson {

std::span<const char* const> cameraNames() {
  static constexpr const char* kAll[] = {"front", "top", "side", "isometric", "left", "back", "bottom"};
  return kAll;
}

std::span<const char* const> layerNames() {
  static const std::vector<const char*> kAll = [] {
    std::vector<const char*> names;
    for (const Layer& layer : layers()) names.push_back(layer.name);
    return names;
  }();
  return kAll;
}

std::span<const char* const> panelNames() {
  static constexpr const char* kAll[] = {
      "scenes", "feel", "shape",   "arm",         "plots",    "kinematics", "robot",   "servo", "second",   "hands",
      "step",   "lab",  "devices", "calibration", "sessions", "session",    "lessons", "dh",    "transform"};
  return kAll;
}

}  // namespace underact::lesson
