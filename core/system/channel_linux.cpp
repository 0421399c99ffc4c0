#ifdef __linux__
#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>

#include "core/system/channel.h"

namespace underact::system {
namespace {

constexpr std::size_t kMaxWaitedFor = 4;

template <class Call>
std::ptrdiff_t uninterrupted(Call&& call) {
  ssize_t count = 0;
  while ((count = call()) < 0 && errno == EINTR) {
  }
  return count;
}

}  // namespace

Pipe makePipe(std::size_t max_bytes) {
  std::array<int, 2> ends{-1, -1};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) return {};
  if (max_bytes > 0) ::fcntl(ends[0], F_SETPIPE_SZ, static_cast<int>(max_bytes));
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

Line makeLine() {
  std::array<int, 2> ends{-1, -1};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) return {};
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

int waitForAny(std::span<const int> descriptors, int time_ms) {
  std::array<pollfd, kMaxWaitedFor> waited{};
  const std::size_t count = std::min(descriptors.size(), waited.size());
  for (std::size_t index = 0; index < count; ++index) waited[index] = {descriptors[index], POLLIN, 0};
  if (::poll(waited.data(), count, time_ms) <= 0) return -1;
  const auto first = std::find_if(waited.begin(), waited.end(), [](const pollfd& one) { return one.revents != 0; });
  return static_cast<int>(first - waited.begin());
}

bool waitToRead(int descriptor, int time_ms) {
  return waitForAny({&descriptor, 1}, time_ms) == 0;
}

bool waitToWrite(int descriptor, int time_ms) {
  pollfd room{descriptor, POLLOUT, 0};
  return ::poll(&room, 1, time_ms) > 0;
}

std::ptrdiff_t readSome(int descriptor, std::span<std::byte> into) {
  return uninterrupted([&] { return ::read(descriptor, into.data(), into.size()); });
}

std::ptrdiff_t writeSome(int descriptor, std::span<const char> bytes) {
  return uninterrupted([&] { return ::write(descriptor, bytes.data(), bytes.size()); });
}

std::ptrdiff_t receiveSome(int end, std::span<std::byte> into) {
  return uninterrupted([&] { return ::recv(end, into.data(), into.size(), MSG_DONTWAIT); });
}

std::ptrdiff_t sendSome(int end, std::span<const std::byte> bytes) {
  return uninterrupted([&] { return ::send(end, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT); });
}

}  // namespace underact::system
#endif
