#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

#include "core/base/result.h"
#include "core/system/descriptor.h"

namespace underact::system {

/// A regular file that a person or another file named, open for reading. Opening never waits, whatever lies at that
/// name: a pipe would wait for its writer, a device may begin to work. Those and sockets are refused unopened, also at
/// the end of links.
class NamedFile {
 public:
  /// what: for the sentences, as "a scene". Problems, one, at path without a line: not there, a folder, no regular
  /// file.
  static Result<NamedFile> open(const std::string& path, const Sentence& what);
  const std::string& path() const { return path_; }
  /// When it was opened.
  std::uint64_t bytes() const { return bytes_; }
  /// This object's.
  int descriptor() const { return file_.number(); }
  /// Goes back to its beginning.
  void rewind() const;
  /// Fills into, or up to the end of the file; gives how many bytes. Problems: the disk's.
  Result<std::size_t> read(std::span<char> into) const;
  /// All from here on, of which at most most_bytes. Problems: larger; unreadable; somebody wrote into it meanwhile.
  Result<std::string> readAll(std::uint64_t most_bytes) const;
  /// Somebody wrote into it since it was opened.
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
