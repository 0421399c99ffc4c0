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
  /// Whether the file has it; without rows where it does not.
  bool isThere() const { return crc.id.isGood(); }
};

/// A table that the file does not have.
OpenTable absentTable(const Table& wanted);

/// A new table; none: the library refused.
std::optional<OpenTable> createTable(Handle file, const Table& wanted);
/// A table as createTable() makes it. None: it differs, states more rows than file_bytes bytes can hold, or is packed
/// and opened for writing.
std::optional<OpenTable> openTable(Handle group, const Table& wanted, bool writes, std::int64_t file_bytes);

/// The greatest number of rows that a file of so many bytes can hold; rows that a writer is just adding are allowed
/// for.
std::int64_t maxRows(const OpenTable& table, std::int64_t file_bytes);
/// Rows that all columns have, with a checksum for each of their blocks.
std::int64_t rowsOf(const OpenTable& table);

// false: the library refused, for a full disk or a damaged file.
bool appendBlock(const OpenTable& table, const Block& block);
bool cutTo(const OpenTable& table, std::int64_t rows);

/// The rows from begin up to end, where begin is the start of a block; a damaged block has no bytes. None: the library
/// refused.
std::optional<std::vector<Block>> readBlocks(const OpenTable& table, std::int64_t begin, std::int64_t end);

/// Reader: sees the rows that were written since.
void refresh(const OpenTable& table);
/// false: what is in memory could not be written.
bool close(OpenTable& table);

}  // namespace underact::record
