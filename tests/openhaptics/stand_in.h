#pragma once
#include <dlfcn.h>

#include <cstdlib>

#include "core/base/types.h"
#include "tests/openhaptics/hd/control.h"

namespace underact::test {

/// The stand-in for the vendor's library, where the driver is told to find it. Null: it cannot be loaded.
inline hd::Control* standIn() {
  static hd::Control* const kControl = []() -> hd::Control* {
    const char* const path = UNDERACT_BINARY "/openhaptics/libHD.so.3.4";
    setenv("UNDERACT_OPENHAPTICS", path, 1);
    void* const library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) return nullptr;
    const auto find = reinterpret_cast<hd::FindControl>(dlsym(library, hd::kControlName));
    return find != nullptr ? find() : nullptr;
  }();
  return kControl;
}

inline Vec3 forceOf(const hd::Control& control) {
  Vec3 f_N;
  control.force(f_N.data());
  return f_N;
}

}  // namespace underact::test
