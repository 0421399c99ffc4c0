#pragma once
#include <string>
#include <vector>

#include "core/base/result.h"

namespace underact::cli {

/// The files of the scenes that ship with the program, in teaching order. Problem: none were found, with the places
/// that were searched.
Result<std::vector<std::string>> shippedScenes();

/// Likewise, of the lessons.
Result<std::vector<std::string>> shippedLessons();

}  // namespace underact::cli
