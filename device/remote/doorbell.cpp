#include "device/remote/doorbell.h"

#include <cstdint>

#include "core/base/excepted.h"

#ifdef __linux__
#include <sys/eventfd.h>
#include <unistd.h>
#endif

namespace underact::device::remote {

#ifdef __linux__

Doorbell::Doorbell() : fd_(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {}

Doorbell::~Doorbell() {
  if (fd_ >= 0) ::close(fd_);
}

void Doorbell::ring() noexcept {
  const std::uint64_t one = 1;
  [[maybe_unused]] const auto written =  // full: it is ringing
      UNDERACT_EXCEPTED("adds to a counter of the kernel that never blocks", ::write(fd_, &one, sizeof one));
}

void Doorbell::clear() {
  std::uint64_t rings = 0;
  [[maybe_unused]] const auto read = ::read(fd_, &rings, sizeof rings);
}

#else

Doorbell::Doorbell() = default;
Doorbell::~Doorbell() = default;
void Doorbell::ring() noexcept {}
void Doorbell::clear() {}

#endif

}  // namespace underact::device::remote
