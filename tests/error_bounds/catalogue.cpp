#include "tests/error_bounds/catalogue.h"

#include <algorithm>

#include "tests/error_bounds/rows/rows.h"

namespace underact::error_bounds {

const std::vector<Row>& catalogue() {
  static const std::vector<Row> kAll = [] {
    std::vector<Row> all;
    for (const std::span<const Row> rows :
         {kBaseRows, kShapeRows, kWeightedShapeRows, kMeshRows, kMeshWalkRows, kCurveRows, kInfluenceRows, kArmRows,
          kArmSolverRows, kChainRows, kChainSolverRows, kManipulatorRows, kAngleRows, kLawRows, kFilterRows, kGateRows,
          kPlantRows, kTickRows, kDriftRows})
      all.insert(all.end(), rows.begin(), rows.end());
    return all;
  }();
  return kAll;
}

const Row* findRow(std::string_view key) {
  const std::vector<Row>& all = catalogue();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Row& row) { return row.key == key; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace underact::error_bounds
