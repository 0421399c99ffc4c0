#pragma once
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "core/mesh/surface.h"

namespace underact::mesh {

/// A surface as bytes, for a cache: readable by builds whose Node has the same layout.
std::vector<std::byte> surfaceBytes(const Surface& surface);

/// The surface of such bytes. Null where they are not of a surface, or an index in them is out of range: whatever the
/// bytes, the result is safe in the tick.
std::shared_ptr<const Surface> surfaceOfBytes(std::span<const std::byte> bytes);

}  // namespace underact::mesh
