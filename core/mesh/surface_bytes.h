#pragma once
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "core/mesh/surface.h"

namespace underact::mesh {

/// A surface as bytes to be kept, and back. Null: damaged, or of another version.
std::vector<std::byte> surfaceBytes(const Surface& surface);
std::shared_ptr<const Surface> surfaceOfBytes(std::span<const std::byte> bytes);

}  // namespace underact::mesh
