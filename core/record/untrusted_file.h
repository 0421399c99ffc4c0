#pragma once
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/record/table.h"
#include "core/system/descriptor.h"

namespace underact::record {

/// A file from elsewhere, open for reading: what is checked and what is then read are the same file, whatever is put in
/// its place meanwhile.
class UntrustedInput {
 public:
  /// follows: whether path may be a link. Problems: no such file, not a regular file, or locked by another program that
  /// writes it.
  static Result<UntrustedInput> open(const std::string& path, bool follows = true);
  int fd() const { return file_.number(); }
  const std::string& path() const { return path_; }
  /// Its size now; 0 where the system does not tell.
  std::int64_t bytes() const;
  /// Releases the lock, so that others may write the file.
  void unlock() const;

 private:
  UntrustedInput(std::string path, system::Descriptor file) : path_(std::move(path)), file_(std::move(file)) {}
  std::string path_;
  system::Descriptor file_;
};

/// The reading side of Hdf5File for files that may come from anybody. The HDF5 library does not read them in this
/// process but in underact-session-reader, which is sealed off from everything else: whatever a file does to it stays
/// there, and is a problem here. Every count and length of an answer is checked. Each open file has a process of its
/// own, so that several threads may each read one; one thread at a time.
class UntrustedFile {
 public:
  /// at_least: see accessThrough(). Problems: as Hdf5File::open(); the reader is missing (UNDERACT_SESSION_READER says
  /// where it is), could not be sealed off, ended early, took too long.
  static Result<UntrustedFile> open(std::shared_ptr<const UntrustedInput> input, std::span<const Table> tables,
                                    std::int64_t at_least = 0);
  // One that was moved from may only be assigned to or destroyed.
  UntrustedFile(UntrustedFile&&) noexcept;
  UntrustedFile& operator=(UntrustedFile&&) noexcept;
  ~UntrustedFile();

  // As in Hdf5File.
  std::int64_t rows(std::size_t table) const;
  std::int64_t blockRows(std::size_t table) const;
  Result<std::vector<Block>> read(std::size_t table, std::int64_t first, std::int64_t count);
  void refresh();
  std::string text(std::string_view attribute);
  std::int64_t integer(std::string_view attribute, std::int64_t fallback);
  double real(std::string_view attribute, double fallback);
  bool isOpenElsewhere() const;

 private:
  struct Impl;
  explicit UntrustedFile(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace underact::record
