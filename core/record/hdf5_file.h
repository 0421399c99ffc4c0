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

/// Tables in an HDF5 file, written by one and read by many at the same time (SWMR). Any one thread at a time. Sentences
/// of problems are the user's; their place is the file. Tables that this program would not write so are refused: their
/// layout (see openStore()), rows beyond what a file of its length can hold. Files of strangers: see ForeignFile.
class Hdf5File {
 public:
  ~Hdf5File();
  // One that was moved from may only be assigned to or destroyed.
  Hdf5File(Hdf5File&&) noexcept;
  Hdf5File& operator=(Hdf5File&&) noexcept;

  /// A new file that its owner alone may read and write; from then on readers may follow it. Problems: those of
  /// checkNew(); it cannot be made.
  static Result<Hdf5File> create(const std::string& path, std::span<const Attribute> attributes,
                                 std::span<const Table> tables, system::Existing existing = system::Existing::Refuse);
  /// For reading, also while another program writes it or after that one was killed. tables: those that must be there
  /// with just these columns; their block_rows are read from the file. Problems: no such file, not HDF5, damaged.
  static Result<Hdf5File> open(const std::string& path, std::span<const Table> tables);
  /// The same of a file that is open at a descriptor, which outlives this object; no other file is opened, whatever it
  /// says. at_least: see accessThrough().
  static Result<Hdf5File> openAt(int fd, std::span<const Table> tables, std::int64_t at_least = 0);
  /// For writing on, alone. killed: the mark that a killed writer left is taken away. fd: where not below 0, the file
  /// at path must be the one that is open there. Problems: also where another program is recording into it.
  static Result<Hdf5File> reopen(const std::string& path, std::span<const Table> tables, bool killed, int fd = -1);

  /// Writer: a block at the end of a table, all those before it being full; to a table of one column any number of
  /// them. Problems: the disk takes no more; then nothing further is written, and each call says so.
  Problems append(std::size_t table, const Block& block);
  /// The disk had no room for the last block: append() takes no more, and what was written is whole.
  bool isFull() const;
  /// Writer: the same into what is set aside for the end, also on a disk that is full.
  Problems appendLast(std::size_t table, const Block& block);
  /// Writer: what was appended can be read by others, and outlives this process.
  Problems flush();
  /// reopen(): cuts a table to so many rows.
  Problems cut(std::size_t table, std::int64_t rows);
  /// reopen(): writes an attribute anew.
  Problems set(const Attribute& attribute);
  /// Problems: what is in memory could not be written. The destructor closes, too, and says nothing.
  Problems close();

  /// Reader: rows that all columns have, as of now, with a checksum for each of their blocks.
  std::int64_t rows(std::size_t table);
  /// Rows of a block of that table, as its file has them. table: an index of the tables it was opened with.
  std::int64_t blockRows(std::size_t table) const;
  /// Reader: whole blocks, from first on, at most count; a damaged one has no bytes. Problems: the file cannot be read.
  Result<std::vector<Block>> read(std::size_t table, std::int64_t first, std::int64_t count);
  /// Reader: sees what was written since.
  void refresh();
  /// Reader. Not there, or of another kind: the fallback.
  std::string text(std::string_view attribute) const;
  /// The same of a whole number, and of a real one.
  std::int64_t integer(std::string_view attribute, std::int64_t fallback) const;
  /// As integer().
  double real(std::string_view attribute, double fallback) const;
  /// The file was opened as one that a writer has not closed.
  bool isOpenElsewhere() const;

 private:
  struct Impl;
  explicit Hdf5File(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace underact::record
