#include "core/lesson/window_names.h"

namespace underact::lesson {

std::span<const char* const> cameraNames() {
  static constexpr const char* kAll[] = {"front", "top", "side", "isometric", "left", "back", "bottom"};
  return kAll;
}

std::span<const char* const> layerNames() {
  static constexpr const char* kAll[] = {"workspace",        "triads",         "arm",   "target",  "force",
                                         "influence",        "robot",          "path",  "desk",    "from_desk",
                                         "link_frames",      "ghosts",         "wires", "section", "section_follows",
                                         "motion_ellipsoid", "force_ellipsoid"};
  return kAll;
}

std::span<const char* const> panelNames() {
  static constexpr const char* kAll[] = {
      "scenes", "feel", "shape",   "arm",         "plots",    "kinematics", "robot",   "servo", "second",   "hands",
      "step",   "lab",  "devices", "calibration", "sessions", "session",    "lessons", "dh",    "transform"};
  return kAll;
}

}  // namespace underact::lesson
