#include "app/mesh_reader/serve.h"

#include <algorithm>
#include <new>
#include <optional>
#include <span>

#include "app/mesh_reader/open_mesh.h"
#include "core/base/translate.h"
#include "core/helper/run.h"
#include "core/mesh_file/limits.h"
#include "core/mesh_file/message.h"
#include "core/mesh_file/scan.h"
#include "core/system/file.h"
#include "core/system/sandbox.h"
#include "core/system/this_process.h"

namespace underact::mesh_reader {
namespace {

using mesh_file::Format;
using mesh_file::Message;

// A program that renders a surface meanwhile needs the processor more.
constexpr int kNice = 5;

bool write(std::span<const std::byte> bytes) {
  return system::writeAll(system::kOutput, bytes) == 0;
}

std::optional<Format> formatOfWord(const std::string& word) {
  for (int index = 0; index < mesh_file::kFormats; ++index) {
    const auto format = static_cast<Format>(index);
    if (word == mesh_file::wordOf(format)) return format;
  }
  return {};
}

/// All of the standard input, which may have become shorter; never more than asked.
std::string readAll(std::uint64_t bytes) {
  std::string all(bytes, '\0');
  all.resize(system::readAll(system::kInput, std::as_writable_bytes(std::span(all))).value_or(0));
  return all;
}

/// The peak memory of this process according to the kernel; 0: unknown.
std::int64_t peakBytes(const system::Descriptor& status) {
  std::string text(4096, '\0');
  text.resize(system::readAll(status.number(), std::as_writable_bytes(std::span(text))).value_or(0));
  const std::size_t at = text.find("VmHWM:");
  if (at == std::string::npos) return 0;
  std::int64_t kB = 0;
  mesh_file::Scan words(std::string_view(text).substr(at + 6));
  return mesh_file::readInteger(words.word(), kB) ? kB * 1024 : 0;
}

Message read(Format format, std::uint64_t file_bytes) {
  Message message;
  try {
    const Prepared prepared = prepare(format, readAll(file_bytes));
    if (!prepared.problem.empty()) {
      message.problem = prepared.problem;
      return message;
    }
    unsigned char told = 0;
    OpenMeshResult result = readWithOpenMesh(format, prepared, [&told](double share) {
      const auto percent = static_cast<unsigned char>(share * helper::kMaxProgress);
      if (percent <= told) return;
      told = percent;
      write(std::as_bytes(std::span(&told, 1)));
    });
    message.problem = result.problem;
    if (!message.problem.empty()) return message;
    // Readers leave out degenerate faces; only their number is known.
    const auto missing = static_cast<std::int64_t>(prepared.faces - result.polygons.ends.size());
    message.raw = trianglesOf(std::move(result.polygons));
    message.raw.origin_M = prepared.origin_M;
    message.raw.single_step = prepared.single_step;
    message.raw.polygons += missing;
    message.raw.dropped.without_extent += missing;
    message.raw.normals = result.normals;
    message.raw.normals_against = result.normals_against;
  } catch (const std::bad_alloc&) {
    message = {};
    message.problem =
        phrase(TRANSLATE_NOOP("problem", "The file is damaged, or takes more memory than a file of its size should."));
  }
  return message;
}

}  // namespace

int serve(const std::string& word) {
  const std::optional<Format> format = formatOfWord(word);
  const std::optional<system::Status> file = system::statusOf(system::kInput);
  if (!format || !file || file->bytes == 0) return 2;
  const std::uint64_t bytes = file->bytes;
  system::lowerPriority(kNice);
  const system::Descriptor status = system::openToRead("/proc/self/status");
  system::endWithParent();  // the program that asked is gone
  if (!system::enterSandbox(mesh_file::maxMemory(bytes), mesh_file::maxCpu_s(bytes))) return helper::kNotSealed;
  Message message = read(*format, bytes);
  message.raw.peak_bytes = peakBytes(status);
  return mesh_file::writeMessage(message, write) ? 0 : 1;
}

}  // namespace underact::mesh_reader
