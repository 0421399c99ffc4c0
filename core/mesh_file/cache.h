#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/task_monitor.h"

namespace underact::mesh_file {

/// Surfaces built from files, kept between runs, so that a mesh opens at once the second time. Safe to delete at any
/// time; an entry that is damaged or of another version counts as missing. Several programs may use it at once: each
/// entry is written aside and then renamed. A folder that is missing or not writable is no error: nothing is kept then.
class Cache {
 public:
  /// folder empty: UNDERACT_CACHE_DIR, else underact/meshes in XDG_CACHE_HOME, else in ~/.cache. max_bytes: of all
  /// entries; beyond it the least recently used ones are removed.
  explicit Cache(std::string folder = {}, std::uint64_t max_bytes = std::uint64_t{1} << 30);

  const std::string& folder() const { return folder_; }

  /// The bytes under the key; none where they are missing or damaged, or where it was cancelled.
  std::optional<std::vector<std::byte>> get(const std::string& key, const TaskMonitor& monitor = {}) const;

  /// Stores the parts, one after the other, under the key. false: not stored.
  bool put(const std::string& key, std::span<const std::span<const std::byte>> parts,
           const TaskMonitor& monitor = {}) const;

 private:
  void makeRoom() const;
  std::string folder_;
  std::uint64_t max_bytes_;
};

}  // namespace underact::mesh_file
