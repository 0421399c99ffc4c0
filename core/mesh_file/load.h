#pragma once
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/base/watch.h"
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

/// From a file, or from the cache where the same bytes were loaded before: reads, repairs, builds, keeps. Any thread
/// but the servo's. Tells its steps with a share that only grows; a cancelled one ends within 0.2 s, with kCancelled.
/// Problems: the file is none, is damaged, or has no face that can be felt.
Result<Loaded> loadMesh(const std::string& path, const Watch& watch = {}, const Cache& cache = Cache());

}  // namespace underact::mesh_file
