#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "core/json/words.h"

namespace underact::scene {

/// The part of a course that a scene belongs to, in this order.
enum class Group : std::uint8_t { Shapes, Walls, Orientation, Robots, Meshes, Curves, Stability, Arms };

inline constexpr json::Word<Group> kGroupWords[] = {{"shapes", Group::Shapes},           {"walls", Group::Walls},
                                                    {"orientation", Group::Orientation}, {"robots", Group::Robots},
                                                    {"meshes", Group::Meshes},           {"curves", Group::Curves},
                                                    {"stability", Group::Stability},     {"arms", Group::Arms}};

/// Text for a class about a scene, in Markdown with formulas between dollars. It does not affect the simulation, so it
/// is not part of the Description, and edits and recordings leave it out.
struct Teaching {
  Group group = Group::Shapes;
  std::string feel, try_this, equation;
  bool operator==(const Teaching&) const = default;
};

/// "teach" of the text of a scene; none where it is missing or cannot be read (readScene() says why).
std::optional<Teaching> teachingIn(std::string_view text);
/// Reads the texts of a scene file.
std::optional<Teaching> teachingOf(const std::string& path);

}  // namespace underact::scene
