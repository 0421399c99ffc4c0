#pragma once
#include <cstdint>
#include <string>
#include <utility>

#include "core/base/result.h"
#include "core/base/task_monitor.h"
#include "core/mesh_file/format.h"
#include "core/system/named_file.h"

namespace underact::mesh_file {

/// A mesh file that is open for reading.
class Input {
 public:
  /// Problems: no such file, not a regular file, too large, or none of the formats by its first bytes.
  static Result<Input> open(const std::string& path);

  const std::string& path() const { return file_.path(); }
  std::uint64_t bytes() const { return file_.bytes(); }
  Format format() const { return format_; }
  std::int64_t statedFaces() const { return stated_faces_; }  // by the head of a binary STL
  /// The descriptor, at the beginning of the file; this object closes it.
  int rewound() const;
  /// XXH3 of 128 bits over all it holds, as 32 hexadecimal digits; share: 0 to 1 of it. Problems: unreadable,
  /// cancelled.
  Result<std::string> checksum(const TaskMonitor& monitor) const;
  /// Whether the file was written since it was opened.
  bool hasChanged() const { return file_.hasChanged(); }

 private:
  Input(system::NamedFile file, Format format, std::int64_t stated_faces)
      : file_(std::move(file)), format_(format), stated_faces_(stated_faces) {}
  system::NamedFile file_;
  Format format_;
  std::int64_t stated_faces_;
};

}  // namespace underact::mesh_file
