#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace underact::record {

/// The type of a column's numbers; little-endian in the file.
enum class NumberKind : std::uint8_t { Byte, Unsigned, Integer, Real };  // 1, 4, 8, 8 bytes

/// A column of a table: its name and unit in the file, and what its numbers are.
struct Column {
  std::string_view name;
  std::string_view unit;  // empty: a number without unit
  std::string_view meaning;
  NumberKind kind = NumberKind::Real;
  std::string_view csv = {};    // names of the numbers in CSV, live data and fault files, with commas; empty: none
  int width = 1;                // numbers per row
  std::string_view frame = {};  // "W": coordinates in the workspace frame; "joints", "motors"; empty: none
  std::string_view parts = {};  // names where each number has a column of its own; empty: name, and _x, _y, _z in W
  int csv_since = 0;            // CSV has them in the order of the table, but behind those of a lower number
};

/// The names of a column's numbers where each has a column of its own (Parquet, DataFrame).
std::vector<std::string> partsOf(const Column& column);
/// The column's names in CSV, live data and fault files; none: they do not have it.
std::vector<std::string_view> csvNamesOf(const Column& column);
/// The word for the type of its numbers: "uint8", "uint32", "int64", "float64".
std::string_view typeWord(const Column& column);

std::size_t bytesOf(const Column& column);  // of one row

/// Whether a file has a table. Always: it does. Later: from a version after 0.1.0 on. OnRequest: where it was asked
/// for.
enum class Presence : std::uint8_t { Always, Later, OnRequest };

/// A group of columns that grow by whole blocks. Layout: resources/guide/session_file.md.
struct Table {
  std::string_view name;
  std::span<const Column> columns;
  std::int64_t block_rows = 1;
  std::int64_t chunk_rows = 64;
  std::int64_t max_block_rows = 0;  // that a file may have, each block a chunk; 0: only block_rows and chunk_rows
  Presence presence = Presence::Always;
  bool is_made = true;          // by a writer that makes a file
  std::string_view about = {};  // one row is ...
};

/// Bytes of one row over all columns.
std::size_t rowBytes(const Table& table);

/// Rows, column after column, as in the file; its CRC-32 is the block's.
struct Block {
  std::int64_t rows = 0;
  std::vector<std::byte> bytes;
};

/// CRC-32 as in zlib and PNG.
std::uint32_t crcOf(std::span<const std::byte> bytes);

/// The greatest compression ratio of a file that was packed by another program: of an arm that stands still, in the
/// longest blocks.
inline constexpr std::int64_t kMaxPacked = 256;

/// The greatest length that a file is taken to have, bytes: a sparse file may state any.
inline constexpr std::int64_t kLongestFile = std::int64_t{1} << 44;

/// Rows of a table, from begin up to end.
struct RowRange {
  std::int64_t begin = 0, end = 0;
  /// Blocks that the rows take; the last one may not be full. block_rows: above 0.
  std::int64_t blocks(std::int64_t block_rows) const { return (end - begin + block_rows - 1) / block_rows; }
};
/// The rows of at most count blocks from first on, in a table of so many rows. Empty where first is beyond them.
RowRange rangeOf(std::int64_t first, std::int64_t count, std::int64_t block_rows, std::int64_t all);

/// Writes rows into a block, number by number: row by row, and in a row column by column. For at most as many rows as
/// begin() was told.
class Packer {
 public:
  /// columns: they outlive this.
  explicit Packer(std::span<const Column> columns);
  /// Begins a block of no rows. Allocates where max_rows is another than before.
  void begin(std::int64_t max_rows);
  // The next number: one of the kind that its column has; not checked, nor that there is room.
  void integer(std::int64_t value) { put(&value, sizeof value); }
  void unsigned32(std::uint32_t value) { put(&value, sizeof value); }
  void byte(std::uint8_t value) { put(&value, sizeof value); }
  void real(double value) { put(&value, sizeof value); }
  std::int64_t rows() const { return rows_; }
  /// Whether there are as many rows as begin() was told.
  bool isFull() const { return rows_ == max_rows_; }
  /// The rows written so far, without gaps.
  Block block() const;

 private:
  void put(const void* value, std::size_t bytes);
  std::span<const Column> columns_;
  std::vector<std::size_t> offsets_;  // of the columns, for max_rows_
  std::vector<std::byte> bytes_;
  std::int64_t rows_ = 0, max_rows_ = 0;
  std::size_t column_ = 0, in_row_ = 0;  // the next number
};

/// Reads rows back in the same order.
class Unpacker {
 public:
  /// columns and block: they outlive this; the block is whole and was packed with these columns.
  Unpacker(std::span<const Column> columns, const Block& block);
  /// Whether all rows were read.
  bool isDone() const { return row_ == block_.rows; }
  // The next number, as its column has it; to be called only until isDone().
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
