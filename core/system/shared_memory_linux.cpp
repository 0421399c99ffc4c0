#ifdef __linux__
#include <sys/mman.h>

#include "core/system/file.h"
#include "core/system/shared_memory.h"

namespace underact::system {

SharedMemory SharedMemory::make(const char* name, std::size_t bytes) {
  Descriptor made(::memfd_create(name, MFD_CLOEXEC));
  if (!made.isOpen() || cutTo(made.number(), bytes) != 0) return {};
  return of(std::move(made), bytes);
}

SharedMemory SharedMemory::of(Descriptor passed, std::size_t bytes) {
  SharedMemory memory;
  void* const begin = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, passed.number(), 0);
  if (begin == MAP_FAILED) return memory;
  memory.file_ = std::move(passed);
  memory.bytes_ = bytes;
  memory.begin_ = begin;
  return memory;
}

SharedMemory::~SharedMemory() {
  if (begin_ != nullptr) ::munmap(begin_, bytes_);
}

}  // namespace underact::system
#endif
