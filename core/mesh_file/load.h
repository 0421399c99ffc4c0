#pragma once
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/base/task_monitor.h"
#include "core/mesh/surface.h"
#include "core/mesh_file/cache.h"
#include "core/mesh_file/facts.h"
#include "core/mesh_file/format.h"

namespace underact::mesh_file {

/// A mesh that is ready to be felt.
struct Loaded {
  std::shared_ptr<const mesh::Surface> surface;
  Facts facts;
  Format format = Format::Obj;
  std::string checksum;  // XXH3 of the file, 32 hexadecimal digits
  bool from_cache = false;
};

/// Reads, repairs and builds a mesh and stores it in the cache; or takes it from there if the same bytes were loaded
/// before. Any thread but the servo's. Progress never decreases; a cancelled call returns within 0.2 s with kCancelled.
/// Problems: not a mesh file, damaged, or without a face that can be felt.
Result<Loaded> loadMesh(const std::string& path, const TaskMonitor& monitor = {}, const Cache& cache = Cache());

}  // namespace underact::mesh_file
