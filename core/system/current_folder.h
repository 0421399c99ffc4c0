#pragma once
#include <string>
#include <string_view>

namespace underact::system {

/// A colon-separated list of folders, without those that are empty or relative.
std::string absoluteFolders(std::string_view list);

/// Removes the current folder from the environment's lists of folders with programs, libraries and plugins, for this
/// process and those it starts: a session or a scene may lie there, and so may a file from elsewhere with the name of a
/// program. To be called first in main(), before any thread is started.
void keepOutCurrentFolder();

}  // namespace underact::system
