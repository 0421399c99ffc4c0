#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

#include "core/base/result.h"
#include "core/system/descriptor.h"

namespace underact::system {

/// A regular file named by a person or another file, open for reading. Opening never waits: a pipe would wait for its
/// writer, and a device may start to operate. Those and sockets are refused without being opened, also at the end of
/// links.
class NamedFile {
 public:
  /// what: for the sentences, as "a scene". Problems: one, at path without a line: it does not exist, is a folder, or
  /// not a regular file.
  static Result<NamedFile> open(const std::string& path, const Sentence& what);
  const std::string& path() const { return path_; }
  /// Its size when it was opened.
  std::uint64_t bytes() const { return bytes_; }
  /// The descriptor; this object closes it.
  int descriptor() const { return file_.number(); }
  /// Moves the position of the next read to the beginning.
  void rewind() const;
  /// Reads until `into` is full or the file ends; gives the number of bytes. Problems: the disk's.
  Result<std::size_t> read(std::span<char> into) const;
  /// Reads the rest, at most max_bytes. Problems: larger; unreadable; modified meanwhile.
  Result<std::string> readAll(std::uint64_t max_bytes) const;
  /// Whether the file was modified since it was opened.
  bool hasChanged() const;

 private:
  NamedFile(std::string path, Sentence what) : path_(std::move(path)), what_(std::move(what)) {}
  std::string path_;
  Sentence what_;
  Descriptor file_;
  std::uint64_t bytes_ = 0;
  std::int64_t changed_ns_ = 0;
};

}  // namespace underact::system
