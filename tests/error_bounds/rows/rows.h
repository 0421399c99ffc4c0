#pragma once
#include <span>

#include "tests/error_bounds/row.h"

namespace underact::error_bounds {

// The parts of the catalogue, each in the source file of its name. A new part is a line here and in catalogue.cpp.
extern const std::span<const Row> kBaseRows;
extern const std::span<const Row> kShapeRows;
extern const std::span<const Row> kWeightedShapeRows;
extern const std::span<const Row> kMeshRows;
extern const std::span<const Row> kMeshWalkRows;
extern const std::span<const Row> kCurveRows;
extern const std::span<const Row> kInfluenceRows;
extern const std::span<const Row> kArmRows;
extern const std::span<const Row> kArmSolverRows;
extern const std::span<const Row> kChainRows;
extern const std::span<const Row> kChainSolverRows;
extern const std::span<const Row> kManipulatorRows;
extern const std::span<const Row> kAngleRows;
extern const std::span<const Row> kLawRows;
extern const std::span<const Row> kFilterRows;
extern const std::span<const Row> kGateRows;
extern const std::span<const Row> kPlantRows;
extern const std::span<const Row> kTickRows;
extern const std::span<const Row> kDriftRows;

}  // namespace underact::error_bounds
