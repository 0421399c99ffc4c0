#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "core/record/hdf5_store.h"
#include "core/record/table.h"

namespace underact::record {

/// A table of an open file: its columns, and the checksums of their blocks.
struct OpenTable {
  std::vector<Column> columns;
  std::vector<Store> stores;  // a column each
  Store crc;
  std::int64_t block_rows = 1;
  bool is_packed = false;  // see Store
};

/// A new one; none: the library refused.
std::optional<OpenTable> createTable(Handle file, const Table& wanted);
/// As createTable() makes it; none: it is otherwise, says more rows than file_bytes bytes can hold, or is packed and to
/// be written.
std::optional<OpenTable> openTable(Handle group, const Table& wanted, bool writes, std::int64_t file_bytes);

/// Rows that a file of so many bytes can hold: each takes its own. What a writer is just adding counts before it is
/// there.
std::int64_t mostRows(const OpenTable& table, std::int64_t file_bytes);
/// Rows that all columns have, with a checksum for each of their blocks.
std::int64_t rowsOf(const OpenTable& table);

// false: the library refused, for a full disk or a damaged file.
bool appendBlock(const OpenTable& table, const Block& block);
bool cutTo(const OpenTable& table, std::int64_t rows);

/// The rows from begin to before end, which begin with a block; a damaged block has no bytes. None: the library
/// refused.
std::optional<std::vector<Block>> readBlocks(const OpenTable& table, std::int64_t begin, std::int64_t end);

/// Reader: sees the rows that were written since.
void refresh(const OpenTable& table);
/// false: what is in memory could not be written.
bool close(OpenTable& table);

}  // namespace underact::record
