#pragma once
#include <cstddef>
#include <utility>

#include "core/system/descriptor.h"

namespace underact::system {

/// Memory shared by several processes, zero at first, by a descriptor that is passed on.
class SharedMemory {
 public:
  SharedMemory() = default;  // none
  /// None on failure; errno says why. name: shown by tools that look at the process.
  static SharedMemory make(const char* name, std::size_t bytes);
  /// Shared memory in another process, by the passed descriptor, which this object takes over.
  static SharedMemory of(Descriptor passed, std::size_t bytes);
  /// Takes the memory over; the other has none.
  SharedMemory(SharedMemory&& other) noexcept
      : file_(std::move(other.file_)), bytes_(other.bytes_), begin_(std::exchange(other.begin_, nullptr)) {}
  SharedMemory& operator=(SharedMemory&&) = delete;
  ~SharedMemory();

  void* begin() const { return begin_; }  // null: none
  int descriptor() const { return file_.number(); }

 private:
  Descriptor file_;
  std::size_t bytes_ = 0;
  void* begin_ = nullptr;
};

}  // namespace underact::system
