#include "app/cli/scene_file.h"

#include <algorithm>
#include <ostream>
#include <utility>

#include "app/cli/progress.h"
#include "core/base/printed.h"
#include "core/scene/load_meshes.h"
#include "core/scene/mesh_notes.h"
#include "core/scene/read.h"
#include "core/system/resource_paths.h"

namespace underact::cli {

Result<LoadedScene> loadScene(const std::string& path, const Streams& streams) {
  Result<scene::Description> description = scene::readSceneFile(path);
  if (!description) return description.problems();
  Progress progress(streams);
  TaskMonitor monitor;
  monitor.progress = [&progress](const char*, double share) { progress.show(share); };
  Result<tick::TickProgram> program = scene::loadAndCompile(description.value(), monitor);
  if (!program) return program.problems();
  return LoadedScene{std::move(description).value(), std::move(program).value()};
}

std::vector<std::string> recordedFilesFolders(std::vector<std::string> given) {
  const Result<std::string> shipped = system::findResource(system::Resource::Scenes);
  if (shipped) given.push_back(shipped.value());
  return given;
}

void print(const Problems& problems, std::ostream& stream) {
  for (const Problem& problem : problems) stream << describe(problem) << '\n';
}

void printNotes(const LoadedScene& scene, std::ostream& stream) {
  printNotes(scene::meshNotes(scene.description), stream);
}

void printNotes(const Problems& notes, std::ostream& stream) {
  for (const Problem& note : notes)
    stream << printed(note.place.file) << ':' << note.place.line << ':' << note.place.column
           << ": note: " << printed(note.place.key + ": " + note.sentence) << '\n';
}

Exit exitOf(const Problems& problems) {
  const bool unread =
      std::any_of(problems.begin(), problems.end(), [](const Problem& problem) { return problem.place.line == 0; });
  return unread ? Exit::File : Exit::BadInput;
}

Exit fail(const Problems& problems, Exit exit, const Streams& streams) {
  print(problems, streams.err);
  return exit;
}

Exit fail(const Problems& problems, const Streams& streams) {
  return fail(problems, exitOf(problems), streams);
}

}  // namespace underact::cli
