#include "core/record/disk.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>

#include "core/system/file.h"

namespace underact::record {
namespace {

constexpr std::int64_t kSetAside[] = {8 << 20, 4 << 20, 2 << 20};  // less where the disk has no more
constexpr std::int64_t kSetAsideAtLeast = 4 << 20;

}  // namespace

RecordingLock::RecordingLock(const std::string& path) : file_(system::openToRead(path)) {
  if (file_.isOpen()) (void)system::lock(file_.number(), system::Lock::Shared);
}

bool RecordingLock::isAt(const std::string& path) {
  const system::Descriptor file = system::openToRead(path);
  return file.isOpen() && !system::lock(file.number(), system::Lock::Alone);
}

bool DiskReserve::reserve(std::int64_t bytes, int fd) {
  const std::optional<system::Status> now = system::statusOf(fd);
  const auto there = static_cast<std::int64_t>(now ? now->bytes : 0);
  if (!now || there + bytes + kSetAsideAtLeast <= until_) return true;
  for (const std::int64_t beyond : kSetAside) {
    const system::Room room = system::setAside(fd, there, bytes + beyond);
    if (room == system::Room::DiskReserve) until_ = std::max(until_, there + bytes + beyond);
    if (room != system::Room::None) return true;
  }
  return false;
}

void DiskReserve::giveBack(const std::string& path) const {
  std::error_code ignored;
  if (until_ > 0) std::filesystem::resize_file(path, static_cast<std::uintmax_t>(sizeOf(path)), ignored);
}

// In version 3 of the superblock: 8 bytes from offset 28 on.
std::int64_t statedSize(int fd) {
  std::array<char, 36> head{};
  if (system::readAllAt(fd, 0, std::as_writable_bytes(std::span(head))) != head.size() || head[8] != 3) return 0;
  std::int64_t size = 0;
  std::memcpy(&size, head.data() + 28, sizeof size);
  return size;
}

std::int64_t statedSize(const std::string& path) {
  return statedSize(system::openToRead(path).number());
}

std::int64_t sizeOf(const std::string& path) {
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  return error ? 0 : static_cast<std::int64_t>(size);
}

std::int64_t lengthToGrowTo(std::int64_t size, std::int64_t stated) {
  // A beginning without the rest is worth no more, and the length stated by a file must not fill the disk.
  constexpr std::int64_t kTimes = 16, kAtLeast = std::int64_t{1} << 26;
  return stated > size && stated / kTimes <= std::max(size, kAtLeast / kTimes) ? stated : size;
}

void growToStatedSize(const std::string& path) {
  const std::int64_t size = sizeOf(path), wanted = lengthToGrowTo(size, statedSize(path));
  std::error_code ignored;
  if (wanted > size) std::filesystem::resize_file(path, static_cast<std::uintmax_t>(wanted), ignored);
}

}  // namespace underact::record
