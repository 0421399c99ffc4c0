#include "core/system/named_file.h"

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "core/base/translate.h"
#include "core/system/file.h"

namespace underact::system {
namespace {

constexpr std::size_t kReadAtOnce = std::size_t{1} << 16;

Problems problemOf(const std::string& path, Sentence sentence) {
  return {{std::move(sentence), {path, 0, 0, ""}}};
}

Problems failed(const std::string& path, const char* pattern) {
  return problemOf(path, phrase(pattern, {std::generic_category().message(errno)}));
}

/// The problem of opening such a file; none: it may be opened.
Problems judge(const Status& file, const std::string& path, const Sentence& what) {
  if (file.kind == FileKind::Folder)
    return problemOf(path, phrase(TRANSLATE_NOOP("problem", "This is a folder, not %1 file."), {what}));
  if (file.kind == FileKind::File) return {};
  return problemOf(path, phrase(TRANSLATE_NOOP("problem",
                                               "This is a pipe, a device or a socket, not a regular file, so %1 is not "
                                               "read from it. Save its output to a file, and give that file."),
                                {what}));
}

}  // namespace

Result<NamedFile> NamedFile::open(const std::string& path, const Sentence& what) {
  constexpr const char* kUnopened = TRANSLATE_NOOP("problem", "The file cannot be opened: %1.");
  std::optional<Status> found = statusOf(path);
  if (!found) return failed(path, kUnopened);
  if (Problems problems = judge(*found, path, what); !problems.empty()) return problems;  // before it is touched
  NamedFile file(path, what);
  file.file_ = openToRead(path);  // without waiting: it may be another file by now
  found = file.file_.isOpen() ? statusOf(file.descriptor()) : std::nullopt;
  if (!found) return failed(path, kUnopened);
  if (Problems problems = judge(*found, path, what); !problems.empty()) return problems;
  file.bytes_ = found->bytes;
  file.changed_ns_ = found->changed_ns;
  return file;
}

void NamedFile::rewind() const {
  system::rewind(descriptor());
}

Result<std::size_t> NamedFile::read(std::span<char> into) const {
  const std::optional<std::size_t> count = system::readAll(descriptor(), std::as_writable_bytes(into));
  if (!count) return failed(path_, TRANSLATE_NOOP("problem", "The file cannot be read: %1."));
  return *count;
}

Result<std::string> NamedFile::readAll(std::uint64_t max_bytes) const {
  std::string text;
  bool ended = false;
  while (!ended && bytes_ <= max_bytes && text.size() <= max_bytes) {
    const std::size_t at = text.size();
    text.resize(at + kReadAtOnce);
    const Result<std::size_t> count = read(std::span(text).subspan(at));
    if (!count) return count.problems();
    text.resize(at + count.value());
    ended = count.value() < kReadAtOnce;
  }
  if (bytes_ > max_bytes || text.size() > max_bytes)
    return problemOf(path_, phrase(TRANSLATE_NOOP("problem", "The file is larger than %1 MiB; %2 is far smaller."),
                                   {std::to_string(max_bytes >> 20), what_}));
  if (hasChanged())
    return problemOf(path_, phrase(TRANSLATE_NOOP("problem",
                                                  "Another program wrote to the file while it was being read. Open it "
                                                  "again once that program has saved it.")));
  return text;
}

bool NamedFile::hasChanged() const {
  const std::optional<Status> now = statusOf(descriptor());
  return !now || now->changed_ns != changed_ns_ || now->bytes != bytes_;
}

}  // namespace underact::system
