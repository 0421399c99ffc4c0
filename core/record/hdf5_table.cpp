#include "core/record/hdf5_table.h"

#include <hdf5.h>

#include <algorithm>
#include <span>
#include <string>

namespace underact::record {
namespace {

constexpr Column kCrc{"crc32", "", "CRC-32 of a block of rows, column after column", NumberKind::Unsigned};
constexpr std::uint64_t kCrcChunk = 64;

std::string namesOf(std::span<const Column> columns) {
  std::string names;
  for (const Column& column : columns) names.append(names.empty() ? "" : ",").append(column.name);
  return names;
}

bool hasItsBlocks(const Table& wanted, std::int64_t block_rows) {
  if (wanted.max_block_rows == 0) return block_rows == wanted.block_rows;
  return block_rows >= 1 && block_rows <= wanted.max_block_rows;
}

}  // namespace

OpenTable absentTable(const Table& wanted) {
  OpenTable table;
  table.columns.assign(wanted.columns.begin(), wanted.columns.end());
  table.block_rows = wanted.block_rows;
  return table;
}

std::optional<OpenTable> createTable(Handle file, const Table& wanted) {
  const Id group(H5Gcreate2(file, std::string(wanted.name).c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  if (!group.isGood()) return {};
  OpenTable table;
  table.block_rows = wanted.block_rows;
  table.columns.assign(wanted.columns.begin(), wanted.columns.end());
  for (const Column& column : wanted.columns) {
    table.stores.push_back(createStore(group, column, static_cast<std::uint64_t>(wanted.chunk_rows)));
    if (!table.stores.back().id.isGood()) return {};
  }
  table.crc = createStore(group, kCrc, kCrcChunk);
  if (!table.crc.id.isGood() || !writeAttribute(group, {"columns", namesOf(wanted.columns)}) ||
      !writeAttribute(group, {"block_rows", wanted.block_rows}))
    return {};
  return table;
}

std::optional<OpenTable> openTable(Handle group, const Table& wanted, bool writes, std::int64_t file_bytes) {
  OpenTable table;
  table.columns.assign(wanted.columns.begin(), wanted.columns.end());
  table.block_rows = integerAttribute(group, "block_rows").value_or(0);
  if (!hasItsBlocks(wanted, table.block_rows)) return {};
  const auto chunk_rows = static_cast<std::uint64_t>(wanted.max_block_rows == 0 ? wanted.chunk_rows : table.block_rows);
  table.crc = openStore(group, kCrc, kCrcChunk);
  bool good = table.crc.id.isGood();
  for (const Column& column : wanted.columns) {
    const Store& store = table.stores.emplace_back(openStore(group, column, chunk_rows));
    good = good && store.id.isGood();
    table.is_packed = table.is_packed || store.is_packed;
  }
  // Writing into a packed file would require unpacking it in this process.
  if (!good || (writes && (table.is_packed || table.crc.is_packed))) return {};
  const auto max = static_cast<std::uint64_t>(maxRows(table, file_bytes));
  const auto fits = [max](const Store& store) { return rowsOf(store) <= max; };
  if (!fits(table.crc) || !std::all_of(table.stores.begin(), table.stores.end(), fits)) return {};
  return table;
}

std::int64_t maxRows(const OpenTable& table, std::int64_t file_bytes) {
  const std::int64_t max =
      std::min(file_bytes, kLongestFile) / static_cast<std::int64_t>(rowBytes(Table{{}, table.columns}));
  return (table.is_packed ? kMaxPacked * max : max) + table.block_rows;
}

std::int64_t rowsOf(const OpenTable& table) {
  if (!table.isThere()) return 0;
  std::uint64_t rows = rowsOf(table.crc) * static_cast<std::uint64_t>(table.block_rows);
  for (const Store& store : table.stores) rows = std::min(rows, rowsOf(store));
  return static_cast<std::int64_t>(std::min<std::uint64_t>(rows, INT64_MAX));
}

bool appendBlock(const OpenTable& table, const Block& block) {
  const auto rows = static_cast<std::uint64_t>(block.rows);
  const std::byte* data = block.bytes.data();
  bool good = true;
  for (std::size_t column = 0; column < table.stores.size(); ++column) {
    good = good && append(table.stores[column], data, rows);
    data += rows * bytesOf(table.columns[column]);
  }
  const std::size_t block_bytes = table.columns.size() == 1
                                      ? static_cast<std::size_t>(table.block_rows) * bytesOf(table.columns[0])
                                      : block.bytes.size();
  for (std::size_t at = 0; at < block.bytes.size(); at += block_bytes) {
    const std::size_t size = std::min(block_bytes, block.bytes.size() - at);
    const std::uint32_t crc = crcOf(std::span(block.bytes).subspan(at, size));
    good = good && append(table.crc, &crc, 1);
  }
  return good;
}

bool cutTo(const OpenTable& table, std::int64_t rows) {
  if (!table.isThere()) return true;
  const auto wanted = static_cast<std::uint64_t>(rows);
  const auto block_rows = static_cast<std::uint64_t>(table.block_rows);
  bool good = resize(table.crc, (wanted + block_rows - 1) / block_rows);
  for (const Store& store : table.stores) good = good && resize(store, wanted);
  return good;
}

std::optional<std::vector<Block>> readBlocks(const OpenTable& table, std::int64_t begin, std::int64_t end) {
  const std::int64_t block_rows = table.block_rows;
  const auto blocks = static_cast<std::size_t>((end - begin + block_rows - 1) / block_rows);
  std::vector<std::uint32_t> crcs(blocks);
  if (!readRows(table.crc, static_cast<std::uint64_t>(begin / block_rows), blocks, crcs.data())) return {};
  std::vector<std::vector<std::byte>> columns;
  for (std::size_t column = 0; column < table.stores.size(); ++column) {
    std::vector<std::byte>& bytes =
        columns.emplace_back(static_cast<std::size_t>(end - begin) * bytesOf(table.columns[column]));
    if (!readRows(table.stores[column], static_cast<std::uint64_t>(begin), static_cast<std::uint64_t>(end - begin),
                  bytes.data()))
      return {};
  }
  std::vector<Block> read(blocks);
  for (std::size_t index = 0; index < blocks; ++index) {
    const std::int64_t row = static_cast<std::int64_t>(index) * block_rows;
    Block& block = read[index];
    block.rows = std::min(block_rows, end - begin - row);
    for (std::size_t column = 0; column < columns.size(); ++column) {
      const std::size_t one = bytesOf(table.columns[column]);
      const std::byte* const from = columns[column].data() + static_cast<std::size_t>(row) * one;
      block.bytes.insert(block.bytes.end(), from, from + static_cast<std::size_t>(block.rows) * one);
    }
    if (crcOf(block.bytes) != crcs[index]) block.bytes.clear();
  }
  return read;
}

void refresh(const OpenTable& table) {
  if (!table.isThere()) return;
  for (const Store& store : table.stores) H5Drefresh(store.id);
  H5Drefresh(table.crc.id);
}

bool close(OpenTable& table) {
  bool good = true;
  for (Store& store : table.stores) good = store.id.close() && good;
  return table.crc.id.close() && good;
}

}  // namespace underact::record
