#pragma once
#include <string>

namespace underact::guide {

/// A section of a page: every setting of a scene by its path, from the table of settings.
std::string settingTable();

}  // namespace underact::guide
