#include "core/record/hdf5_file.h"

#include <hdf5.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "core/base/translate.h"
#include "core/record/descriptor_driver.h"
#include "core/record/disk.h"
#include "core/record/hdf5_table.h"
#include "core/system/file.h"
#include "core/system/named_file.h"

namespace underact::record {
namespace {

// What a writer is just changing is read again, after a pause that doubles each time: 24 times take 20 ms. The
// library's own 100 would never end where the file is damaged.
constexpr unsigned kAttempts = 24;
// A new session needs less. A file that is full before that cannot be closed.
constexpr std::int64_t kToBegin = 256 << 10;

Problems problemAt(const std::string& path, Sentence sentence) {
  return {{std::move(sentence), {path}}};
}

/// The system's reason for the last failure, if it gave one.
Sentence reason() {
  if (errno != 0) return std::strerror(errno);
  return phrase(TRANSLATE_NOOP("problem", "the HDF5 library gives no reason"));
}

/// None: the file exists. The library would wait for the writer of a pipe.
Problems notThere(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error))
    return problemAt(path, phrase(TRANSLATE_NOOP("problem", "There is no such file.")));
  const Result<system::NamedFile> file = system::NamedFile::open(path, phrase(TRANSLATE_NOOP("problem", "a session")));
  return file ? Problems{} : file.problems();
}

Id accessList(bool locks = true) {
  Id access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110);  // what SWMR takes
  H5Pset_file_locking(access, locks, true);                        // not on file systems without locks
  return access;
}

}  // namespace

struct Hdf5File::Impl {
  std::string path;    // as the user knows it
  std::string opened;  // and as the system does
  bool by_descriptor = false;
  std::int64_t at_least = 0;  // see accessThrough()
  RecordingLock presence;
  Id file;
  std::vector<OpenTable> tables;
  bool writes = false, failed = false, full = false, elsewhere = false;
  DiskReserve set_aside;
  std::int64_t unflushed_bytes = 0;  // in the library's memory, not yet in the size of the file
  Problems failure;                  // the first

  /// Remembers a failure. pattern: with a placeholder for the reason.
  Problems fail(const char* pattern) {
    failed = true;
    failure = problemAt(path, phrase(pattern, {reason()}));
    letBe();
    return failure;
  }
  /// The file's descriptor, or -1.
  int descriptor() const {
    void* handle = nullptr;
    return file.isGood() && H5Fget_vfd_handle(file, H5P_DEFAULT, &handle) >= 0 ? *static_cast<int*>(handle) : -1;
  }
  /// Makes the library write to nothing from here on: what it has in memory is ahead of the disk, and a half-written
  /// part would damage what is intact.
  void letBe() const {
    if (writes && descriptor() >= 0) system::redirectToNull(descriptor());
  }
  /// The size of the file now.
  std::int64_t bytes() const {
    return by_descriptor ? std::max(system::lengthOf(descriptor()), at_least) : sizeOf(opened);
  }
  Problems openTables(std::span<const Table> wanted_tables) {
    for (const Table& wanted : wanted_tables) {
      const std::string name(wanted.name);
      if (wanted.presence != Presence::Always && !isOwn(file, name)) {
        tables.push_back(absentTable(wanted));
        continue;
      }
      const Id group(isOwn(file, name) ? H5Gopen2(file, name.c_str(), H5P_DEFAULT) : -1, H5Gclose);
      if (!group.isGood())
        return problemAt(
            path, phrase(TRANSLATE_NOOP("problem", "This session is incomplete: it has no table \"%1\"."), {name}));
      std::optional<OpenTable> table = openTable(group, wanted, writes, bytes());
      if (!table)
        return problemAt(
            path,
            phrase(TRANSLATE_NOOP("problem", "This session is incomplete: the table \"%1\" is damaged."), {name}));
      tables.push_back(std::move(*table));
    }
    return {};
  }
  /// Opens for reading, as a closed file or else as one that is being written. access: prepared.
  Problems openToRead(const char* name, Handle access, std::int64_t there, std::int64_t stated) {
    file = Id(H5Fopen(name, H5F_ACC_RDONLY, access), H5Fclose);
    if (!file.isGood()) {
      H5Pset_metadata_read_attempts(access, kAttempts);
      file = Id(H5Fopen(name, H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, access), H5Fclose);
      elsewhere = true;
    }
    return file.isGood() ? Problems{} : noSessionReason(there, stated);
  }
  Problems noSessionReason(std::int64_t there, std::int64_t stated) const {
    if (there < stated)
      return problemAt(
          path,
          phrase(TRANSLATE_NOOP("problem",
                                "This file is truncated: it has %1 of %2 bytes. Copy it again from where it came."),
                 {std::to_string(there), std::to_string(stated)}));
    return problemAt(path, phrase(TRANSLATE_NOOP("problem", "This is not a session, or its beginning is damaged.")));
  }
};

