#include "core/mesh_file/input.h"

#include <algorithm>
#include <span>
#include <vector>

#include "core/base/translate.h"
#include "core/mesh_file/digest.h"
#include "core/mesh_file/limits.h"
#include "core/mesh_file/stl_binary.h"

namespace underact::mesh_file {
namespace {

Problems problemAt(const std::string& path, const Sentence& sentence) {
  return {{sentence, {path}}};
}

}  // namespace

Result<Input> Input::open(const std::string& path) {
  Result<system::NamedFile> file = system::NamedFile::open(path, phrase(TRANSLATE_NOOP("problem", "a mesh")));
  if (!file) return file.problems();
  const std::uint64_t bytes = file.value().bytes();
  if (bytes > kMaxFileBytes) {
    return problemAt(
        path, phrase(TRANSLATE_NOOP("problem",
                                    "The file is larger than 4 GiB. Make the mesh coarser, or save it in parts.")));
  }
  std::string head(kHeadBytes, '\0');
  const Result<std::size_t> count = file.value().read(head);
  if (!count) return count.problems();
  head.resize(count.value());
  const Result<Format> format = formatOf(head, bytes, path);
  if (!format) return format.problems();
  const Problems problems = checkHead(format.value(), head, bytes, path);
  if (!problems.empty()) return problems;
  return Input(std::move(file).value(), format.value(), static_cast<std::int64_t>(stlBinaryCount(head)));
}

int Input::rewound() const {
  file_.rewind();
  return file_.descriptor();
}

Result<std::string> Input::checksum(const TaskMonitor& monitor) const {
  file_.rewind();
  Digest digest;
  std::vector<char> block(kBlock);
  std::uint64_t done = 0;
  for (;;) {
    if (monitor.isCancelled()) return problemAt(path(), phrase(TRANSLATE_NOOP("problem", "Cancelled.")));
    const Result<std::size_t> count = file_.read(block);
    if (!count) return count.problems();
    if (count.value() == 0) break;
    digest.add(std::as_bytes(std::span(block).first(count.value())));
    done += count.value();
    monitor.report(TRANSLATE_NOOP("step of work", "Reading the file"),
                   bytes() == 0 ? 1.0 : std::min(1.0, double(done) / double(bytes())));
  }
  return digest.text();
}

}  // namespace underact::mesh_file
