#include "core/mesh_file/input.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <memory>
#include <system_error>
#include <vector>

#include "core/base/translate.h"
#include "core/mesh_file/digest.h"
#include "core/mesh_file/limits.h"

namespace underact::mesh_file {
namespace {

Problems problemAt(const std::string& path, const Sentence& sentence) {
  return {{sentence, {path}}};
}

std::string reason() {
  return std::generic_category().message(errno);
}

std::int64_t changeOf(const struct stat& file) {
#ifdef __APPLE__
  return file.st_mtimespec.tv_sec * 1'000'000'000 + file.st_mtimespec.tv_nsec;
#else
  return file.st_mtim.tv_sec * 1'000'000'000 + file.st_mtim.tv_nsec;
#endif
}

/// At least one byte, unless the file ends or fails; 0: it ended, below 0: errno says why.
ssize_t readSome(int fd, char* to, std::size_t most) {
  for (;;) {
    const ssize_t count = ::read(fd, to, most);
    if (count >= 0 || errno != EINTR) return count;
  }
}

}  // namespace

Result<Input> Input::open(const std::string& path) {
  Input input;
  input.path_ = path;
  // Not blocking: a pipe of that name would wait for its writer.
  input.fd_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  struct stat file {};
  if (input.fd_ < 0)
    return problemAt(path, said(QT_TRANSLATE_NOOP("problem", "The file cannot be opened: %1."), {reason()}));
  if (::fstat(input.fd_, &file) != 0)
    return problemAt(path, said(QT_TRANSLATE_NOOP("problem", "The file cannot be read: %1."), {reason()}));
  if (S_ISDIR(file.st_mode))
    return problemAt(path, said(QT_TRANSLATE_NOOP("problem", "This is a folder, not a mesh file.")));
  if (!S_ISREG(file.st_mode))
    return problemAt(path, said(QT_TRANSLATE_NOOP("problem", "This is no file that holds a mesh.")));
  input.bytes_ = static_cast<std::uint64_t>(file.st_size);
  input.changed_ns_ = changeOf(file);
  if (input.bytes_ > kMostFileBytes) {
    return problemAt(
        path, said(QT_TRANSLATE_NOOP("problem",
                                     "The file is larger than 4 GiB. Make the mesh coarser, or save it in parts.")));
  }
  std::string head(kHeadBytes, '\0');
  std::size_t at = 0;
  while (at < head.size()) {
    const ssize_t count = readSome(input.fd_, head.data() + at, head.size() - at);
    if (count < 0)
      return problemAt(path, said(QT_TRANSLATE_NOOP("problem", "The file cannot be read: %1."), {reason()}));
    if (count == 0) break;
    at += static_cast<std::size_t>(count);
  }
  head.resize(at);
  const Result<Format> format = formatOf(head, input.bytes_, path);
  if (!format) return format.problems();
  input.format_ = format.value();
  const Problems problems = checkHead(input.format_, head, input.bytes_, path);
  if (!problems.empty()) return problems;
  return input;
}

Input::~Input() {
  if (fd_ >= 0) ::close(fd_);
}

int Input::rewound() const {
  ::lseek(fd_, 0, SEEK_SET);
  return fd_;
}

Result<std::string> Input::checksum(const mesh::Watch& watch) const {
  const int fd = rewound();
  Digest digest;
  std::vector<char> block(kBlock);
  std::uint64_t done = 0;
  for (;;) {
    if (watch.isCancelled()) return problemAt(path_, said(QT_TRANSLATE_NOOP("problem", "Cancelled.")));
    const ssize_t count = readSome(fd, block.data(), block.size());
    if (count < 0)
      return problemAt(path_, said(QT_TRANSLATE_NOOP("problem", "The file cannot be read: %1."), {reason()}));
    if (count == 0) break;
    digest.add(std::as_bytes(std::span(block).first(static_cast<std::size_t>(count))));
    done += static_cast<std::uint64_t>(count);
    watch.tell(QT_TRANSLATE_NOOP("step of work", "Reading the file"),
               bytes_ == 0 ? 1.0 : std::min(1.0, double(done) / double(bytes_)));
  }
  return digest.text();
}

bool Input::hasChanged() const {
  struct stat file {};
  return ::fstat(fd_, &file) != 0 || changeOf(file) != changed_ns_ ||
         static_cast<std::uint64_t>(file.st_size) != bytes_;
}

}  // namespace underact::mesh_file
