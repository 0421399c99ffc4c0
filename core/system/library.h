#pragma once
#include <string>
#include <vector>

namespace underact::system {

/// Loads a third-party library, for the life of the process. Null: it could not be loaded; why: the system's message.
void* openLibrary(const std::string& name, std::string& why);

/// The address of an exported symbol, also of a function. Null: none of that name.
void* addressIn(void* library, const char* name);

/// The program or a loaded library.
struct Loaded {
  std::string path;
  std::string build_id;  // the linker's build id, as bytes; empty: none
};

/// The program, then all loaded libraries.
std::vector<Loaded> loadedHere();

}  // namespace underact::system
