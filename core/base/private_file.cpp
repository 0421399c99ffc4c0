#include "core/base/private_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

#include "core/base/translate.h"

namespace underact {
namespace {

constexpr mode_t kOwnersFile = 0600, kOwnersFolder = 0700;

}  // namespace

Problems checkNew(const std::string& path, Existing existing) {
  struct stat there {};
  if (::lstat(path.c_str(), &there) != 0) return {};  // none; if another thing is wrong, making it says what
  if (!S_ISREG(there.st_mode) && !S_ISLNK(there.st_mode))
    return {{said(TRANSLATE_NOOP("problem",
                                 "A folder, a pipe or a device has this name and is not replaced. Give another "
                                 "name.")),
             {path}}};
  if (existing == Existing::Replace) return {};
  return {{said(TRANSLATE_NOOP("problem",
                               "There is a file or a link of this name already; it was left as it is. Give another "
                               "name.")),
           {path}}};
}

NewFile NewFile::make(const std::string& path, Existing existing) {
  NewFile file;
  struct stat there {};
  if (existing == Existing::Replace && ::lstat(path.c_str(), &there) == 0 &&
      (S_ISREG(there.st_mode) || S_ISLNK(there.st_mode)))
    ::unlink(path.c_str());
  // Exclusive: a link of that name is not followed, wherever it leads.
  file.fd_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, kOwnersFile);
  return file;
}

NewFile::~NewFile() {
  if (fd_ >= 0) ::close(fd_);
}

std::string NewFile::sameFile(const std::string& path) const {
  const std::string by_number = "/proc/self/fd/" + std::to_string(fd_);
  struct stat here {
  }, there{};
  const bool same = ::fstat(fd_, &here) == 0 && ::stat(by_number.c_str(), &there) == 0 && here.st_ino == there.st_ino &&
                    here.st_dev == there.st_dev;
  return same ? by_number : path;
}

int makePrivateFolder(const std::string& path) {
  std::error_code error;
  const std::filesystem::path whole = std::filesystem::absolute(path, error).lexically_normal();
  if (error) return error.value();
  std::filesystem::path at;
  for (const std::filesystem::path& part : whole) {
    at /= part;
    if (::mkdir(at.c_str(), kOwnersFolder) == 0) continue;
    const int reason = errno;  // one that is there; where nothing may be made, it may be there, too
    if (!std::filesystem::is_directory(at, error)) return reason == EEXIST ? ENOTDIR : reason;
  }
  return 0;
}

}  // namespace underact
