#pragma once
#include <cstring>

namespace underact {

// For numbers read as bytes from a file: whether they can be used at all. Each kind of state has its isValid() beside
// it, in its own room; it is always true for a state that the program made.

/// Whether a bool has a valid byte: one other than 0 and 1 is undefined to read.
inline bool isFlag(const bool& flag) noexcept {
  unsigned char byte = 0;
  std::memcpy(&byte, &flag, 1);
  return byte <= 1;
}

}  // namespace underact
