#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "core/base/translate.h"
#include "core/record/foreign_file.h"

namespace underact::record {
namespace {

Problems whyNotOpened(const std::string& path, int error) {
  if (error == ENOENT || error == ENOTDIR) return {{said(TRANSLATE_NOOP("problem", "There is no such file.")), {path}}};
  if (error == ELOOP)
    return {{said(TRANSLATE_NOOP("problem",
                                 "This is a link to another file, which would be changed in its place. Give that "
                                 "file's own name.")),
             {path}}};
  return {{said(TRANSLATE_NOOP("problem", "The file cannot be opened: %1."), {std::generic_category().message(error)}),
           {path}}};
}

}  // namespace

Result<ForeignInput> ForeignInput::open(const std::string& path, bool follows) {
  // Not blocking: a pipe of that name would wait for its writer.
  const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY | (follows ? 0 : O_NOFOLLOW));
  if (fd < 0) return whyNotOpened(path, errno);
  ForeignInput input(path, fd);
  struct stat file {};
  if (::fstat(fd, &file) != 0) return whyNotOpened(path, errno);
  if (S_ISDIR(file.st_mode))
    return Problems{{said(TRANSLATE_NOOP("problem", "This is a folder, not a session.")), {path}}};
  if (!S_ISREG(file.st_mode))
    return Problems{{said(TRANSLATE_NOOP("problem", "This is no file that holds a session.")), {path}}};
  if (::flock(fd, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    return Problems{
        {said(TRANSLATE_NOOP("problem", "Another program has this file open. Close it there first.")), {path}}};
  return input;
}

ForeignInput::ForeignInput(ForeignInput&& other) noexcept
    : path_(std::move(other.path_)), fd_(std::exchange(other.fd_, -1)) {}

ForeignInput& ForeignInput::operator=(ForeignInput&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(fd_, other.fd_);
  return *this;
}

ForeignInput::~ForeignInput() {
  if (fd_ >= 0) ::close(fd_);
}

std::int64_t ForeignInput::bytes() const {
  struct stat file {};
  return ::fstat(fd_, &file) == 0 ? static_cast<std::int64_t>(file.st_size) : 0;
}

void ForeignInput::unlock() const {
  ::flock(fd_, LOCK_UN);
}

}  // namespace underact::record
