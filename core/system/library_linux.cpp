#ifdef __linux__
#include <dlfcn.h>

#include "core/system/library.h"

namespace underact::system {

void* openLibrary(const std::string& name, std::string& why) {
  void* const library = ::dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library != nullptr) return library;
  const char* const text = ::dlerror();
  why = text != nullptr ? text : name + ": no reason given";
  return nullptr;
}

void* addressIn(void* library, const char* name) {
  return ::dlsym(library, name);
}

}  // namespace underact::system
#endif
