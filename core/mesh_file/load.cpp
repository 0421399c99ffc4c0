#include "core/mesh_file/load.h"

#include <array>
#include <cstring>
#include <span>
#include <type_traits>
#include <utility>

#include "core/base/translate.h"
#include "core/mesh/surface_bytes.h"
#include "core/mesh_file/read_file.h"
#include "core/mesh_file/repair.h"
#include "core/mesh_file/report.h"
#include "core/mesh_file/steps.h"
#include "core/mesh_file/stl_binary.h"
#include "core/mesh_file/unite.h"

namespace underact::mesh_file {
namespace {

// To be increased whenever reading, repairing, Facts or the bytes of a surface change: older entries are then ignored.
constexpr int kVersion = 5;

// The progress at the end of each step, for 2 million faces as binary STL.
constexpr double kHashed = 0.05, kRead = 0.40, kRepaired = 0.60, kUnited = 0.75, kBuilt = 0.95;

static_assert(std::is_trivially_copyable_v<Facts>);

std::string keyOf(const Input& input, const std::string& checksum) {
  return checksum + "-" + wordOf(input.format()) + "-" + std::to_string(kVersion) + "-" + std::to_string(sizeof(Facts));
}

Problems problemOf(const Input& input, const Sentence& sentence) {
  return {{sentence, {input.path()}}};
}

std::optional<Loaded> fromCache(const Cache& cache, const std::string& key, const TaskMonitor& monitor) {
  const std::optional<std::vector<std::byte>> bytes = cache.get(key, monitor);
  if (!bytes || bytes->size() < sizeof(Facts)) return {};
  Loaded loaded;
  std::memcpy(&loaded.facts, bytes->data(), sizeof(Facts));
  loaded.surface = mesh::surfaceOfBytes(std::span(*bytes).subspan(sizeof(Facts)));
  if (loaded.surface == nullptr) return {};
  loaded.from_cache = true;
  return loaded;
}

/// Adds what the file contained besides triangles.
void addRaw(const RawMesh& raw, Facts& facts) {
  facts.file_faces = raw.polygons;
  facts.normals = raw.normals;
  facts.normals_against = raw.normals_against;
  facts.not_finite += raw.dropped.not_finite;
  facts.out_of_range += raw.dropped.out_of_range;
  facts.without_extent += raw.dropped.without_extent;
  facts.single_step = raw.single_step;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    facts.low[axis] += raw.origin_M[static_cast<Eigen::Index>(axis)];
    facts.high[axis] += raw.origin_M[static_cast<Eigen::Index>(axis)];
  }
}

Sentence nothingLeft(const Facts& facts) {
  Sentence sentence = phrase(TRANSLATE_NOOP("problem", "The file contains nothing to feel."));
  for (const Sentence& line : reportOf(facts, 1.0)) sentence = oneAfterAnother({sentence, line});
  return sentence;
}

Result<Loaded> build(const Input& input, const TaskMonitor& monitor) {
  Result<RawMesh> raw = readFile(input, partOf(monitor, kHashed, kRead));
  if (!raw) return raw.problems();
  std::optional<Repaired> repaired = repair(std::move(raw.value().triangles), partOf(monitor, kRead, kRepaired));
  if (!repaired) return problemOf(input, kCancelled);
  addRaw(raw.value(), repaired->facts);
  if (input.format() == Format::StlBinary) {
    const std::int64_t faces = repaired->facts.file_faces;
    repaired->facts.miscounted = faces - input.statedFaces();
    repaired->facts.skipped_bytes =
        static_cast<std::int64_t>(input.bytes() - kStlHeadBytes - static_cast<std::uint64_t>(faces) * kStlFaceBytes);
  }
  if (repaired->facts.faces == 0) return problemOf(input, nothingLeft(repaired->facts));
  if (!uniteRepaired(*repaired, partOf(monitor, kRepaired, kUnited))) return problemOf(input, kCancelled);
  Result<std::shared_ptr<const mesh::Surface>> surface =
      mesh::makeSurface(std::move(repaired->triangles), partOf(monitor, kUnited, kBuilt), raw.value().origin_M);
  if (monitor.isCancelled()) return problemOf(input, kCancelled);
  if (!surface) return problemOf(input, surface.problems()[0].sentence);
  Loaded loaded;
  loaded.surface = std::move(surface).value();
  loaded.facts = repaired->facts;
  if (loaded.surface->is_closed && !allowsWalls(loaded.facts)) loaded.surface = mesh::withoutInside(*loaded.surface);
  if (loaded.facts.inside == Inside::United) loaded.surface = mesh::asUnited(*loaded.surface);
  return loaded;
}

}  // namespace

Result<Loaded> loadMesh(const std::string& path, const TaskMonitor& monitor, const Cache& cache) {
  const Result<Input> input = Input::open(path);
  if (!input) return input.problems();
  const Result<std::string> checksum = input.value().checksum(partOf(monitor, 0.0, kHashed));
  if (!checksum) return checksum.problems();
  const std::string key = keyOf(input.value(), checksum.value());
  std::optional<Loaded> kept = fromCache(cache, key, monitor);
  if (monitor.isCancelled()) return problemOf(input.value(), kCancelled);
  Result<Loaded> loaded = kept ? Result<Loaded>(std::move(*kept)) : build(input.value(), monitor);
  if (!loaded) return loaded;
  loaded.value().format = input.value().format();
  loaded.value().checksum = checksum.value();
  if (!loaded.value().from_cache && !input.value().hasChanged()) {
    monitor.report(TRANSLATE_NOOP("step of work", "Storing"), kBuilt);
    const std::vector<std::byte> bytes = mesh::surfaceBytes(*loaded.value().surface);
    const std::array parts{std::as_bytes(std::span(&loaded.value().facts, 1)), std::span<const std::byte>(bytes)};
    cache.put(key, parts, monitor);
  }
  if (monitor.isCancelled()) return problemOf(input.value(), kCancelled);
  monitor.report(TRANSLATE_NOOP("step of work", "Ready"), 1.0);
  return loaded;
}

}  // namespace underact::mesh_file
