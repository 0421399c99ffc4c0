#include "core/record/hdf5_store.h"

#include <hdf5.h>

#include <algorithm>

namespace underact::record {
namespace {

constexpr hsize_t kMaxStoreRows = hsize_t{1} << 40;

hid_t typeOf(NumberKind kind) {
  switch (kind) {
    case NumberKind::Byte:
      return H5T_STD_U8LE;
    case NumberKind::Unsigned:
      return H5T_STD_U32LE;
    case NumberKind::Integer:
      return H5T_STD_I64LE;
    case NumberKind::Real:
      return H5T_IEEE_F64LE;
  }
  return -1;
}

/// The filters of a dataset: 0 none, 1 those of copies packed by h5repack, -1 any other. None is a plugin.
int packingOf(hid_t made) {
  const int filters = H5Pget_nfilters(made);
  for (int index = 0; index < filters; ++index) {
    unsigned flags = 0, settings = 0;
    std::size_t count = 0;
    const H5Z_filter_t filter =
        H5Pget_filter2(made, static_cast<unsigned>(index), &flags, &count, nullptr, 0, nullptr, &settings);
    if (filter != H5Z_FILTER_SHUFFLE && filter != H5Z_FILTER_DEFLATE) return -1;
  }
  return filters < 0 ? -1 : filters > 0 ? 1 : 0;
}

/// Whether its numbers are in this file, in chunks as createStore() makes them.
bool isLaidOutAsOurs(Store& store, hsize_t chunk_rows) {
  const Id made(H5Dget_create_plist(store.id), H5Pclose);
  hsize_t chunk[2] = {0, store.width};
  H5D_fill_value_t fill = H5D_FILL_VALUE_ERROR;
  const int packing = made.isGood() ? packingOf(made) : -1;
  store.is_packed = packing == 1;
  return packing >= 0 && H5Pget_layout(made) == H5D_CHUNKED && H5Pget_external_count(made) == 0 &&
         H5Pfill_value_defined(made, &fill) >= 0 && fill == H5D_FILL_VALUE_DEFAULT &&
         H5Pget_chunk(made, 2, chunk) == store.rank() && chunk[0] == chunk_rows && chunk[1] == store.width;
}

/// A selection of rows of a store, and memory for as many.
struct Selection {
  Selection(const Store& store, hsize_t first, hsize_t rows) : file(H5Dget_space(store.id), H5Sclose) {
    const hsize_t begin[2] = {first, 0};
    const hsize_t size[2] = {rows, store.width};
    good = file.isGood() && H5Sselect_hyperslab(file, H5S_SELECT_SET, begin, nullptr, size, nullptr) >= 0;
    memory = Id(H5Screate_simple(store.rank(), size, nullptr), H5Sclose);
  }
  Id file, memory;
  bool good = false;
};

}  // namespace

std::uint64_t rowsOf(const Store& store) {
  const Id space(H5Dget_space(store.id), H5Sclose);
  hsize_t size[2] = {0, 0};
  if (!space.isGood() || H5Sget_simple_extent_dims(space, size, nullptr) != store.rank()) return 0;
  return std::min(size[0], kMaxStoreRows);
}

Store createStore(Handle group, const Column& column, std::uint64_t chunk_rows) {
  Store store;
  store.kind = column.kind;
  store.width = static_cast<hsize_t>(column.width);
  const hsize_t none[2] = {0, store.width};
  const hsize_t max[2] = {H5S_UNLIMITED, store.width};
  const hsize_t chunk[2] = {chunk_rows, store.width};
  const Id space(H5Screate_simple(store.rank(), none, max), H5Sclose);
  const Id layout(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_chunk(layout, store.rank(), chunk);
  store.id = Id(
      H5Dcreate2(group, std::string(column.name).c_str(), typeOf(column.kind), space, H5P_DEFAULT, layout, H5P_DEFAULT),
      H5Dclose);
  if (store.id.isGood() && !(writeAttribute(store.id, {"unit", std::string(column.unit)}) &&
                             writeAttribute(store.id, {"frame", std::string(column.frame)}) &&
                             writeAttribute(store.id, {"meaning", std::string(column.meaning)})))
    store.id = Id();
  return store;
}

Store openStore(Handle group, const Column& column, std::uint64_t chunk_rows) {
  Store store;
  store.kind = column.kind;
  store.width = static_cast<hsize_t>(column.width);
  if (!isOwn(group, column.name)) return store;
  store.id = Id(H5Dopen2(group, std::string(column.name).c_str(), H5P_DEFAULT), H5Dclose);
  if (!store.id.isGood()) return store;
  const Id type(H5Dget_type(store.id), H5Tclose);
  const Id space(H5Dget_space(store.id), H5Sclose);
  hsize_t size[2] = {0, 1}, max[2] = {0, 1};
  const bool same = H5Tequal(type, typeOf(column.kind)) > 0 && H5Sget_simple_extent_ndims(space) == store.rank() &&
                    H5Sget_simple_extent_dims(space, size, max) == store.rank() && max[0] == H5S_UNLIMITED &&
                    (store.rank() == 1 || (size[1] == store.width && max[1] == store.width));
  if (!same || !isLaidOutAsOurs(store, chunk_rows)) store.id = Id();
  return store;
}

bool resize(const Store& store, std::uint64_t rows) {
  const hsize_t size[2] = {rows, store.width};
  return H5Dset_extent(store.id, size) >= 0;
}

bool append(const Store& store, const void* data, std::uint64_t rows) {
  const hsize_t before = rowsOf(store);
  if (!resize(store, before + rows)) return false;
  const Selection selection(store, before, rows);
  return selection.good &&
         H5Dwrite(store.id, typeOf(store.kind), selection.memory, selection.file, H5P_DEFAULT, data) >= 0;
}

bool readRows(const Store& store, std::uint64_t first, std::uint64_t rows, void* data) {
  if (rows == 0) return true;
  const Selection selection(store, first, rows);
  return selection.good &&
         H5Dread(store.id, typeOf(store.kind), selection.memory, selection.file, H5P_DEFAULT, data) >= 0;
}

}  // namespace underact::record
