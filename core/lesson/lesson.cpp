#include "core/lesson/lesson.h"

#include <algorithm>
#include <filesystem>

namespace underact::lesson {

std::string sceneFileOf(const Lesson& lesson, std::size_t step, const std::string& scene_folder) {
  while (step > 0 && lesson.steps[step].scene.empty()) --step;
  const std::filesystem::path scene(lesson.steps[step].scene);
  if (scene.extension() != ".json") return (std::filesystem::path(scene_folder) / (scene.string() + ".json")).string();
  if (scene.is_absolute()) return scene.string();
  return (std::filesystem::path(lesson.file).parent_path() / scene).lexically_normal().string();
}

bool namesShippedScene(const Lesson& lesson) {
  return std::any_of(lesson.steps.begin(), lesson.steps.end(), [](const Step& step) {
    return !step.scene.empty() && std::filesystem::path(step.scene).extension() != ".json";
  });
}

const std::string* questionOf(const Check& check) {
  if (const auto* number = std::get_if<AskNumber>(&check.task)) return &number->question;
  if (const auto* choice = std::get_if<AskChoice>(&check.task)) return &choice->question;
  return nullptr;
}

}  // namespace underact::lesson
