#pragma once
#include <string>

namespace underact::gui {

/// Draws the 3D view of a scene file into a PNG. Problems go to stderr. Gives the exit status: 0, 1 (a bad scene), 4 (a
/// file that cannot be read or written).
int drawPicture(const std::string& scene_file, const std::string& out);

}  // namespace underact::gui
