#include "app/cli/scene_file.h"

#include <algorithm>
#include <ostream>
#include <utility>

#include "core/scene/compile.h"
#include "core/scene/read.h"

namespace underact::cli {

Result<LoadedScene> loadScene(const std::string& path) {
  Result<scene::Description> description = scene::readSceneFile(path);
  if (!description) return description.problems();
  Result<tick::TickProgram> program = scene::compile(description.value());
  if (!program) return program.problems();
  return LoadedScene{std::move(description).value(), std::move(program).value()};
}

void print(const Problems& problems, std::ostream& stream) {
  for (const Problem& problem : problems) stream << describe(problem) << '\n';
}

Exit exitOf(const Problems& problems) {
  const bool unread =
      std::any_of(problems.begin(), problems.end(), [](const Problem& problem) { return problem.place.line == 0; });
  return unread ? Exit::File : Exit::BadInput;
}

}  // namespace underact::cli
