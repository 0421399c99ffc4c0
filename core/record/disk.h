#pragma once
#include <cstdint>
#include <string>

#include "core/system/descriptor.h"

namespace underact::record {

/// Marks a file as being recorded: others may read but not write it, until this process ends in any way. HDF5's own
/// lock is released once readers may follow.
class RecordingLock {
 public:
  RecordingLock() = default;
  /// Marks the file at path as one that is being recorded, by a shared lock. No such file: no mark.
  explicit RecordingLock(const std::string& path);
  /// Whether a program is recording into that file.
  static bool isAt(const std::string& path);

 private:
  system::Descriptor file_;
};

/// Reserves disk space ahead of the writer, so that a full disk is noticed before the library meets it, and a recording
/// can still be ended in order.
class DiskReserve {
 public:
  /// Reserves space for so many bytes more. false: the disk is full. A file system that cannot reserve space reports a
  /// full disk only when it is full.
  bool reserve(std::int64_t bytes, int fd);
  /// Frees the unused part, once the file is closed.
  void giveBack(const std::string& path) const;

 private:
  std::int64_t until_ = 0;  // space is reserved up to this length
};

std::int64_t sizeOf(const std::string& path);  // 0 if it does not exist

/// The size that an HDF5 file states; 0: it states none.
std::int64_t statedSize(const std::string& path);
std::int64_t statedSize(int fd);

/// The length to which a truncated file is extended: the one it states, within reason; otherwise its own.
std::int64_t lengthToGrowTo(std::int64_t size, std::int64_t stated);

/// Extends a truncated file to the length it states, with zeros; checksums then show what is missing.
void growToStatedSize(const std::string& path);

}  // namespace underact::record
