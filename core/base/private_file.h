#pragma once
#include <string>
#include <utility>

#include "core/base/result.h"

namespace underact {

/// What is done where there is something of the name already.
enum class Existing { Refuse, Replace };

/// Whether a new file may be made at path. Problems: Refuse and there is a file or a link, also one that leads nowhere;
/// a folder, a pipe or a device, which are never replaced. Touches nothing.
Problems checkNew(const std::string& path, Existing existing);

/// A file made just now, open for reading and writing, which its owner alone may read and write, whatever the umask is.
class NewFile {
 public:
  NewFile() = default;  // none
  NewFile(NewFile&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  NewFile& operator=(NewFile&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  ~NewFile();

  /// A file of its own at path, never what stood there: with Replace a file or a link of that name is taken away first,
  /// and what a link led to stays. None where that fails: errno says why, and EEXIST that somebody was quicker.
  static NewFile make(const std::string& path, Existing existing);
  bool isGood() const { return fd_ >= 0; }
  int descriptor() const { return fd_; }
  /// The caller closes it.
  int release() { return std::exchange(fd_, -1); }
  /// A path that opens just this file, whatever has come to stand at its name; path where the system has no such thing.
  std::string sameFile(const std::string& path) const;

 private:
  int fd_ = -1;
};

/// Makes a folder and those above it that are missing; into each that is made its owner alone can look, whatever the
/// umask is. One that is there stays as it is. 0, or the system's reason.
int makePrivateFolder(const std::string& path);

}  // namespace underact
