#pragma once
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/lesson/lesson.h"

namespace underact::lesson {

/// A lesson from JSON text. Problems: all at once, each with line, column and key; unknown keys are problems, with the
/// nearest known key suggested. file_name: for the places. The scenes themselves are not read, see checkScenes().
Result<Lesson> readLesson(std::string_view text, const std::string& file_name);

/// Reads a lesson from a file; one that cannot be read is a problem with line 0.
Result<Lesson> readLessonFile(const std::string& path);

/// Checks that the scenes named by the steps exist, are valid, and have what the checks measure; each problem at its
/// place in the lesson. scene_folder: of the scenes that ship with the program. Empty: no problem.
Problems checkScenes(const Lesson& lesson, const std::string& scene_folder);

inline constexpr std::size_t kMaxSteps = 50, kMaxChecks = 20, kMaxPlaces = 50;

}  // namespace underact::lesson
