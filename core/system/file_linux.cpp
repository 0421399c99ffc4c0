#ifdef __linux__
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <vector>

#include "core/system/file.h"

namespace underact::system {
namespace {

constexpr mode_t kOwnersFile = 0600, kOwnersFolder = 0700, kDefaultFile = 0666;

int reasonOf(int result) {
  return result == 0 ? 0 : errno;
}

std::optional<Status> statusFrom(int result, const struct stat& file) {
  if (result != 0) return {};
  Status status;
  status.kind = S_ISREG(file.st_mode)   ? FileKind::File
                : S_ISDIR(file.st_mode) ? FileKind::Folder
                : S_ISLNK(file.st_mode) ? FileKind::Link
                                        : FileKind::Other;
  status.bytes = static_cast<std::uint64_t>(file.st_size);
  status.changed_ns = std::int64_t{file.st_mtim.tv_sec} * 1'000'000'000 + file.st_mtim.tv_nsec;
  status.disk = file.st_dev;
  status.number = file.st_ino;
  status.rights = file.st_mode & 07777U;
  status.is_trusted = file.st_uid == ::geteuid() || file.st_uid == 0;
  return status;
}

/// Moves all bytes. move: moves some, from the first one left, and gives their number.
template <class Move>
std::optional<std::size_t> movedAll(std::size_t bytes, Move&& move) {
  std::size_t done = 0;
  while (done < bytes) {
    const ssize_t count = move(done, std::min(bytes - done, kAtOnce));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return {};
    if (count == 0) break;
    done += static_cast<std::size_t>(count);
  }
  return done;
}

}  // namespace

int Descriptor::close() {
  return number_ < 0 ? 0 : reasonOf(::close(release()));
}

Descriptor Descriptor::copyOf(int number) {
  return Descriptor(number < 0 ? -1 : ::fcntl(number, F_DUPFD_CLOEXEC, kErrors + 1));
}

Descriptor openToRead(const std::string& path, Links links) {
  const int flags = O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY;
  return Descriptor(::open(path.c_str(), links == Links::Refuse ? flags | O_NOFOLLOW : flags));
}

Descriptor openToWrite(const std::string& path) {
  return Descriptor(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
}

Descriptor makeFile(const std::string& path, Making making, Readers readers) {
  const int flags = making == Making::New       ? O_RDWR | O_EXCL | O_NOFOLLOW
                    : making == Making::Emptied ? O_WRONLY | O_TRUNC
                                                : O_RDWR | O_APPEND;
  const mode_t rights = readers == Readers::OwnerAlone ? kOwnersFile : kDefaultFile;
  return Descriptor(::open(path.c_str(), flags | O_CREAT | O_CLOEXEC, rights));
}

int makeOwnersFolder(const std::string& path) {
  return reasonOf(::mkdir(path.c_str(), kOwnersFolder));
}

std::optional<Status> statusOf(const std::string& path, Links links) {
  struct stat file {};
  const int result = links == Links::Follow ? ::stat(path.c_str(), &file) : ::lstat(path.c_str(), &file);
  return statusFrom(result, file);
}

std::optional<Status> statusOf(int descriptor) {
  struct stat file {};
  const int result = ::fstat(descriptor, &file);
  return statusFrom(result, file);
}

bool isSameFile(const std::optional<Status>& one, const std::optional<Status>& other) {
  return one && other && one->disk == other->disk && one->number == other->number;
}

int setRights(int descriptor, unsigned rights) {
  return reasonOf(::fchmod(descriptor, rights));
}

bool mayReadAndWrite(const std::string& path) {
  return ::access(path.c_str(), R_OK | W_OK) == 0;
}

bool mayExecute(const std::string& path) {
  return ::access(path.c_str(), X_OK) == 0;
}

std::string nameOf(int descriptor, const std::string& path) {
  const std::string by_number = "/proc/self/fd/" + std::to_string(descriptor);
  return isSameFile(statusOf(descriptor), statusOf(by_number)) ? by_number : path;
}

std::optional<std::size_t> readAll(int descriptor, std::span<std::byte> into) {
  return movedAll(into.size(),
                  [&](std::size_t at, std::size_t max) { return ::read(descriptor, into.data() + at, max); });
}

std::optional<std::size_t> readAllAt(int descriptor, std::uint64_t from, std::span<std::byte> into) {
  return movedAll(into.size(), [&](std::size_t at, std::size_t max) {
    return ::pread(descriptor, into.data() + at, max, static_cast<off_t>(from + at));
  });
}

int writeAll(int descriptor, std::span<const std::byte> bytes) {
  const std::optional<std::size_t> done = movedAll(
      bytes.size(), [&](std::size_t at, std::size_t max) { return ::write(descriptor, bytes.data() + at, max); });
  if (!done) return errno;
  return *done < bytes.size() ? ENOSPC : 0;
}

void rewind(int descriptor) {
  ::lseek(descriptor, 0, SEEK_SET);
}

std::int64_t lengthOf(int descriptor) {
  return std::max<std::int64_t>(::lseek(descriptor, 0, SEEK_END), 0);
}

int copyContent(int from, int to) {
  std::vector<std::byte> some(kAtOnce);
  const off_t end = ::lseek(from, 0, SEEK_END);
  for (off_t at = 0; at < end;) {
    const off_t data = ::lseek(from, at, SEEK_DATA);
    if (data < 0 && errno == ENXIO) break;  // only a hole is left
    if (data < 0) return errno;
    const off_t hole = std::min(std::max(::lseek(from, data, SEEK_HOLE), data + 1), end);
    for (at = data; at < hole;) {
      const std::size_t max = std::min(some.size(), static_cast<std::size_t>(hole - at));
      const std::optional<std::size_t> count =
          readAllAt(from, static_cast<std::uint64_t>(at), std::span(some).first(max));
      if (!count || ::lseek(to, at, SEEK_SET) < 0) return errno;
      if (*count == 0) return EIO;  // it has become shorter
      if (const int reason = writeAll(to, std::span(some).first(*count)); reason != 0) return reason;
      at += static_cast<off_t>(*count);
    }
  }
  return end < 0 ? errno : cutTo(to, static_cast<std::uint64_t>(end));
}

int setRightsLike(int descriptor, int model) {
  struct stat file {};
  if (::fstat(model, &file) != 0) return errno;
  if (::fchown(descriptor, file.st_uid, file.st_gid) != 0) errno = 0;  // it stays this user's own
  return reasonOf(::fchmod(descriptor, file.st_mode & 07777U));
}

int cutTo(int descriptor, std::uint64_t bytes) {
  return reasonOf(::ftruncate(descriptor, static_cast<off_t>(bytes)));
}

int sync(int descriptor) {
  return reasonOf(::fsync(descriptor));
}

void syncFolderOf(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  const Descriptor opened(::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.isOpen()) (void)sync(opened.number());
}

bool lock(int descriptor, Lock how) {
  return ::flock(descriptor, (how == Lock::Alone ? LOCK_EX : LOCK_SH) | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

void unlock(int descriptor) {
  ::flock(descriptor, LOCK_UN);
}

Room setAside(int descriptor, std::int64_t from, std::int64_t bytes) {
  if (::fallocate(descriptor, FALLOC_FL_KEEP_SIZE, from, bytes) == 0) return Room::DiskReserve;
  return errno == ENOSPC || errno == EDQUOT ? Room::None : Room::Unknown;
}

void redirectToNull(int descriptor) {
  const Descriptor nothing(::open("/dev/null", O_RDWR | O_CLOEXEC));
  if (nothing.isOpen()) ::dup2(nothing.number(), descriptor);
}

std::FILE* streamOf(Descriptor descriptor) {
  std::FILE* const stream = descriptor.isOpen() ? ::fdopen(descriptor.number(), "wb") : nullptr;
  if (stream != nullptr) descriptor.release();
  return stream;
}

int renameIfFree(const std::string& from, const std::string& to) {
  if (::link(from.c_str(), to.c_str()) == 0) {
    ::unlink(from.c_str());
    return 0;
  }
  if (errno == EEXIST) return EEXIST;
  // On file systems without hard links, as on memory cards.
  return reasonOf(::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE));
}

}  // namespace underact::system
#endif
