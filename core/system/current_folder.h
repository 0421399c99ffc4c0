#pragma once
#include <string>
#include <string_view>

namespace underact::system {

/// A list of folders, a colon between two, without those that are empty or relative.
std::string absoluteFolders(std::string_view list);

/// Takes the folder that one stands in out of the environment's lists of folders with programs, libraries and plugins,
/// for this process and what it starts: a session or a scene may lie there, and so may a stranger's file with the name
/// of a program. First in main(): no thread may run yet.
void keepOutCurrentFolder();

}  // namespace underact::system
