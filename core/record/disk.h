#pragma once
#include <cstdint>
#include <string>
#include <utility>

namespace underact::record {

/// A file that is being recorded may be read by others and not be written, until this process ends, however it ends:
/// HDF5's own lock is gone once readers may follow.
class Presence {
 public:
  Presence() = default;
  explicit Presence(const std::string& path);
  Presence(Presence&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  Presence& operator=(Presence&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  ~Presence();
  /// Some program is recording into that file.
  static bool isAt(const std::string& path);

 private:
  int fd_ = -1;
};

/// Room on the disk beyond what is written, so that a disk that fills up is met before the library meets it, and there
/// is room to end in order.
class SetAside {
 public:
  /// false: the disk has no room for so many bytes more. Where the file system cannot set room aside, it says so when
  /// the disk is full, and not before.
  bool forMore(std::int64_t bytes, int fd);
  /// Gives back what was not used, once the file is closed.
  void giveBack(const std::string& path) const;

 private:
  std::int64_t until_ = 0;  // the file may grow to this without asking the disk
};

/// What is written to fd from now on goes nowhere.
void writeIntoNothing(int fd);

std::int64_t sizeOf(const std::string& path);  // 0 where there is none

/// What an HDF5 file says its size is; 0: it does not say.
std::int64_t statedSize(const std::string& path);

/// Both are open on one file.
bool areTheSame(int fd, int other_fd);

/// A name for what is open there that leads to nothing else, whatever is moved or put in its place meanwhile; path,
/// where the system has no such names.
std::string nameOf(int fd, const std::string& path);

/// How long a file that was cut off is made again: as long as it says, within reason; else as long as it is.
std::int64_t lengthToGrowTo(std::int64_t size, std::int64_t stated);

/// A file that was cut off gets its length back, empty: what is missing then shows by its checksums.
void growToStatedSize(const std::string& path);

}  // namespace underact::record
