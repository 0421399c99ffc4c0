#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/sentence.h"
#include "core/base/task_monitor.h"
#include "core/base/types.h"

namespace underact::curve {

inline constexpr std::size_t kMaxPoints = 1'000'000;
/// The greatest number of problems reported for one file.
inline constexpr std::size_t kMaxProblems = 10;

/// The points of a text in their order, in its own unit and frame, before the scene's scale and pose. A line holds x, y
/// and z, separated by blanks, tabs, a comma or a semicolon, with decimal points whatever the locale; # begins a
/// comment; a first line without any number is taken for column names. Lines may end with LF, CR LF or CR. A point
/// equal to the one before it is left out; so are a colour behind each point, and the number of points before the
/// first. file: for the places of the problems. note: becomes what was left out so. Problems, each with its line: not
/// three finite numbers, more than kMaxPoints, another number of points; no point at all; cancelled. Any bytes are
/// allowed.
Result<std::vector<Vec3>> parsePoints(std::string_view text, const std::string& file, const TaskMonitor& monitor = {},
                                      Sentence* note = nullptr);

/// The text of a file of points, of at most 256 MiB. Problems: as json::readTextFile().
Result<std::string> readPointsText(const std::string& path);

/// parsePoints() of a file of at most 256 MiB.
Result<std::vector<Vec3>> readPoints(const std::string& path, const TaskMonitor& monitor = {});

}  // namespace underact::curve
