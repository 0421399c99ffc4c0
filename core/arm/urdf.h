#pragma once
#include <string>
#include <string_view>

#include "core/arm/model.h"

namespace underact::arm {

/// The largest file, bytes.
inline constexpr std::size_t kLargestUrdf = std::size_t{4} << 20;  // a humanoid with its sensors has some 100 kB

/// Whether an arm file with this text is URDF: it begins with an element.
bool isUrdfText(std::string_view text);

/// The serial chain between two links of a robot in the Unified Robot Description Format, from XML text that nobody has
/// checked. W is the frame of the base, the tip's frame that of the tip; joints between them that are fixed are no
/// joints, and links carry their masses and those of all that is fixed to them. It can lead up to a common parent and
/// down again. Problems, all at once, with their lines: not XML, a document type (none is read, and so no external
/// entity), a link or joint that does not fit, and on the way from base to tip a joint that moves otherwise than about
/// or along an axis, or follows another one. What was chosen and left out is in the model's notes.
Result<Model> readUrdf(std::string_view text, const std::string& file_name, const UrdfEnds& ends);

}  // namespace underact::arm
