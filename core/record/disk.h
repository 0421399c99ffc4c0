#pragma once
#include <cstdint>
#include <string>

#include "core/system/descriptor.h"

namespace underact::record {

/// A file that is being recorded may be read by others and not be written, until this process ends, however it ends:
/// HDF5's own lock is gone once readers may follow.
class Presence {
 public:
  Presence() = default;
  /// Marks the file at path as one that is being recorded, by a shared lock. No such file: no mark.
  explicit Presence(const std::string& path);
  /// Some program is recording into that file.
  static bool isAt(const std::string& path);

 private:
  system::Descriptor file_;
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

std::int64_t sizeOf(const std::string& path);  // 0 where there is none

/// What an HDF5 file says its size is; 0: it does not say.
std::int64_t statedSize(const std::string& path);
std::int64_t statedSize(int fd);

/// How long a file that was cut off is made again: as long as it says, within reason; else as long as it is.
std::int64_t lengthToGrowTo(std::int64_t size, std::int64_t stated);

/// A file that was cut off gets its length back, empty: what is missing then shows by its checksums.
void growToStatedSize(const std::string& path);

}  // namespace underact::record
