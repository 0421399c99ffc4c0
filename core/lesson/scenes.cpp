#include <set>
#include <type_traits>

#include "core/base/translate.h"
#include "core/lesson/read.h"
#include "core/scene/load_meshes.h"
#include "core/scene/read.h"

namespace underact::lesson {
namespace {

/// The quantities that a check measures.
std::set<const Quantity*> quantitiesOf(const Check& check) {
  std::set<const Quantity*> all;
  std::visit(
      [&all](const auto& task) {
        using Kind = std::decay_t<decltype(task)>;
        if constexpr (std::is_same_v<Kind, Hold>) {
          all.insert(task.wanted.measure.quantity);
        } else if constexpr (!std::is_same_v<Kind, AskChoice>) {
          all.insert(task.measure.quantity);
        }
      },
      check.task);
  for (const Criterion& wanted : check.meanwhile) all.insert(wanted.measure.quantity);
  all.erase(nullptr);  // a question whose answer is given
  return all;
}

/// The problems of a scene, each as a problem of the lesson.
Problems toldAt(const SourceLocation& place, const std::string& scene_key, const Problems& problems) {
  Problems told;
  for (const Problem& problem : problems) {
    SourceLocation at = place;
    at.key += "." + scene_key;
    told.push_back({phrase(TRANSLATE_NOOP("problem", "The scene has an error: %1"), {describe(problem)}), at});
  }
  return told;
}

}  // namespace

Problems checkScenes(const Lesson& lesson, const std::string& scene_folder) {
  Problems problems;
  for (std::size_t index = 0; index < lesson.steps.size(); ++index) {
    const Step& step = lesson.steps[index];
    Result<scene::Description> scene = scene::readSceneFile(sceneFileOf(lesson, index, scene_folder));
    const Result<tick::TickProgram> program =
        scene ? scene::loadAndCompile(scene.value()) : Result<tick::TickProgram>(scene.problems());
    if (!program) {
      const Problems told = toldAt(step.place, "scene", program.problems());
      if (!step.scene.empty()) problems.insert(problems.end(), told.begin(), told.end());
      continue;
    }
    for (const Check& check : step.checks) {
      for (const Quantity* const quantity : quantitiesOf(check)) {
        if (const Sentence why = missingReason(*quantity, scene.value()); !why.empty())
          problems.push_back({why, check.place});
      }
    }
  }
  return problems;
}

}  // namespace underact::lesson
