#include "core/record/hdf5_file.h"

#include <fcntl.h>
#include <hdf5.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <utility>

namespace underact::record {
namespace {

constexpr std::size_t kLongestText = std::size_t{1} << 24;
constexpr hsize_t kMostRows = hsize_t{1} << 40;
// What a writer is just changing is read again, each time after twice the pause: 24 times take 20 ms. The library's own
// 100 would be for ever where the file is damaged.
constexpr unsigned kAttempts = 24;
// Set aside on the disk beyond what is written, so that a disk that fills up is met before the library meets it, and
// there is room to end in order.
constexpr std::int64_t kSetAside = 8 << 20;
constexpr std::int64_t kSetAsideAtLeast = 4 << 20;

/// One identifier of the library's, closed at the end.
class Id {
 public:
  using Close = herr_t (*)(hid_t);
  Id() = default;
  Id(hid_t id, Close closer) : id_(id), close_(closer) {}
  Id(Id&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Id& operator=(Id&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Id() { close(); }
  bool close() {
    const hid_t id = std::exchange(id_, -1);
    return id < 0 || close_(id) >= 0;
  }
  operator hid_t() const { return id_; }
  bool isGood() const { return id_ >= 0; }

 private:
  hid_t id_ = -1;
  Close close_ = nullptr;
};

/// The library's own account of errors goes to nobody: sentences are ours. Kept by thread.
void quiet() {
  thread_local const herr_t once = H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  (void)once;
}

Problems problemAt(const std::string& path, std::string sentence) {
  return {{std::move(sentence), {path}}};
}

/// The system's reason for the last failure, where it gave one.
std::string reason() {
  return errno != 0 ? std::string(": ") + std::strerror(errno) + "." : std::string(".");
}

hid_t typeOf(Kind kind) {
  switch (kind) {
    case Kind::Byte:
      return H5T_STD_U8LE;
    case Kind::Unsigned:
      return H5T_STD_U32LE;
    case Kind::Integer:
      return H5T_STD_I64LE;
    case Kind::Real:
      return H5T_IEEE_F64LE;
  }
  return -1;
}

bool writeText(hid_t object, const std::string& name, const std::string& text) {
  const Id type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type, std::max<std::size_t>(text.size(), 1));
  H5Tset_cset(type, H5T_CSET_UTF8);
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  const Id space(H5Screate(H5S_SCALAR), H5Sclose);
  const Id attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  std::string padded = text;
  padded.resize(std::max<std::size_t>(text.size(), 1));
  return attribute.isGood() && H5Awrite(attribute, type, padded.data()) >= 0;
}

template <class Number>
bool writeNumber(hid_t object, const std::string& name, hid_t type, hid_t memory, Number number) {
  const Id space(H5Screate(H5S_SCALAR), H5Sclose);
  const Id attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  return attribute.isGood() && H5Awrite(attribute, memory, &number) >= 0;
}

bool writeAttribute(hid_t object, const Attribute& attribute) {
  if (const auto* text = std::get_if<std::string>(&attribute.value)) return writeText(object, attribute.name, *text);
  if (const auto* integer = std::get_if<std::int64_t>(&attribute.value))
    return writeNumber(object, attribute.name, H5T_STD_I64LE, H5T_NATIVE_INT64, *integer);
  return writeNumber(object, attribute.name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, std::get<double>(attribute.value));
}

std::optional<Id> scalarAttribute(hid_t object, std::string_view name, H5T_class_t wanted) {
  quiet();
  Id attribute(H5Aopen(object, std::string(name).c_str(), H5P_DEFAULT), H5Aclose);
  if (!attribute.isGood()) return {};
  const Id type(H5Aget_type(attribute), H5Tclose);
  const Id space(H5Aget_space(attribute), H5Sclose);
  if (H5Tget_class(type) != wanted || H5Sget_simple_extent_npoints(space) != 1) return {};
  return attribute;
}

template <class Number>
std::optional<Number> numberOf(hid_t object, std::string_view name, H5T_class_t wanted, hid_t memory) {
  const std::optional<Id> attribute = scalarAttribute(object, name, wanted);
  Number number{};
  if (!attribute || H5Aread(*attribute, memory, &number) < 0) return {};
  return number;
}

/// A dataset that grows by rows of `width` numbers.
struct Store {
  Id id;
  Kind kind = Kind::Real;
  hsize_t width = 1;
  int rank() const { return width > 1 ? 2 : 1; }
};

hsize_t rowsOf(const Store& store) {
  const Id space(H5Dget_space(store.id), H5Sclose);
  hsize_t size[2] = {0, 0};
  if (!space.isGood() || H5Sget_simple_extent_dims(space, size, nullptr) != store.rank()) return 0;
  return std::min(size[0], kMostRows);
}

Store createStore(hid_t group, const Column& column, hsize_t chunk_rows) {
  Store store;
  store.kind = column.kind;
  store.width = static_cast<hsize_t>(column.width);
  const hsize_t none[2] = {0, store.width};
  const hsize_t most[2] = {H5S_UNLIMITED, store.width};
  const hsize_t chunk[2] = {chunk_rows, store.width};
  const Id space(H5Screate_simple(store.rank(), none, most), H5Sclose);
  const Id layout(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_chunk(layout, store.rank(), chunk);
  store.id = Id(
      H5Dcreate2(group, std::string(column.name).c_str(), typeOf(column.kind), space, H5P_DEFAULT, layout, H5P_DEFAULT),
      H5Dclose);
  if (store.id.isGood() && !(writeText(store.id, "unit", std::string(column.unit)) &&
                             writeText(store.id, "meaning", std::string(column.meaning))))
    store.id = Id();
  return store;
}

/// Not good where it is not there or of another kind.
Store openStore(hid_t group, const Column& column) {
  Store store;
  store.kind = column.kind;
  store.width = static_cast<hsize_t>(column.width);
  store.id = Id(H5Dopen2(group, std::string(column.name).c_str(), H5P_DEFAULT), H5Dclose);
  if (!store.id.isGood()) return store;
  const Id type(H5Dget_type(store.id), H5Tclose);
  const Id space(H5Dget_space(store.id), H5Sclose);
  hsize_t size[2] = {0, 1};
  const bool same = H5Tequal(type, typeOf(column.kind)) > 0 && H5Sget_simple_extent_ndims(space) == store.rank() &&
                    H5Sget_simple_extent_dims(space, size, nullptr) == store.rank() &&
                    (store.rank() == 1 || size[1] == store.width);
  if (!same) store.id = Id();
  return store;
}

bool resize(const Store& store, hsize_t rows) {
  const hsize_t size[2] = {rows, store.width};
  return H5Dset_extent(store.id, size) >= 0;
}

/// A file that is being recorded may be read by others and not be written, until this process ends, however it ends:
/// HDF5's own lock is gone once readers may follow.
class Presence {
 public:
  Presence() = default;
  explicit Presence(const std::string& path) : fd_(open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (fd_ >= 0) flock(fd_, LOCK_SH | LOCK_NB);
  }
  Presence(Presence&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  Presence& operator=(Presence&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  ~Presence() {
    if (fd_ >= 0) ::close(fd_);
  }

 private:
  int fd_ = -1;
};

/// Rows of a store selected, and memory for as many.
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

bool append(const Store& store, const void* data, hsize_t rows) {
  const hsize_t before = rowsOf(store);
  if (!resize(store, before + rows)) return false;
  const Selection selection(store, before, rows);
  return selection.good &&
         H5Dwrite(store.id, typeOf(store.kind), selection.memory, selection.file, H5P_DEFAULT, data) >= 0;
}

bool readRows(const Store& store, hsize_t first, hsize_t rows, void* data) {
  if (rows == 0) return true;
  const Selection selection(store, first, rows);
  return selection.good &&
         H5Dread(store.id, typeOf(store.kind), selection.memory, selection.file, H5P_DEFAULT, data) >= 0;
}

constexpr Column kCrc{"crc32", "", "CRC-32 of a block of rows, column after column", Kind::Unsigned, 1};

struct OpenTable {
  std::vector<Column> columns;
  std::vector<Store> stores;
  Store crc;
  std::int64_t block_rows = 1;
};

Id accessList() {
  Id access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110);  // what SWMR takes
  H5Pset_file_locking(access, true, true);                         // not where the file system knows no locks
  return access;
}

/// What a file says its size is, in its first bytes (version 3 of the superblock: 8 bytes from the 28th on); 0: it does
/// not say.
std::int64_t statedSize(const std::string& path) {
  std::array<char, 36> head{};
  std::ifstream file(path, std::ios::binary);
  if (!file.read(head.data(), head.size()) || head[8] != 3) return 0;
  std::int64_t size = 0;
  std::memcpy(&size, head.data() + 28, sizeof size);
  return size;
}

std::int64_t sizeOf(const std::string& path) {
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  return error ? 0 : static_cast<std::int64_t>(size);
}

/// A file that was cut off gets its length back, empty: what is missing then shows by its checksums.
void growToStatedSize(const std::string& path) {
  constexpr std::int64_t kLongest = std::int64_t{1} << 44;
  const std::int64_t stated = statedSize(path);
  std::error_code ignored;
  if (sizeOf(path) < stated && stated < kLongest)
    std::filesystem::resize_file(path, static_cast<std::uintmax_t>(stated), ignored);
}

std::string namesOf(std::span<const Column> columns) {
  std::string names;
  for (const Column& column : columns) names.append(names.empty() ? "" : ",").append(column.name);
  return names;
}

}  // namespace

struct Hdf5File::Impl {
  std::string path;
  Presence presence;
  Id file;
  std::vector<OpenTable> tables;
  bool writes = false, failed = false, full = false, elsewhere = false;
  std::int64_t set_aside = 0;  // the file may grow to this without asking the disk
  Problems failure;            // the first

  Problems fail(const std::string& sentence) {
    failed = true;
    failure = problemAt(path, sentence + reason());
    letBe();
    return failure;
  }
  /// From here on the library writes into nothing: what it has in memory is ahead of the disk, and half of it there
  /// would spoil what is whole.
  void letBe() {
    void* handle = nullptr;
    if (!writes || !file.isGood() || H5Fget_vfd_handle(file, H5P_DEFAULT, &handle) < 0) return;
    const int nothing = ::open("/dev/null", O_RDWR | O_CLOEXEC);
    if (nothing < 0) return;
    dup2(nothing, *static_cast<int*>(handle));
    ::close(nothing);
  }
  /// false: the disk has no room for so many bytes more. Where the file system cannot set room aside, it says so when
  /// the disk is full, and not before.
  bool setAside(std::int64_t bytes) {
    void* handle = nullptr;
    struct stat now {};
    if (H5Fget_vfd_handle(file, H5P_DEFAULT, &handle) < 0 || fstat(*static_cast<int*>(handle), &now) != 0) return true;
    if (now.st_size + bytes + kSetAsideAtLeast <= set_aside) return true;
    const off_t more = bytes + kSetAside;
    if (fallocate(*static_cast<int*>(handle), FALLOC_FL_KEEP_SIZE, now.st_size, more) != 0)
      return errno != ENOSPC && errno != EDQUOT;
    set_aside = now.st_size + more;
    return true;
  }
  bool createTable(const Table& wanted) {
    const Id group(H5Gcreate2(file, std::string(wanted.name).c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
    if (!group.isGood()) return false;
    OpenTable& table = tables.emplace_back();
    table.block_rows = wanted.block_rows;
    table.columns.assign(wanted.columns.begin(), wanted.columns.end());
    for (const Column& column : wanted.columns) {
      table.stores.push_back(createStore(group, column, static_cast<hsize_t>(wanted.chunk_rows)));
      if (!table.stores.back().id.isGood()) return false;
    }
    table.crc = createStore(group, kCrc, 64);
    return table.crc.id.isGood() && writeAttribute(group, {"columns", namesOf(wanted.columns)}) &&
           writeAttribute(group, {"block_rows", wanted.block_rows});
  }
  Problems openTables(std::span<const Table> wanted_tables) {
    for (const Table& wanted : wanted_tables) {
      const Id group(H5Gopen2(file, std::string(wanted.name).c_str(), H5P_DEFAULT), H5Gclose);
      const std::string name(wanted.name);
      if (!group.isGood())
        return problemAt(path, "This is no whole session: there is no table \"" + name + "\" in it.");
      OpenTable& table = tables.emplace_back();
      table.columns.assign(wanted.columns.begin(), wanted.columns.end());
      table.block_rows = numberOf<std::int64_t>(group, "block_rows", H5T_INTEGER, H5T_NATIVE_INT64).value_or(0);
      table.crc = openStore(group, kCrc);
      bool good = table.crc.id.isGood() && table.block_rows > 0 && table.block_rows <= 1'000'000;
      for (const Column& column : wanted.columns) {
        table.stores.push_back(openStore(group, column));
        good = good && table.stores.back().id.isGood();
      }
      if (!good) return problemAt(path, "This is no whole session: the table \"" + name + "\" is damaged.");
    }
    return {};
  }
};

Hdf5File::Hdf5File(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Hdf5File::Hdf5File(Hdf5File&&) noexcept = default;
Hdf5File& Hdf5File::operator=(Hdf5File&&) noexcept = default;
Hdf5File::~Hdf5File() {
  if (impl_) close();
}

Result<Hdf5File> Hdf5File::create(const std::string& path, std::span<const Attribute> attributes,
                                  std::span<const Table> tables) {
  quiet();
  errno = 0;
  auto impl = std::make_unique<Impl>();
  impl->path = path;
  impl->writes = true;
  const Id access = accessList();
  impl->file = Id(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose);
  if (!impl->file.isGood()) return impl->fail("The recording cannot be made");
  bool good = true;
  for (const Attribute& attribute : attributes) good = good && writeAttribute(impl->file, attribute);
  for (const Table& table : tables) good = good && impl->createTable(table);
  good = good && H5Fstart_swmr_write(impl->file) >= 0;
  if (!good) return impl->fail("The recording cannot be made");
  impl->presence = Presence(path);
  return Hdf5File(std::move(impl));
}

Result<Hdf5File> Hdf5File::open(const std::string& path, std::span<const Table> tables) {
  quiet();
  auto impl = std::make_unique<Impl>();
  impl->path = path;
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return problemAt(path, "There is no such file.");
  const Id access = accessList();
  impl->file = Id(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access), H5Fclose);
  if (!impl->file.isGood()) {
    H5Pset_metadata_read_attempts(access, kAttempts);
    impl->file = Id(H5Fopen(path.c_str(), H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, access), H5Fclose);
    impl->elsewhere = true;
  }
  if (!impl->file.isGood() && sizeOf(path) < statedSize(path))
    return problemAt(path, "This file is cut off: " + std::to_string(sizeOf(path)) + " of " +
                               std::to_string(statedSize(path)) +
                               " bytes are there. Copy it again from where it came.");
  if (!impl->file.isGood()) return problemAt(path, "This is no session, or one that is damaged at its beginning.");
  Problems problems = impl->openTables(tables);
  if (!problems.empty()) return problems;
  return Hdf5File(std::move(impl));
}

Result<Hdf5File> Hdf5File::reopen(const std::string& path, std::span<const Table> tables, bool killed) {
  quiet();
  errno = 0;
  auto impl = std::make_unique<Impl>();
  impl->path = path;
  impl->writes = true;
  const Id access = accessList();
  if (killed) growToStatedSize(path);
  const hbool_t clear = killed;
  H5Pset(access, "clear_status_flags", &clear);  // as h5clear does
  impl->file = Id(H5Fopen(path.c_str(), H5F_ACC_RDWR, access), H5Fclose);
  if (!impl->file.isGood()) {
    if (errno == EWOULDBLOCK) return problemAt(path, "Another program has this file open. Close it there first.");
    return impl->fail("The file cannot be opened for writing");
  }
  Problems problems = impl->openTables(tables);
  if (!problems.empty()) return problems;
  return Hdf5File(std::move(impl));
}

Problems Hdf5File::append(std::size_t table, const Block& block) {
  if (impl_->failed || block.rows == 0) return impl_->failure;
  quiet();
  impl_->full = impl_->full || !impl_->setAside(static_cast<std::int64_t>(block.bytes.size()));
  if (impl_->full)
    return problemAt(impl_->path,
                     "The disk is full: the recording was stopped and is whole. Free some space, or record into "
                     "another folder.");
  return appendLast(table, block);
}

bool Hdf5File::isFull() const {
  return impl_->full;
}

Problems Hdf5File::appendLast(std::size_t table, const Block& block) {
  if (impl_->failed || block.rows == 0) return impl_->failure;
  quiet();
  errno = 0;
  const OpenTable& open = impl_->tables[table];
  const auto rows = static_cast<hsize_t>(block.rows);
  const std::byte* data = block.bytes.data();
  bool good = true;
  for (std::size_t column = 0; column < open.stores.size(); ++column) {
    good = good && record::append(open.stores[column], data, rows);
    data += rows * bytesOf(open.columns[column]);
  }
  const std::size_t block_bytes = open.columns.size() == 1
                                      ? static_cast<std::size_t>(open.block_rows) * bytesOf(open.columns[0])
                                      : block.bytes.size();
  for (std::size_t at = 0; at < block.bytes.size(); at += block_bytes) {
    const std::size_t size = std::min(block_bytes, block.bytes.size() - at);
    const std::uint32_t crc = crcOf(std::span(block.bytes).subspan(at, size));
    good = good && record::append(open.crc, &crc, 1);
  }
  return good ? Problems{} : impl_->fail("The recording stopped");
}

Problems Hdf5File::flush() {
  if (impl_->failed) return impl_->failure;
  quiet();
  errno = 0;
  return H5Fflush(impl_->file, H5F_SCOPE_GLOBAL) >= 0 ? Problems{} : impl_->fail("The recording stopped");
}

Problems Hdf5File::cut(std::size_t table, std::int64_t rows) {
  quiet();
  errno = 0;
  const OpenTable& open = impl_->tables[table];
  const auto wanted = static_cast<hsize_t>(rows);
  const auto block_rows = static_cast<hsize_t>(open.block_rows);
  bool good = resize(open.crc, (wanted + block_rows - 1) / block_rows);
  for (const Store& store : open.stores) good = good && resize(store, wanted);
  return good ? Problems{} : impl_->fail("The file could not be cut to what is whole");
}

Problems Hdf5File::set(const Attribute& attribute) {
  quiet();
  errno = 0;
  if (H5Aexists(impl_->file, attribute.name.c_str()) > 0) H5Adelete(impl_->file, attribute.name.c_str());
  return writeAttribute(impl_->file, attribute) ? Problems{} : impl_->fail("The file takes no change");
}

Problems Hdf5File::close() {
  quiet();
  errno = 0;
  bool good = true;
  for (OpenTable& table : impl_->tables) {
    for (Store& store : table.stores) good = store.id.close() && good;
    good = table.crc.id.close() && good;
  }
  impl_->tables.clear();
  good = impl_->file.close() && good;
  if (impl_->set_aside > 0) {  // gives back what was set aside and not used
    std::error_code ignored;
    std::filesystem::resize_file(impl_->path, static_cast<std::uintmax_t>(sizeOf(impl_->path)), ignored);
  }
  if (good || !impl_->writes || impl_->failed) return {};
  return impl_->fail("The recording is not whole");
}

std::int64_t Hdf5File::rows(std::size_t table) {
  const OpenTable& open = impl_->tables[table];
  hsize_t rows = rowsOf(open.crc) * static_cast<hsize_t>(open.block_rows);
  for (const Store& store : open.stores) rows = std::min(rows, rowsOf(store));
  return static_cast<std::int64_t>(rows);
}

std::int64_t Hdf5File::blockRows(std::size_t table) const {
  return impl_->tables[table].block_rows;
}

Result<std::vector<Block>> Hdf5File::read(std::size_t table, std::int64_t first, std::int64_t count) {
  quiet();
  const OpenTable& open = impl_->tables[table];
  const std::int64_t all = rows(table), block_rows = open.block_rows;
  if (first < 0 || count <= 0) return std::vector<Block>{};
  const std::int64_t begin = std::min(first * block_rows, all);
  const std::int64_t end = std::min(all, (first + count) * block_rows);
  if (end <= begin) return std::vector<Block>{};
  const auto blocks = static_cast<std::size_t>((end - begin + block_rows - 1) / block_rows);
  std::vector<std::uint32_t> crcs(blocks);
  const auto damaged = [&] { return problemAt(impl_->path, "The file is damaged and cannot be read on."); };
  if (!readRows(open.crc, static_cast<hsize_t>(first), blocks, crcs.data())) return damaged();
  std::vector<std::vector<std::byte>> columns;
  for (std::size_t column = 0; column < open.stores.size(); ++column) {
    std::vector<std::byte>& bytes =
        columns.emplace_back(static_cast<std::size_t>(end - begin) * bytesOf(open.columns[column]));
    if (!readRows(open.stores[column], static_cast<hsize_t>(begin), static_cast<hsize_t>(end - begin), bytes.data()))
      return damaged();
  }
  std::vector<Block> read(blocks);
  for (std::size_t index = 0; index < blocks; ++index) {
    const std::int64_t row = static_cast<std::int64_t>(index) * block_rows;
    Block& block = read[index];
    block.rows = std::min(block_rows, end - begin - row);
    for (std::size_t column = 0; column < columns.size(); ++column) {
      const std::size_t one = bytesOf(open.columns[column]);
      const std::byte* const from = columns[column].data() + static_cast<std::size_t>(row) * one;
      block.bytes.insert(block.bytes.end(), from, from + static_cast<std::size_t>(block.rows) * one);
    }
    if (crcOf(block.bytes) != crcs[index]) block.bytes.clear();
  }
  return read;
}

void Hdf5File::refresh() {
  quiet();
  for (const OpenTable& table : impl_->tables) {
    for (const Store& store : table.stores) H5Drefresh(store.id);
    H5Drefresh(table.crc.id);
  }
}

std::string Hdf5File::text(std::string_view attribute) const {
  const std::optional<Id> open = scalarAttribute(impl_->file, attribute, H5T_STRING);
  if (!open) return {};
  const Id type(H5Aget_type(*open), H5Tclose);
  const std::size_t size = H5Tget_size(type);
  if (H5Tis_variable_str(type) != 0 || size > kLongestText) return {};
  std::string text(size, '\0');
  if (H5Aread(*open, type, text.data()) < 0) return {};
  text.resize(std::min(text.find('\0'), text.size()));
  return text;
}

std::int64_t Hdf5File::integer(std::string_view attribute, std::int64_t fallback) const {
  return numberOf<std::int64_t>(impl_->file, attribute, H5T_INTEGER, H5T_NATIVE_INT64).value_or(fallback);
}

double Hdf5File::real(std::string_view attribute, double fallback) const {
  return numberOf<double>(impl_->file, attribute, H5T_FLOAT, H5T_NATIVE_DOUBLE).value_or(fallback);
}

bool Hdf5File::isOpenElsewhere() const {
  return impl_->elsewhere;
}

}  // namespace underact::record
