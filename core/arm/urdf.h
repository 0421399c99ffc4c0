#pragma once
#include <string>
#include <string_view>

#include "core/arm/model.h"

namespace underact::arm {

/// The two links of a robot between which the arm lies. Empty: its root, and the one link that has no children.
struct UrdfEnds {
  std::string base;
  std::string tip;
};

/// Whether a file of that name is read as URDF: it ends in .urdf or .xml.
bool isUrdfName(std::string_view path);

/// The serial chain between two links of a robot in the Unified Robot Description Format, from XML text that nobody has
/// checked. W is the frame of the base, the tip's frame that of the tip; joints between them that are fixed are no
/// joints, and links carry their masses. It can lead up to a common parent and down again. Problems, all at once, with
/// their lines: not XML, a document type (none is read, and so no external entity), a link or joint that does not fit,
/// and on the way from base to tip a joint that moves otherwise than about or along an axis, or follows another one.
Result<Model> readUrdf(std::string_view text, const std::string& file_name, const UrdfEnds& ends);
/// The same of a file of at most 4 MiB. Problems, too: it cannot be read.
Result<Model> readUrdfFile(const std::string& path, const UrdfEnds& ends);

}  // namespace underact::arm
