#include "core/helper/connection.h"

#include <algorithm>
#include <cerrno>
#include <chrono>

#include "core/system/channel.h"
#include "core/system/file.h"

namespace underact::helper {
namespace {

constexpr int kLookAtTimes_ms = 10;

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

// A pair of sockets: with a pipe, a helper that ends early would end this process, too, by a signal.
HelperConnection::HelperConnection(const std::string& program, int file_fd) {
  system::Line line = system::makeLine();
  if (!line.here.isOpen()) {
    code_ = errno;
    return;
  }
  const int there = line.there.number();
  child_ = Child({.program = program, .argument = {}, .input_fd = there, .output_fd = there, .file_fd = file_fd});
  here_ = std::move(line.here);
  if (child_.runs()) {
    ending_ = Ending::Exited;
  } else {
    code_ = child_.error();
  }
}

bool HelperConnection::fail(Ending ending) {
  ending_ = child_.end(ending);
  code_ = child_.code();
  return false;
}

bool HelperConnection::send(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    // A helper that does not read its questions has a full buffer at some time: it is not waited for.
    const std::ptrdiff_t sent = system::sendSome(here_.number(), bytes);
    if (sent <= 0) return fail(errno == EAGAIN ? Ending::TookTooLong : Ending::Exited);
    bytes = bytes.subspan(static_cast<std::size_t>(sent));
  }
  return true;
}

bool HelperConnection::receive(std::span<std::byte> bytes, const Bounds& bounds, double from_cpu_s, double until_s) {
  while (!bytes.empty()) {
    const std::span<std::byte> next = bytes.first(std::min(bytes.size(), system::kAtOnce));
    const std::ptrdiff_t count = system::receiveSome(here_.number(), next);
    if (count > 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(count));
      continue;
    }
    if (count == 0 || errno != EAGAIN) return fail(Ending::Exited);
    if (system::waitToRead(here_.number(), kLookAtTimes_ms)) continue;
    if (child_.cpuSoFar_s() > from_cpu_s + bounds.max_cpu_s) return fail(Ending::TookTooLong);
    if (now_s() > until_s) return fail(Ending::Waited);
  }
  return true;
}

std::optional<std::vector<std::byte>> HelperConnection::ask(std::span<const std::byte> question, const Bounds& bounds) {
  if (!child_.runs()) return {};
  const double from_cpu_s = child_.cpuSoFar_s(), until_s = now_s() + bounds.max_time_s;
  std::uint64_t size = 0;
  if (!send(question) || !receive(std::as_writable_bytes(std::span(&size, 1)), bounds, from_cpu_s, until_s)) return {};
  if (size > bounds.max_bytes) {
    fail(Ending::WroteTooMuch);
    return {};
  }
  std::vector<std::byte> bytes(size);
  if (!receive(bytes, bounds, from_cpu_s, until_s)) return {};
  return bytes;
}

bool nextQuestion(std::span<std::byte> question) {
  return system::readAll(system::kInput, question) == question.size();
}

bool answer(std::span<const std::span<const std::byte>> parts) {
  std::uint64_t size = 0;
  for (const std::span<const std::byte> part : parts) size += part.size();
  const auto isWritten = [](std::span<const std::byte> bytes) { return system::writeAll(system::kOutput, bytes) == 0; };
  return isWritten(std::as_bytes(std::span(&size, 1))) && std::all_of(parts.begin(), parts.end(), isWritten);
}

}  // namespace underact::helper
