#pragma once
#include <cstring>

namespace underact {

// Of numbers that came as bytes, out of a file: whether they may be used at all. Each kind of memory has its own
// isSound() beside it, in the room that it belongs to; what a program wrote by itself always is.

/// A byte that is neither 0 nor 1 is no bool, and to read it as one is undefined.
inline bool isFlag(const bool& flag) noexcept {
  unsigned char byte = 0;
  std::memcpy(&byte, &flag, 1);
  return byte <= 1;
}

}  // namespace underact
