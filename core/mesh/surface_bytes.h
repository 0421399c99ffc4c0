#pragma once
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "core/mesh/surface.h"

namespace underact::mesh {

/// A surface as bytes, for a cache: for builds whose Node is laid out alike.
std::vector<std::byte> surfaceBytes(const Surface& surface);

/// Back again. Null where the bytes are none of a surface or any index in them leads nowhere: whatever they are, what
/// comes back is safe in the tick.
std::shared_ptr<const Surface> surfaceOfBytes(std::span<const std::byte> bytes);

}  // namespace underact::mesh
