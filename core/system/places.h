#pragma once
#include <string>
#include <vector>

#include "core/base/result.h"

namespace underact::system {

/// What comes with the program as files that it opens: scenes, lessons, the guide's pages, the Python package.
enum class Resource { Scenes, Lessons, Guide, Python };

/// From where a program looks for what belongs to it. Absolute folders; empty: there is none.
struct Standpoint {
  std::string stated = {};    // $UNDERACT_DATA_DIR: an installed program's data, or the sources
  std::string here = {};      // of the running program's own file
  std::string sources = {};   // that it was built from; known in a build folder alone, from the file underact-places
  std::string programs = {};  // that build folder
};

/// Of this process. A relative UNDERACT_DATA_DIR counts as none: it would mean whatever folder one stands in.
Standpoint standpoint();

/// Where a resource may lie, in the order in which it is looked for.
std::vector<std::string> placesOf(Resource resource, const Standpoint& from);

/// The same of a program of ours: beside the running one, where an installed one has its helpers, in the build folder.
std::vector<std::string> placesOf(const std::string& program, const Standpoint& from);

/// The folder that holds the resource, without links in it. Problem: none does; names all places.
Result<std::string> findResource(Resource resource, const Standpoint& from = standpoint());

/// The path of a program of ours. variable: of the environment, which says it instead where it is set. Problem: it is
/// not there; names all places.
Result<std::string> findProgram(const std::string& program, const char* variable = nullptr,
                                const Standpoint& from = standpoint());

}  // namespace underact::system
