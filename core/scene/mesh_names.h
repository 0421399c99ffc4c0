#pragma once
#include <filesystem>
#include <string>

#include "core/scene/description.h"

namespace underact::scene {

/// A file name of another system as this one has it: file://, ~/ and backslashes replaced, no blanks at its end; but a
/// name of which there is a file from the folder stays.
std::string plainName(const std::filesystem::path& folder, std::string name);

/// The path of the file that a name means, from a folder: that of its plainName(), if there is one; else of the only
/// file in the folder or below whose name differs in capital letters alone, or in accents of one character or two, as
/// in names from a Mac; else as written. Elsewhere it does not look: what exists there is nobody's business.
std::string fileMeant(const std::filesystem::path& folder, const std::string& name);

/// The problems of a file of a scene; where there is no such file, with the nearest name there.
Problems withNearest(Problems problems, const std::string& name, const Description& scene);

/// The scene as it is written to file, an absolute path: meshes, curves and the file of its arm are named relative to
/// it, so that both can be moved together; by an absolute path where they are in an unrelated folder, or on another
/// disk.
Description namedFrom(Description scene, const std::string& file);

}  // namespace underact::scene
