#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/record/hdf5_id.h"
#include "core/record/table.h"
#include "core/system/private_file.h"

namespace underact::record {

/// Tables in an HDF5 file, written by one and read by many at the same time (SWMR). One thread at a time. The sentences
/// of problems are for the user; their place is the file. Tables that this program would not write are refused: their
/// layout (see openStore()), more rows than a file of its length can hold. For untrusted files see ForeignFile.
class Hdf5File {
 public:
  ~Hdf5File();
  Hdf5File(Hdf5File&&) noexcept;
  Hdf5File& operator=(Hdf5File&&) noexcept;

  /// A new file that only its owner may read and write; from then on readers may follow it. Problems: those of
  /// checkNew(); it cannot be created.
  static Result<Hdf5File> create(const std::string& path, std::span<const Attribute> attributes,
                                 std::span<const Table> tables, system::Existing existing = system::Existing::Refuse);
  /// For reading, even while another program writes it or after that program was killed. tables: those that must exist
  /// with exactly these columns; their block_rows are read from the file. Problems: no such file, not HDF5, damaged.
  static Result<Hdf5File> open(const std::string& path, std::span<const Table> tables);
  /// The same for a file that is open at a descriptor, which must outlive this object; no other file is opened,
  /// whatever this one says. at_least: see accessThrough().
  static Result<Hdf5File> openAt(int fd, std::span<const Table> tables, std::int64_t at_least = 0);
  /// For appending, exclusively. killed: removes the mark that a killed writer left. fd: if not below 0, the file at
  /// path must be the one open there. Problems: also if another program is recording into it.
  static Result<Hdf5File> reopen(const std::string& path, std::span<const Table> tables, bool killed, int fd = -1);

  /// Writer: a block at the end of a table, all blocks before it being full; to a table of one column any number of
  /// them. Problems: the disk is full; then nothing further is written, and each call says so.
  Problems append(std::size_t table, const Block& block);
  /// The disk had no space for the last block: append() accepts no more, and what was written is intact.
  bool isFull() const;
  /// Writer: the same into the space reserved for the end, even on a full disk.
  Problems appendLast(std::size_t table, const Block& block);
  /// Writer: what was appended can be read by others, and outlives this process.
  Problems flush();
  /// reopen(): truncates a table to that many rows.
  Problems cut(std::size_t table, std::int64_t rows);
  /// reopen(): rewrites an attribute.
  Problems set(const Attribute& attribute);
  /// Problems: what is in memory could not be written. The destructor closes, too, but reports nothing.
  Problems close();

  /// Reader: rows that all columns have at present, with a checksum for each of their blocks.
  std::int64_t rows(std::size_t table);
  std::int64_t blockRows(std::size_t table) const;
  /// Reader: whole blocks from first on, at most count; a damaged one has no bytes. Problems: the file cannot be read.
  Result<std::vector<Block>> read(std::size_t table, std::int64_t first, std::int64_t count);
  /// Reader: takes in what was written since.
  void refresh();
  /// Reader. The fallback if it is missing or of another kind.
  std::string text(std::string_view attribute) const;
  std::int64_t integer(std::string_view attribute, std::int64_t fallback) const;
  double real(std::string_view attribute, double fallback) const;
  /// A writer had not closed the file when it was opened.
  bool isOpenElsewhere() const;

 private:
  struct Impl;
  explicit Hdf5File(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace underact::record
