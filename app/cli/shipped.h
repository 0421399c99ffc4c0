#pragma once
#include <string>
#include <vector>

namespace underact::cli {

/// The files of the scenes that ship with the program, in teaching order: beside an installed program, in the source
/// tree that this one was built from, or where UNDERACT_DATA_DIR says. Empty: none were found.
std::vector<std::string> shippedScenes();

/// The same of the lessons.
std::vector<std::string> shippedLessons();

/// The folder of those scenes; empty: there is none.
std::string shippedSceneFolder();

}  // namespace underact::cli
