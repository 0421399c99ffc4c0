#include "core/record/disk.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

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

void growToStatedSize(const std::string& path) {
  constexpr std::int64_t kLongest = std::int64_t{1} << 44;
  const std::int64_t stated = statedSize(path);
  std::error_code ignored;
  if (sizeOf(path) < stated && stated < kLongest)
    std::filesystem::resize_file(path, static_cast<std::uintmax_t>(stated), ignored);
}

}  // namespace underact::record
