#pragma once
#include <string>
#include <vector>

namespace underact::system {

/// Another maker's library, for the life of the process. null: it could not be loaded, and why is what the system says.
void* openLibrary(const std::string& name, std::string& why);

/// Of what it exports; an address of a function is one of these, too. null: there is none of that name.
void* addressIn(void* library, const char* name);

/// The program or a library, as it is in memory.
struct Loaded {
  std::string path;
  std::string build_id;  // bytes with which the linker told builds apart; empty: there are none
};

/// The program first, then what was loaded with it and since.
std::vector<Loaded> loadedHere();

}  // namespace underact::system
