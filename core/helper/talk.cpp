#include "core/helper/talk.h"

#if defined(__linux__)
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#endif

namespace underact::helper {

#if defined(__linux__)
namespace {

constexpr int kLookAtTimes_ms = 10;

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

bool write(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(STDOUT_FILENO, bytes.data(), std::min(bytes.size(), kBlock));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return true;
}

}  // namespace

// Two sockets that know each other alone: where a helper ends early, a pipe would end this process, too, by a signal.
Talk::Talk(const std::string& program, int file_fd) {
  std::array<int, 2> pair{-1, -1};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, pair.data()) != 0) {
    code_ = errno;
    return;
  }
  child_ = Child({.program = program, .argument = {}, .input_fd = pair[1], .output_fd = pair[1], .file_fd = file_fd});
  ::close(pair[1]);
  fd_ = pair[0];
  if (child_.runs()) {
    ending_ = Ending::Exited;
  } else {
    code_ = child_.error();
  }
}

Talk::~Talk() {
  if (fd_ >= 0) ::close(fd_);
}

bool Talk::fail(Ending ending) {
  ending_ = child_.end(ending);
  code_ = child_.code();
  return false;
}

bool Talk::send(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    // A helper that reads no question has no room for it at some time: it is not waited for.
    const ssize_t sent = ::send(fd_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return fail(errno == EAGAIN ? Ending::TookTooLong : Ending::Exited);
    bytes = bytes.subspan(static_cast<std::size_t>(sent));
  }
  return true;
}

bool Talk::receive(std::span<std::byte> bytes, const Bounds& bounds, double from_cpu_s, double until_s) {
  pollfd answer{fd_, POLLIN, 0};
  while (!bytes.empty()) {
    const ssize_t count = ::recv(fd_, bytes.data(), std::min(bytes.size(), kBlock), MSG_DONTWAIT);
    if (count > 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(count));
      continue;
    }
    if (count == 0 || (errno != EAGAIN && errno != EINTR)) return fail(Ending::Exited);
    if (::poll(&answer, 1, kLookAtTimes_ms) > 0) continue;
    if (child_.cpuSoFar_s() > from_cpu_s + bounds.most_cpu_s) return fail(Ending::TookTooLong);
    if (now_s() > until_s) return fail(Ending::Waited);
  }
  return true;
}

std::optional<std::vector<std::byte>> Talk::ask(std::span<const std::byte> question, const Bounds& bounds) {
  if (!child_.runs()) return {};
  const double from_cpu_s = child_.cpuSoFar_s(), until_s = now_s() + bounds.most_time_s;
  std::uint64_t size = 0;
  if (!send(question) || !receive(std::as_writable_bytes(std::span(&size, 1)), bounds, from_cpu_s, until_s)) return {};
  if (size > bounds.most_bytes) {
    fail(Ending::WroteTooMuch);
    return {};
  }
  std::vector<std::byte> bytes(size);
  if (!receive(bytes, bounds, from_cpu_s, until_s)) return {};
  return bytes;
}

bool nextQuestion(std::span<std::byte> question) {
  while (!question.empty()) {
    const ssize_t count = ::read(STDIN_FILENO, question.data(), question.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    question = question.subspan(static_cast<std::size_t>(count));
  }
  return true;
}

bool answer(std::span<const std::span<const std::byte>> parts) {
  std::uint64_t size = 0;
  for (const std::span<const std::byte> part : parts) size += part.size();
  return write(std::as_bytes(std::span(&size, 1))) &&
         std::all_of(parts.begin(), parts.end(), [](std::span<const std::byte> part) { return write(part); });
}

#else

Talk::Talk(const std::string&, int) {}
Talk::~Talk() = default;

std::optional<std::vector<std::byte>> Talk::ask(std::span<const std::byte>, const Bounds&) {
  return {};
}

bool nextQuestion(std::span<std::byte>) {
  return false;
}

bool answer(std::span<const std::span<const std::byte>>) {
  return false;
}

#endif

}  // namespace underact::helper
