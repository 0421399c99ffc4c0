#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

#include "core/record/table.h"

namespace underact::record {

// The questions of a program to underact-session-reader, and the answers. Both are this program's: numbers are sent as
// they are in memory.

enum class Asks : std::uint8_t { Open, Refresh, Read, Text, Integer, Real };

struct Question {
  Asks what = Asks::Open;
  std::array<char, 31> name{};        // of an attribute, padded with zeros
  std::uint64_t table = 0;            // Read
  std::int64_t first = 0, count = 0;  // Read: blocks
  std::int64_t at_least = 0;          // Open: see accessThrough()
  std::int64_t fallback = 0;          // Integer: if it is missing
  double real_fallback = 0.0;         // Real
};
static_assert(std::is_trivially_copyable_v<Question> && sizeof(Question) == 80);

// Each answer begins with one of these. No: a sentence follows, see helper/words.h. Yes: to Open and Refresh, a Shape;
// to Read, a byte per block, 1 if it is intact, then the bytes of the intact ones; to Text, its characters; to Integer
// and Real, the number.
inline constexpr std::byte kNo{0}, kYes{1};

inline constexpr std::size_t kMostForeignTables = 8;
struct Shape {
  std::array<std::int64_t, kMostForeignTables> rows{}, block_rows{};
  std::int64_t is_open_elsewhere = 0;
};

}  // namespace underact::record
