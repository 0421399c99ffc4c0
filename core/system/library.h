#pragma once
#include <string>

namespace underact::system {

/// Another maker's library, for the life of the process. null: it could not be loaded, and why is what the system says.
void* openLibrary(const std::string& name, std::string& why);

/// Of what it exports; an address of a function is one of these, too. null: there is none of that name.
void* addressIn(void* library, const char* name);

}  // namespace underact::system
