#include "core/base/named_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "core/base/translate.h"

namespace underact {
namespace {

constexpr std::size_t kReadAtOnce = std::size_t{1} << 16;

Problems problemOf(const std::string& path, Sentence sentence) {
  return {{std::move(sentence), {path, 0, 0, ""}}};
}

Problems failed(const std::string& path, const char* pattern) {
  return problemOf(path, said(pattern, {std::generic_category().message(errno)}));
}

std::int64_t changeOf(const struct stat& file) {
#ifdef __APPLE__
  return std::int64_t{file.st_mtimespec.tv_sec} * 1'000'000'000 + file.st_mtimespec.tv_nsec;
#else
  return std::int64_t{file.st_mtim.tv_sec} * 1'000'000'000 + file.st_mtim.tv_nsec;
#endif
}

/// None: it may be opened.
Problems judge(const struct stat& file, const std::string& path, const Sentence& what) {
  if (S_ISDIR(file.st_mode))
    return problemOf(path, said(TRANSLATE_NOOP("problem", "This is a folder, not %1 file."), {what}));
  if (S_ISREG(file.st_mode)) return {};
  return problemOf(path, said(TRANSLATE_NOOP("problem",
                                             "This is a pipe, a device or a socket, not a regular file, so %1 is "
                                             "not read from it. Save what it gives as a file, and name that."),
                              {what}));
}

}  // namespace

Result<NamedFile> NamedFile::open(const std::string& path, const Sentence& what) {
  constexpr const char* kUnopened = TRANSLATE_NOOP("problem", "The file cannot be opened: %1.");
  struct stat found {};
  if (::stat(path.c_str(), &found) != 0) return failed(path, kUnopened);
  if (Problems problems = judge(found, path, what); !problems.empty()) return problems;  // before it is touched
  NamedFile file(path, what);
  // Not blocking, and no terminal of this process: the name may be another's by now.
  file.fd_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  if (file.fd_ < 0 || ::fstat(file.fd_, &found) != 0) return failed(path, kUnopened);
  if (Problems problems = judge(found, path, what); !problems.empty()) return problems;
  file.bytes_ = static_cast<std::uint64_t>(found.st_size);
  file.changed_ns_ = changeOf(found);
  return file;
}

NamedFile::~NamedFile() {
  if (fd_ >= 0) ::close(fd_);
}

void NamedFile::rewind() const {
  ::lseek(fd_, 0, SEEK_SET);
}

Result<std::size_t> NamedFile::read(std::span<char> into) const {
  std::size_t done = 0;
  while (done < into.size()) {
    const ssize_t count = ::read(fd_, into.data() + done, into.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return failed(path_, TRANSLATE_NOOP("problem", "The file cannot be read: %1."));
    if (count == 0) break;
    done += static_cast<std::size_t>(count);
  }
  return done;
}

Result<std::string> NamedFile::readAll(std::uint64_t most_bytes) const {
  std::string text;
  bool ended = false;
  while (!ended && bytes_ <= most_bytes && text.size() <= most_bytes) {
    const std::size_t at = text.size();
    text.resize(at + kReadAtOnce);
    const Result<std::size_t> count = read(std::span(text).subspan(at));
    if (!count) return count.problems();
    text.resize(at + count.value());
    ended = count.value() < kReadAtOnce;
  }
  if (bytes_ > most_bytes || text.size() > most_bytes)
    return problemOf(path_, said(TRANSLATE_NOOP("problem", "The file is larger than %1 MiB; %2 is far smaller."),
                                 {std::to_string(most_bytes >> 20), what_}));
  if (hasChanged())
    return problemOf(path_, said(TRANSLATE_NOOP("problem",
                                                "Another program wrote into the file while it was read. Open it "
                                                "again once that program has saved it.")));
  return text;
}

bool NamedFile::hasChanged() const {
  struct stat file {};
  return ::fstat(fd_, &file) != 0 || changeOf(file) != changed_ns_ ||
         static_cast<std::uint64_t>(file.st_size) != bytes_;
}

}  // namespace underact
