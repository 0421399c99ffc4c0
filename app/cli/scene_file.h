#pragma once
#include <iosfwd>
#include <string>

#include "app/cli/command.h"
#include "core/base/result.h"
#include "core/scene/description.h"
#include "core/tick/program.h"

namespace underact::cli {

/// A scene as its file says it and as the tick runs it.
struct LoadedScene {
  scene::Description description;
  tick::TickProgram program;
};

/// With its meshes; their progress on streams.err.
Result<LoadedScene> loadScene(const std::string& path, const Streams& streams);

/// One line a problem.
void print(const Problems& problems, std::ostream& stream);

/// What is worth knowing of a scene in which nothing is wrong, a line each: see scene::meshNotes().
void printNotes(const LoadedScene& scene, std::ostream& stream);

/// File where something could not be read at all; else BadInput.
Exit exitOf(const Problems& problems);

/// Tells them and ends with `exit`, or as exitOf() says.
Exit fail(const Problems& problems, Exit exit, const Streams& streams);
Exit fail(const Problems& problems, const Streams& streams);

}  // namespace underact::cli
