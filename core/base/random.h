#pragma once
#include <cstdint>

#include "core/base/real_time.h"

namespace underact {

/// The next number of a pseudorandom sequence, 64 bits; state: at first its seed. SplitMix64 (Steele, Lea, Flood 2014):
/// the same numbers with every compiler and library, unlike std's distributions. A bijection of the state.
inline std::uint64_t nextBits(std::uint64_t& state) noexcept UNDERACT_REAL_TIME {
  std::uint64_t z = (state += 0x9E3779B97F4A7C15U);
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  return z ^ (z >> 31U);
}

/// The next number, in [0, 1).
inline double nextShare(std::uint64_t& state) noexcept UNDERACT_REAL_TIME {
  return static_cast<double>(nextBits(state) >> 11U) * 0x1p-53;
}

}  // namespace underact
