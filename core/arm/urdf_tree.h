#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/arm/model.h"

namespace underact::arm {

// Inside the room: what a URDF file says of its links and joints, before any of it is put together.

/// A link, with its mass in its own frame.
struct UrdfLink {
  std::string name;
  int line = 0;
  std::optional<LinkMass> mass;
  std::vector<LinkSolid> solids;  // in the link's frame
  Problems notes = {};            // of its pictures: those that cannot be drawn
};

/// How a joint moves; Other: in a way that no arm here has.
enum class UrdfMotion { Fixed, Turns, Slides, Other };

/// A joint, with its frame in that of its parent.
struct UrdfJoint {
  std::string name, type, parent, child;
  int line = 0;
  UrdfMotion motion = UrdfMotion::Fixed;
  bool follows = false;  // it mimics another one
  Pose X_ParentJoint = Pose::Identity();
  Vec3 axis = Vec3::UnitX();
  double min = -kInfinity, max = kInfinity;
  int limit_line = 0;         // of <limit>
  bool lacks_limits = false;  // it states neither end, or 0 for both, as exporters do that know none
};

/// Robot, links and joints in the order of the file.
struct UrdfTree {
  std::string name;
  std::vector<UrdfLink> links;
  std::vector<UrdfJoint> joints;
  Problems notes = {};
};

/// Problems: not XML (of at most 100 levels), no robot, numbers that are none, names that are missing or appear twice,
/// words that are misspelt; a version, or an attribute of what moves a link, that is not known. Other elements and
/// attributes are skipped. Not yet whether the links exist, or whether limits leave a range.
Result<UrdfTree> readUrdfTree(std::string_view text, const std::string& file_name);

}  // namespace underact::arm
