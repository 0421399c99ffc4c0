#pragma once
#include <vector>

#include "core/arm/preset.h"
#include "core/record/table.h"
#include "core/servo/snapshot.h"

namespace underact::record {

/// The columns of /ticks. Lengths mm, angles rad, forces N.
std::span<const Column> tickColumns();

/// Packs one row. geometry: of the arm, for the stylus's orientation, which the servo computes only where a scene needs
/// it.
void pack(const servo::TickRecord& record, const arm::Geometry& geometry, Packer& packer);

/// The turn of the stylus in W as a quaternion, w x y z: column quat_WT. Not numbers where the arm gave no sample.
Eigen::Vector4d turnOf(const servo::TickRecord& record, const arm::Geometry& geometry);

/// The rows of a block. Lengths come back in m; what the file does not hold keeps its default.
std::vector<servo::TickRecord> unpackTicks(const Block& block);

}  // namespace underact::record
