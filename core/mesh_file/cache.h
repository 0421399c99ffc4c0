#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/watch.h"

namespace underact::mesh_file {

/// What was built from files, kept between runs, so that a mesh opens at once the second time. Safe to delete at any
/// time; what is damaged or of another version counts as not there. Several programs may use it at once: each entry is
/// written aside and then renamed. A folder that is missing or may not be written is no error: then nothing is kept.
class Cache {
 public:
  /// folder empty: UNDERACT_CACHE_DIR, else underact/meshes in XDG_CACHE_HOME, else in ~/.cache. most_bytes: of all
  /// entries; past it the ones used longest ago go.
  explicit Cache(std::string folder = {}, std::uint64_t most_bytes = std::uint64_t{1} << 30);

  const std::string& folder() const { return folder_; }

  /// What was put under the key; none where it is not there, not whole, or where it was cancelled.
  std::optional<std::vector<std::byte>> get(const std::string& key, const Watch& watch = {}) const;

  /// parts: one after the other, as one. false: not kept.
  bool put(const std::string& key, std::span<const std::span<const std::byte>> parts, const Watch& watch = {}) const;

 private:
  void makeRoom() const;
  std::string folder_;
  std::uint64_t most_bytes_;
};

}  // namespace underact::mesh_file
