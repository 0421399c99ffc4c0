#pragma once
#include <iosfwd>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "core/base/result.h"
#include "core/scene/description.h"
#include "core/tick/program.h"

namespace underact::cli {

/// A scene as described in its file and as the tick runs it.
struct LoadedScene {
  scene::Description description;
  tick::TickProgram program;
};

/// With its meshes; their progress on streams.err.
Result<LoadedScene> loadScene(const std::string& path, const Streams& streams);

/// Where the meshes and curves of a recording are searched: in the given folders, then in the scenes that ship.
std::vector<std::string> recordedFilesFolders(std::vector<std::string> given);

/// One line per problem.
void print(const Problems& problems, std::ostream& stream);

/// Prints what is worth knowing about a scene without problems, one line per note: see scene::meshNotes().
void printNotes(const LoadedScene& scene, std::ostream& stream);
void printNotes(const Problems& notes, std::ostream& stream);

/// File if something could not be read at all; else BadInput.
Exit exitOf(const Problems& problems);

/// Prints them and returns `exit`, or exitOf().
Exit fail(const Problems& problems, Exit exit, const Streams& streams);
Exit fail(const Problems& problems, const Streams& streams);

}  // namespace underact::cli
