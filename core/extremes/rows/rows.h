#pragma once
#include <span>

#include "core/extremes/row.h"

namespace underact::extremes {

// The parts of the catalogue, each in the source file that its name says. A new part is a line here and in
// catalogue.cpp.
std::span<const Row> baseRows();
std::span<const Row> shapeRows();
std::span<const Row> weightedShapeRows();
std::span<const Row> meshRows();
std::span<const Row> meshWalkRows();
std::span<const Row> curveRows();
std::span<const Row> influenceRows();
std::span<const Row> armRows();
std::span<const Row> armSolverRows();
std::span<const Row> chainRows();
std::span<const Row> chainSolverRows();
std::span<const Row> manipulatorRows();
std::span<const Row> angleRows();
std::span<const Row> lawRows();
std::span<const Row> filterRows();
std::span<const Row> gateRows();
std::span<const Row> plantRows();
std::span<const Row> tickRows();
std::span<const Row> driftRows();

}  // namespace underact::extremes
