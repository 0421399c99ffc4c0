#pragma once
#include <cstddef>
#include <utility>

#include "core/system/descriptor.h"

namespace underact::system {

/// Memory that several processes see, all zeros at first, by a descriptor that is passed on.
class SharedMemory {
 public:
  SharedMemory() = default;  // none
  /// None where the system has none; errno says why. name: for who looks at the process.
  static SharedMemory make(const char* name, std::size_t bytes);
  /// The same of a descriptor that was passed on, and is this object's from then on.
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
