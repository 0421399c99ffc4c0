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

/// Tables in an HDF5 file, with one writer and many concurrent readers (SWMR). One thread at a time. Problems are
/// sentences for users; their place is the file. Tables that this program would not write are refused: another layout
/// (see openStore()), more rows than the file can hold. For files from elsewhere: see UntrustedFile.
class Hdf5File {
 public:
  ~Hdf5File();
  // One that was moved from may only be assigned to or destroyed.
  Hdf5File(Hdf5File&&) noexcept;
  Hdf5File& operator=(Hdf5File&&) noexcept;

  /// A new file that only its owner may read and write; from then on readers may follow it. Problems: those of
  /// checkNew(); it cannot be created.
  static Result<Hdf5File> create(const std::string& path, std::span<const Attribute> attributes,
                                 std::span<const Table> tables, system::Existing existing = system::Existing::Refuse);
  /// For reading, even while another program writes it or after that program was killed. tables: those that must exist
  /// with exactly these columns; their block_rows are read from the file. Problems: no such file, not HDF5, damaged.
  static Result<Hdf5File> open(const std::string& path, std::span<const Table> tables);
  /// Opens a file that is open at a descriptor, which outlives this object; no other file is opened, whatever
  /// the file refers to. at_least: see accessThrough().
  static Result<Hdf5File> openAt(int fd, std::span<const Table> tables, std::int64_t at_least = 0);
  /// For appending, by one process alone. killed: remove the mark left by a killed writer. fd: unless below 0, the file
  /// at path must be the one that is open there. Problems: also where another program is recording into it.
  static Result<Hdf5File> reopen(const std::string& path, std::span<const Table> tables, bool killed, int fd = -1);

  /// Writer: appends a block to a table, whose earlier blocks are all full; to a table of one column any number of
  /// them. Problems: the disk is full or failed; then nothing further is written, and each call says so.
  Problems append(std::size_t table, const Block& block);
  /// Whether the disk had no room for the last block: append() takes no more, and what was written is intact.
  bool isFull() const;
  /// Writer: the same into the space reserved for the end, also on a full disk.
  Problems appendLast(std::size_t table, const Block& block);
  /// Writer: makes what was appended readable by others; it then outlives this process.
  Problems flush();
  /// After reopen(): truncates a table to so many rows.
  Problems cut(std::size_t table, std::int64_t rows);
  /// After reopen(): replaces an attribute.
  Problems set(const Attribute& attribute);
  /// Closes the file. Problems: what is in memory could not be written. The destructor closes, too, and reports
  /// nothing.
  Problems close();

  /// Reader: the rows that all columns have now, with a checksum for each of their blocks.
  std::int64_t rows(std::size_t table);
  /// Rows of a block of that table, as its file has them. table: an index of the tables it was opened with.
  std::int64_t blockRows(std::size_t table) const;
  /// Reader: whole blocks from first on, at most count; a damaged one has no bytes. Problems: the file cannot be read.
  Result<std::vector<Block>> read(std::size_t table, std::int64_t first, std::int64_t count);
  /// Reader: takes in what was written since.
  void refresh();
  /// Reader: a text attribute; empty where it is missing or of another type.
  std::string text(std::string_view attribute) const;
  /// A whole number; the fallback where it is missing or of another type.
  std::int64_t integer(std::string_view attribute, std::int64_t fallback) const;
  /// As integer().
  double real(std::string_view attribute, double fallback) const;
  /// Whether the file was not closed by its writer when it was opened.
  bool isOpenElsewhere() const;

 private:
  struct Impl;
  explicit Hdf5File(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace underact::record
