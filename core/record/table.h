#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace underact::record {

/// The type of a column's numbers; little-endian in the file.
enum class Kind : std::uint8_t { Byte, Unsigned, Integer, Real };  // 1, 4, 8, 8 bytes

struct Column {
  std::string_view name;
  std::string_view unit;  // empty: a number without unit
  std::string_view meaning;
  Kind kind = Kind::Real;
  int width = 1;  // numbers per row
};

std::size_t bytesOf(const Column& column);  // of one row

/// A group of columns that grow by whole blocks. Layout: resources/guide/session_file.md.
struct Table {
  std::string_view name;
  std::span<const Column> columns;
  std::int64_t block_rows = 1;
  std::int64_t chunk_rows = 64;
  std::int64_t most_block_rows = 0;  // that a file may have, each block a chunk; 0: only block_rows and chunk_rows
};

std::size_t rowBytes(const Table& table);

/// Rows, column after column, as in the file; its CRC-32 is the block's.
struct Block {
  std::int64_t rows = 0;
  std::vector<std::byte> bytes;
};

/// As zlib and PNG compute it.
std::uint32_t crcOf(std::span<const std::byte> bytes);

/// How many more rows than its bytes hold a repacked file may have: the worst case is an arm at rest, in the longest
/// blocks.
inline constexpr std::int64_t kMostPacked = 256;

/// The length that a file is taken to have at most, bytes: a file may state a length far beyond what is on the disk.
inline constexpr std::int64_t kLongestFile = std::int64_t{1} << 44;

/// Rows of a table, from one up to another.
struct RowRange {
  std::int64_t begin = 0, end = 0;
  std::int64_t blocks(std::int64_t block_rows) const { return (end - begin + block_rows - 1) / block_rows; }
};
/// Rows of the blocks from first on, at most count; of a table with that many rows in all. None if first is beyond
/// them.
RowRange rangeOf(std::int64_t first, std::int64_t count, std::int64_t block_rows, std::int64_t all);

/// Writes rows into a block, number by number: row by row, each row column by column. At most as many rows as begin()
/// was told.
class Packer {
 public:
  explicit Packer(std::span<const Column> columns);
  void begin(std::int64_t most_rows);
  void integer(std::int64_t value) { put(&value, sizeof value); }
  void unsigned32(std::uint32_t value) { put(&value, sizeof value); }
  void byte(std::uint8_t value) { put(&value, sizeof value); }
  void real(double value) { put(&value, sizeof value); }
  std::int64_t rows() const { return rows_; }
  bool isFull() const { return rows_ == most_rows_; }
  /// What was written so far, without gaps.
  Block block() const;

 private:
  void put(const void* value, std::size_t bytes);
  std::span<const Column> columns_;
  std::vector<std::size_t> offsets_;  // of the columns, for most_rows_
  std::vector<std::byte> bytes_;
  std::int64_t rows_ = 0, most_rows_ = 0;
  std::size_t column_ = 0, in_row_ = 0;  // the next number
};

/// Reads them back the same way.
class Unpacker {
 public:
  Unpacker(std::span<const Column> columns, const Block& block);
  bool isDone() const { return row_ == block_.rows; }
  std::int64_t integer() { return take<std::int64_t>(); }
  std::uint32_t unsigned32() { return take<std::uint32_t>(); }
  std::uint8_t byte() { return take<std::uint8_t>(); }
  double real() { return take<double>(); }

 private:
  template <class Number>
  Number take() {
    Number number{};
    get(&number, sizeof number);
    return number;
  }
  void get(void* value, std::size_t bytes);
  std::span<const Column> columns_;
  const Block& block_;
  std::vector<std::size_t> offsets_;
  std::int64_t row_ = 0;
  std::size_t column_ = 0, in_row_ = 0;
};

}  // namespace underact::record
