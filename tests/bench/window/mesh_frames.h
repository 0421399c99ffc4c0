#pragma once
#include <string>

namespace underact::gui {

/// How long a frame of scenes 25 to 27 takes at 20 000 and 300 000 triangles, drawn coarser and whole, plain and cut
/// open where the stylus is, which moves all the time. Prints. source: the folder with scenes/.
void measureMeshFrames(const std::string& source);

}  // namespace underact::gui
