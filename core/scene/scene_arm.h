#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "core/arm/model.h"
#include "core/base/result.h"
#include "core/scene/description.h"

namespace underact::scene {

// Which arm a scene has: one that ships with the program, by its name, or one from a file. All others ask here.

/// An arm from a file, as it was read.
struct ArmFile {
  std::string text;  // of the file, byte for byte
  arm::Model model;
  arm::Preset preset;
};

/// The largest arm file that a scene takes.
inline constexpr std::size_t kLargestArmFile = std::size_t{1} << 20;

/// Whether a scene's "arm" is the name of a file: it has a dot or a slash.
bool isArmFile(std::string_view arm);

/// Whether files that a scene names may be opened: not where the scene is from a recording, which holds what they said.
enum class NamedFiles : std::uint8_t { Open, Closed };

/// Reads the arm of a scene that names a file: from scene.arm_text where there is one, else from the file, relative to
/// the folder of the scene's own file. Without effect on others. Problems: those of arm::readArmFile(), each with its
/// line in that file; an arm that is no haptic device; text without a file's name; no text, and files are closed. Those
/// of the scene itself have its key and no line.
Problems readSceneArm(Description& scene, NamedFiles files = NamedFiles::Open);

/// The arm of a scene; null where its name is not known, or its file was not read.
const arm::Preset* findArm(const Description& scene);
/// The arm of the scene; the default one where it names none. It lives as long as the scene and its copies.
const arm::Preset& armOf(const Description& scene);
/// The arm as in its file, with masses and the names of its joints.
const arm::Model& modelOf(const Description& scene);

/// Whether the arm's motors render the moment that virtual robots with an orientation ask for; none: none does.
std::optional<bool> rendersMoment(const Description& scene);

/// The content of the file of the scene's arm; empty where there is no such arm. It lives as armOf().
std::string_view armTextOf(const Description& scene);

/// Whether both scenes have the same arm, whatever the name of its file.
bool haveSameArm(const Description& a, const Description& b);

/// The scene with the arm of another one.
Description withArmOf(const Description& other, Description scene);

}  // namespace underact::scene
