#pragma once
#include <string>

#include "core/scene/read.h"

namespace underact::tradeoff::test {

/// The scene of that name that ships, as in "05_circle".
inline scene::Description shipped(const std::string& name) {
  return scene::readSceneFile(std::string(UNDERACT_SOURCE) + "/scenes/" + name + ".json").value();
}

}  // namespace underact::tradeoff::test
