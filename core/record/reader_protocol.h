#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

#include "core/record/table.h"

namespace underact::record {

// The questions to underact-session-reader, and its answers. Both are builds of this program: numbers have the layout
// of memory.

/// What can be asked.
enum class QuestionKind : std::uint8_t { Open, Refresh, Read, Text, Integer, Real };

/// One question, as it is sent.
struct Question {
  QuestionKind what = QuestionKind::Open;
  std::array<char, 31> name{};        // of an attribute, padded with zeros
  std::uint64_t table = 0;            // Read
  std::int64_t first = 0, count = 0;  // Read: blocks
  std::int64_t at_least = 0;          // Open: see accessThrough()
  std::int64_t fallback = 0;          // Integer: if it is missing
  double real_fallback = 0.0;         // Real
};
static_assert(std::is_trivially_copyable_v<Question> && sizeof(Question) == 80);

// Each answer begins with one of these. No: a sentence follows, see helper/words.h. Yes: to Open and Refresh, a Shape;
// to Read, a byte for each block, 1 where it is whole, then the bytes of the whole ones; to Text, its bytes; to Integer
// and Real, the number.
inline constexpr std::byte kNo{0}, kYes{1};

inline constexpr std::size_t kMaxForeignTables = 16;
/// Of each table, in their order: its rows, and the rows of its blocks.
struct Shape {
  std::array<std::int64_t, kMaxForeignTables> rows{}, block_rows{};
  std::int64_t is_open_elsewhere = 0;
};

}  // namespace underact::record
