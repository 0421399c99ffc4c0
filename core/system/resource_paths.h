#pragma once
#include <string>
#include <vector>

#include "core/base/result.h"

namespace underact::system {

/// The folders of files that come with the program.
enum class Resource { Scenes, Lessons, Guide, Python };

/// The folders from which a program looks for its files and helpers. Absolute; empty: none.
struct SearchRoots {
  std::string stated = {};    // $UNDERACT_DATA_DIR: an installed program's data, or the sources
  std::string here = {};      // of the running program's own file
  std::string sources = {};   // of the sources; known only in a build folder, from the file underact-places
  std::string programs = {};  // that build folder
};

/// That of this process. A relative UNDERACT_DATA_DIR is ignored, since it would depend on the current folder.
SearchRoots searchRoots();

/// The folders that may hold a resource, in the order of the search.
std::vector<std::string> searchFolders(Resource resource, const SearchRoots& from);

/// The path of a helper program: beside the running one, in the helpers' folder of an installation, in the build
/// folder.
std::vector<std::string> searchFolders(const std::string& program, const SearchRoots& from);

/// The folder that holds the resource, with links resolved. Problem: none; names all places.
Result<std::string> findResource(Resource resource, const SearchRoots& from = searchRoots());

/// The path of a helper program. variable: of the environment, whose value is used instead where it is set. Problem:
/// not found; names all places.
Result<std::string> findProgram(const std::string& program, const char* variable = nullptr,
                                const SearchRoots& from = searchRoots());

}  // namespace underact::system
