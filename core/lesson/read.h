#pragma once
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/lesson/lesson.h"

namespace underact::lesson {

/// A lesson from JSON text: every problem at once, each with line, column and key. file_name: for the places. Unknown
/// keys are problems (with the nearest known key suggested). What the lesson's scenes have is not looked at, see
/// checkScenes().
Result<Lesson> readLesson(std::string_view text, const std::string& file_name);

/// The same from a file; one that cannot be read is a problem with line 0.
Result<Lesson> readLessonFile(const std::string& path);

/// Whether the text of a JSON file is meant as a lesson, right or wrong.
bool looksLikeLesson(std::string_view text);

/// The scenes that the steps name: that they are there, are right, and have what the checks measure; each problem at
/// its place in the lesson. scene_folder: of the scenes that ship. Empty: all is well.
Problems checkScenes(const Lesson& lesson, const std::string& scene_folder);

inline constexpr std::size_t kMostSteps = 50, kMostChecks = 20, kMostPlaces = 50;

}  // namespace underact::lesson
