#include "core/record/disk.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace underact::record {
namespace {

constexpr std::int64_t kSetAside = 8 << 20;
constexpr std::int64_t kSetAsideAtLeast = 4 << 20;

}  // namespace

Presence::Presence(const std::string& path) : fd_(open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
  if (fd_ >= 0) flock(fd_, LOCK_SH | LOCK_NB);
}

Presence::~Presence() {
  if (fd_ >= 0) close(fd_);
}

bool Presence::isAt(const std::string& path) {
  const int fd = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  if (fd < 0) return false;
  const bool is = flock(fd, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  close(fd);
  return is;
}

bool SetAside::forMore(std::int64_t bytes, int fd) {
  struct stat now {};
  if (fstat(fd, &now) != 0 || now.st_size + bytes + kSetAsideAtLeast <= until_) return true;
  const off_t more = bytes + kSetAside;
  if (fallocate(fd, FALLOC_FL_KEEP_SIZE, now.st_size, more) != 0) return errno != ENOSPC && errno != EDQUOT;
  until_ = now.st_size + more;
  return true;
}

void SetAside::giveBack(const std::string& path) const {
  std::error_code ignored;
  if (until_ > 0) std::filesystem::resize_file(path, static_cast<std::uintmax_t>(sizeOf(path)), ignored);
}

void writeIntoNothing(int fd) {
  const int nothing = open("/dev/null", O_RDWR | O_CLOEXEC);
  if (nothing < 0) return;
  dup2(nothing, fd);
  close(nothing);
}

// Version 3 of the superblock: 8 bytes from the 28th on.
std::int64_t statedSize(const std::string& path) {
  std::array<char, 36> head{};
  std::ifstream file(path, std::ios::binary);
  if (!file.read(head.data(), head.size()) || head[8] != 3) return 0;
  std::int64_t size = 0;
  std::memcpy(&size, head.data() + 28, sizeof size);
  return size;
}

std::int64_t sizeOf(const std::string& path) {
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  return error ? 0 : static_cast<std::int64_t>(size);
}

bool areTheSame(int fd, int other_fd) {
  struct stat one {
  }, other{};
  return fstat(fd, &one) == 0 && fstat(other_fd, &other) == 0 && one.st_dev == other.st_dev &&
         one.st_ino == other.st_ino;
}

std::string nameOf(int fd, const std::string& path) {
  std::string name = "/proc/self/fd/" + std::to_string(fd);
  return access(name.c_str(), F_OK) == 0 ? name : path;
}

std::int64_t lengthToGrowTo(std::int64_t size, std::int64_t stated) {
  // A beginning without the rest is worth no more, and what a file says of itself must not fill a disk.
  constexpr std::int64_t kTimes = 16, kAtLeast = std::int64_t{1} << 26;
  return stated > size && stated / kTimes <= std::max(size, kAtLeast / kTimes) ? stated : size;
}

void growToStatedSize(const std::string& path) {
  const std::int64_t size = sizeOf(path), wanted = lengthToGrowTo(size, statedSize(path));
  std::error_code ignored;
  if (wanted > size) std::filesystem::resize_file(path, static_cast<std::uintmax_t>(wanted), ignored);
}

}  // namespace underact::record
