#pragma once
#include <string>
#include <vector>

namespace underact::system {

/// The program or a library, as it is in memory.
struct Loaded {
  std::string path;
  std::string build_id;  // bytes with which the linker told builds apart; empty: there are none
};

/// The program first, then what was loaded with it and since.
std::vector<Loaded> loadedHere();

}  // namespace underact::system