Hdf5File::Hdf5File(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Hdf5File::Hdf5File(Hdf5File&&) noexcept = default;
Hdf5File& Hdf5File::operator=(Hdf5File&&) noexcept = default;
Hdf5File::~Hdf5File() {
  if (impl_) close();
}

Result<Hdf5File> Hdf5File::create(const std::string& path, std::span<const Attribute> attributes,
                                  std::span<const Table> tables, system::Existing existing) {
  quiet();
  errno = 0;
  auto impl = std::make_unique<Impl>();
  impl->path = impl->opened = path;
  impl->writes = true;
  if (Problems problems = system::checkNew(path, existing); !problems.empty()) return problems;
  if (existing == system::Existing::Replace && RecordingLock::isAt(path))
    return problemAt(
        path, phrase(TRANSLATE_NOOP("problem", "Another program is recording into this file. Give another name.")));
  const system::Descriptor made = system::makeNew(path, existing);  // the library would let others read it
  const auto cannotStart = [&] {
    Problems problems = impl->fail(TRANSLATE_NOOP("problem", "The recording cannot be started: %1."));
    std::error_code ignored;  // it is empty, and would be in the way of the next attempt
    if (made.isOpen()) std::filesystem::remove(path, ignored);
    return problems;
  };
  if (!made.isOpen() || system::cutTo(made.number(), kToBegin) != 0 ||
      system::setAside(made.number(), 0, kToBegin) == system::Room::None)
    return cannotStart();
  // The library holds a lock until readers may follow, takes it once more just then, and cannot close the file if
  // another program, such as a file manager, got it in between. Our own lock informs the others.
  const Id access = accessList(false);
  impl->file = Id(H5Fcreate(system::nameOf(made.number(), path).c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose);
  bool good = impl->file.isGood();
  for (const Attribute& attribute : attributes) good = good && writeAttribute(impl->file, attribute);
  for (const Table& wanted : tables) {
    if (!wanted.is_made) {
      impl->tables.push_back(absentTable(wanted));
      continue;
    }
    std::optional<OpenTable> table = good ? createTable(impl->file, wanted) : std::nullopt;
    good = table.has_value();
    if (good) impl->tables.push_back(std::move(*table));
  }
  good = good && H5Fstart_swmr_write(impl->file) >= 0;
  if (!good) return cannotStart();
  impl->presence = RecordingLock(path);
  return Hdf5File(std::move(impl));
}

Result<Hdf5File> Hdf5File::open(const std::string& path, std::span<const Table> tables) {
  quiet();
  auto impl = std::make_unique<Impl>();
  impl->path = impl->opened = path;
  Problems problems = notThere(path);
  if (problems.empty()) problems = impl->openToRead(path.c_str(), accessList(), sizeOf(path), statedSize(path));
  if (problems.empty()) problems = impl->openTables(tables);
  if (!problems.empty()) return problems;
  return Hdf5File(std::move(impl));
}

Result<Hdf5File> Hdf5File::openAt(int fd, std::span<const Table> tables, std::int64_t at_least) {
  quiet();
  auto impl = std::make_unique<Impl>();
  impl->by_descriptor = true;
  impl->at_least = at_least;
  const Id access = accessList();
  const std::int64_t there = std::max(system::lengthOf(fd), at_least);
  Problems problems = accessThrough(access, fd, at_least) ? impl->openToRead(kGivenFile, access, there, statedSize(fd))
                                                          : impl->noSessionReason(0, 0);
  if (problems.empty()) problems = impl->openTables(tables);
  if (!problems.empty()) return problems;
  return Hdf5File(std::move(impl));
}

Result<Hdf5File> Hdf5File::reopen(const std::string& path, std::span<const Table> tables, bool killed, int fd) {
  quiet();
  errno = 0;
  auto impl = std::make_unique<Impl>();
  impl->path = impl->opened = path;
  if (fd >= 0) impl->opened = system::nameOf(fd, path);
  impl->writes = true;
  if (Problems problems = notThere(path); !problems.empty()) return problems;
  const Id access = accessList();
  if (killed) growToStatedSize(impl->opened);
  const hbool_t clear = killed;
  H5Pset(access, "clear_status_flags", &clear);  // as h5clear does
  impl->file = Id(H5Fopen(impl->opened.c_str(), H5F_ACC_RDWR, access), H5Fclose);
  if (!impl->file.isGood()) {
    if (RecordingLock::isAt(impl->opened))  // not by errno: HDF5 1.14 asks for other things after the lock was refused
      return problemAt(path,
                       phrase(TRANSLATE_NOOP("problem", "Another program has this file open. Close it there first.")));
    return impl->fail(TRANSLATE_NOOP("problem", "The file cannot be opened for writing: %1."));
  }
  if (fd >= 0 && !system::isSameFile(system::statusOf(fd), system::statusOf(impl->descriptor())))
    return problemAt(
        path,
        phrase(TRANSLATE_NOOP(
            "problem", "Another file has taken this one's place in the meantime, so nothing was changed. Try again.")));
  // A killed writer's file is longer than it states; new data must not be written over its end.
  if (killed && H5Fincrement_filesize(impl->file, 0) < 0)
    return impl->fail(TRANSLATE_NOOP("problem", "The file cannot be opened for writing: %1."));
  Problems problems = impl->openTables(tables);
  if (!problems.empty()) return problems;
  return Hdf5File(std::move(impl));
}

Problems Hdf5File::append(std::size_t table, const Block& block) {
  if (impl_->failed || block.rows == 0) return impl_->failure;
  quiet();
  impl_->unflushed_bytes += static_cast<std::int64_t>(block.bytes.size());
  impl_->full = impl_->full || !impl_->set_aside.reserve(impl_->unflushed_bytes, impl_->descriptor());
  if (impl_->full)
    return problemAt(impl_->path,
                     phrase(TRANSLATE_NOOP("problem",
                                           "The disk is full: the recording was stopped, and everything up to then was "
                                           "saved. Free some space, or record into another folder.")));
  return appendLast(table, block);
}

bool Hdf5File::isFull() const {
  return impl_->full;
}

Problems Hdf5File::appendLast(std::size_t table, const Block& block) {
  if (impl_->failed || block.rows == 0) return impl_->failure;
  quiet();
  errno = 0;
  return appendBlock(impl_->tables[table], block)
             ? Problems{}
             : impl_->fail(TRANSLATE_NOOP("problem", "The recording stopped: %1."));
}

Problems Hdf5File::flush() {
  if (impl_->failed) return impl_->failure;
  quiet();
  errno = 0;
  impl_->unflushed_bytes = 0;
  return H5Fflush(impl_->file, H5F_SCOPE_GLOBAL) >= 0
             ? Problems{}
             : impl_->fail(TRANSLATE_NOOP("problem", "The recording stopped: %1."));
}

Problems Hdf5File::cut(std::size_t table, std::int64_t rows) {
  quiet();
  errno = 0;
  return cutTo(impl_->tables[table], rows)
             ? Problems{}
             : impl_->fail(TRANSLATE_NOOP("problem", "The file could not be trimmed to its intact part: %1."));
}

Problems Hdf5File::set(const Attribute& attribute) {
  quiet();
  errno = 0;
  if (H5Aexists(impl_->file, attribute.name.c_str()) > 0) H5Adelete(impl_->file, attribute.name.c_str());
  return writeAttribute(impl_->file, attribute)
             ? Problems{}
             : impl_->fail(TRANSLATE_NOOP("problem", "The file cannot be changed: %1."));
}

Problems Hdf5File::close() {
  quiet();
  errno = 0;
  bool good = true;
  for (OpenTable& table : impl_->tables) good = record::close(table) && good;
  impl_->tables.clear();
  good = impl_->file.close() && good;
  impl_->set_aside.giveBack(impl_->opened);
  if (good || !impl_->writes || impl_->failed) return {};
  return impl_->fail(TRANSLATE_NOOP("problem", "The recording is incomplete: %1."));
}

std::int64_t Hdf5File::rows(std::size_t table) {
  const OpenTable& open = impl_->tables[table];
  return std::min(rowsOf(open), maxRows(open, impl_->bytes()));
}

std::int64_t Hdf5File::blockRows(std::size_t table) const {
  return impl_->tables[table].block_rows;
}

Result<std::vector<Block>> Hdf5File::read(std::size_t table, std::int64_t first, std::int64_t count) {
  quiet();
  const OpenTable& open = impl_->tables[table];
  const auto [begin, end] = rangeOf(first, count, open.block_rows, rows(table));
  if (end <= begin) return std::vector<Block>{};
  std::optional<std::vector<Block>> blocks = readBlocks(open, begin, end);
  if (!blocks)
    return problemAt(impl_->path,
                     phrase(TRANSLATE_NOOP("problem", "The file is damaged, and the rest cannot be read.")));
  return std::move(*blocks);
}

void Hdf5File::refresh() {
  quiet();
  for (const OpenTable& table : impl_->tables) record::refresh(table);
}

std::string Hdf5File::text(std::string_view attribute) const {
  quiet();
  return textAttribute(impl_->file, attribute).value_or(std::string());
}

std::int64_t Hdf5File::integer(std::string_view attribute, std::int64_t fallback) const {
  quiet();
  return integerAttribute(impl_->file, attribute).value_or(fallback);
}

double Hdf5File::real(std::string_view attribute, double fallback) const {
  quiet();
  return realAttribute(impl_->file, attribute).value_or(fallback);
}

bool Hdf5File::isOpenElsewhere() const {
  return impl_->elsewhere;
}

}  // namespace underact::record
