#pragma once
#include <cstdint>
#include <string>

#include "core/record/hdf5_id.h"
#include "core/record/table.h"

namespace underact::record {

/// A dataset that grows by rows of `width` numbers: a column of a table.
struct Store {
  Id id;  // not good: missing, or of another type
  NumberKind kind = NumberKind::Real;
  std::uint64_t width = 1;
  bool is_packed = false;  // shuffled or compressed by zlib, as h5repack makes copies; never by this program
  /// Dimensions of the dataset: rows, and numbers a row where they are several.
  int rank() const { return width > 1 ? 2 : 1; }
};

/// A new dataset without rows, unit, frame and meaning as its attributes; not good where the library refused.
Store createStore(Handle group, const Column& column, std::uint64_t chunk_rows);
/// A dataset as createStore() makes it, with chunks of so many rows; not good where it differs in any way: another
/// type, a link, another filter, the layout of another program, data in another file.
Store openStore(Handle group, const Column& column, std::uint64_t chunk_rows);
std::uint64_t rowsOf(const Store& store);  // 0 if it does not say

// false: the library refused, for a full disk or a damaged file.
bool resize(const Store& store, std::uint64_t rows);
bool append(const Store& store, const void* data, std::uint64_t rows);
bool readRows(const Store& store, std::uint64_t first, std::uint64_t rows, void* data);

}  // namespace underact::record
