#pragma once
#include <cstdint>
#include <string>

#include "core/system/descriptor.h"

namespace underact::record {

/// Others may read a file that is being recorded, but not write it, until this process ends, however it ends: HDF5's
/// own lock is gone once readers may follow.
class Presence {
 public:
  Presence() = default;
  explicit Presence(const std::string& path);
  /// Another program is recording into that file.
  static bool isAt(const std::string& path);

 private:
  system::Descriptor file_;
};

/// Reserves disk space beyond what is written, so that a full disk is noticed before the library meets it, and there is
/// space to end in order.
class SetAside {
 public:
  /// false: the disk has no space for that many more bytes. Where the file system cannot reserve space, it reports this
  /// only when the disk is full.
  bool forMore(std::int64_t bytes, int fd);
  /// Gives back the unused space, once the file is closed.
  void giveBack(const std::string& path) const;

 private:
  std::int64_t until_ = 0;  // the file can grow to this size without asking the disk
};

std::int64_t sizeOf(const std::string& path);  // 0 if it does not exist

/// The size that an HDF5 file states; 0: it states none.
std::int64_t statedSize(const std::string& path);
std::int64_t statedSize(int fd);

/// How long a truncated file is made: as long as it states, within reason; otherwise as long as it is.
std::int64_t lengthToGrowTo(std::int64_t size, std::int64_t stated);

/// Gives a truncated file its length back, with zeros: the checksums then show what is missing.
void growToStatedSize(const std::string& path);

}  // namespace underact::record
