#pragma once
#include <string>

namespace underact::test {

/// The file of a shipped scene.
inline std::string scene(const std::string& name) {
  return std::string(UNDERACT_SOURCE) + "/scenes/" + name + ".json";
}

}  // namespace underact::test
