#include "core/record/table.h"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <numeric>

namespace underact::record {

static_assert(std::endian::native == std::endian::little, "a block is written as it stands in memory");

namespace {

/// The words between the commas.
std::vector<std::string_view> split(std::string_view words) {
  std::vector<std::string_view> parts;
  while (!words.empty()) {
    const std::size_t comma = std::min(words.find(','), words.size());
    parts.push_back(words.substr(0, comma));
    words.remove_prefix(std::min(comma + 1, words.size()));
  }
  return parts;
}

}  // namespace

std::vector<std::string> partsOf(const Column& column) {
  const std::vector<std::string_view> parts = split(column.parts.empty() ? column.name : column.parts);
  if (column.frame != "W" || !column.parts.empty()) return {parts.begin(), parts.end()};
  const std::string name(column.name);
  return {name + "_x", name + "_y", name + "_z"};
}

std::vector<std::string_view> csvNamesOf(const Column& column) {
  return split(column.csv);
}

std::string_view typeWord(const Column& column) {
  switch (column.kind) {
    case NumberKind::Byte:
      return "uint8";
    case NumberKind::Unsigned:
      return "uint32";
    case NumberKind::Integer:
      return "int64";
    case NumberKind::Real:
      return "float64";
  }
  return "";
}

std::size_t bytesOf(const Column& column) {
  const std::size_t one = column.kind == NumberKind::Byte ? 1 : column.kind == NumberKind::Unsigned ? 4 : 8;
  return one * static_cast<std::size_t>(column.width);
}

std::size_t rowBytes(const Table& table) {
  return std::accumulate(table.columns.begin(), table.columns.end(), std::size_t{0},
                         [](std::size_t sum, const Column& column) { return sum + bytesOf(column); });
}

std::uint32_t crcOf(std::span<const std::byte> bytes) {
  return static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

RowRange rangeOf(std::int64_t first, std::int64_t count, std::int64_t block_rows, std::int64_t all) {
  if (first < 0 || count <= 0 || first > all / block_rows) return {};
  const std::int64_t begin = first * block_rows;
  return {begin, count > (all - begin) / block_rows ? all : begin + count * block_rows};
}

namespace {

std::vector<std::size_t> offsetsOf(std::span<const Column> columns, std::int64_t rows) {
  std::vector<std::size_t> offsets{0};
  for (const Column& column : columns) {
    offsets.push_back(offsets.back() + static_cast<std::size_t>(rows) * bytesOf(column));
  }
  return offsets;
}

}  // namespace

Packer::Packer(std::span<const Column> columns) : columns_(columns) {}

void Packer::begin(std::int64_t max_rows) {
  if (max_rows != max_rows_ || offsets_.empty()) {
    offsets_ = offsetsOf(columns_, max_rows);
    bytes_.resize(offsets_.back());
  }
  max_rows_ = max_rows;
  rows_ = 0;
  column_ = in_row_ = 0;
}

void Packer::put(const void* value, std::size_t bytes) {
  const std::size_t row_bytes = bytesOf(columns_[column_]);
  std::memcpy(&bytes_[offsets_[column_] + static_cast<std::size_t>(rows_) * row_bytes + in_row_], value, bytes);
  in_row_ += bytes;
  if (in_row_ < row_bytes) return;
  in_row_ = 0;
  if (++column_ < columns_.size()) return;
  column_ = 0;
  ++rows_;
}

Block Packer::block() const {
  Block block{rows_, {}};
  for (std::size_t column = 0; column < columns_.size(); ++column) {
    const std::byte* const begin = bytes_.data() + offsets_[column];
    block.bytes.insert(block.bytes.end(), begin, begin + static_cast<std::size_t>(rows_) * bytesOf(columns_[column]));
  }
  return block;
}

Unpacker::Unpacker(std::span<const Column> columns, const Block& block)
    : columns_(columns), block_(block), offsets_(offsetsOf(columns, block.rows)) {}

void Unpacker::get(void* value, std::size_t bytes) {
  const std::size_t row_bytes = bytesOf(columns_[column_]);
  std::memcpy(value, &block_.bytes[offsets_[column_] + static_cast<std::size_t>(row_) * row_bytes + in_row_], bytes);
  in_row_ += bytes;
  if (in_row_ < row_bytes) return;
  in_row_ = 0;
  if (++column_ < columns_.size()) return;
  column_ = 0;
  ++row_;
}

}  // namespace underact::record
