#pragma once
#include <cstdint>
#include <string>
#include <utility>

#include "core/base/result.h"
#include "core/mesh/watch.h"
#include "core/mesh_file/format.h"

namespace underact::mesh_file {

/// A mesh file that is open for reading.
class Input {
 public:
  /// Problems: it is not there, no file, too large, or none of the formats, by its first bytes.
  static Result<Input> open(const std::string& path);
  Input(Input&& other) noexcept
      : path_(std::move(other.path_)),
        fd_(std::exchange(other.fd_, -1)),
        bytes_(other.bytes_),
        format_(other.format_),
        changed_ns_(other.changed_ns_) {}
  Input& operator=(Input&&) = delete;
  ~Input();

  const std::string& path() const { return path_; }
  std::uint64_t bytes() const { return bytes_; }
  Format format() const { return format_; }
  /// At its beginning; the descriptor is this object's.
  int rewound() const;
  /// XXH3 of 128 bits over all it holds, as 32 hexadecimal digits; share: 0 to 1 of it. Problems: unreadable,
  /// cancelled.
  Result<std::string> checksum(const mesh::Watch& watch) const;
  /// Somebody wrote into it since it was opened.
  bool hasChanged() const;

 private:
  Input() = default;
  std::string path_;
  int fd_ = -1;
  std::uint64_t bytes_ = 0;
  Format format_ = Format::Obj;
  std::int64_t changed_ns_ = 0;
};

}  // namespace underact::mesh_file
