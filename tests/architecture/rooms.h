#pragma once
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace underact::architecture {

/// The content of a file.
std::string textOf(const std::filesystem::path& path);

/// The rooms of the top CMakeLists.txt: of each folder, the folders whose headers it may include (its own among them).
using Rooms = std::map<std::string, std::set<std::string>>;

/// cmake: the text of the top CMakeLists.txt, its lines underact_room() and underact_feature().
Rooms roomsOf(const std::string& cmake);

/// One sentence for each line under root that includes what its room may not, or that goes around the gate.
std::vector<std::string> violations(const std::filesystem::path& root);

/// One sentence for each room of the window under root that has no test in the folder of its name in tests/gui.
std::vector<std::string> withoutTests(const std::filesystem::path& root);

}  // namespace underact::architecture
