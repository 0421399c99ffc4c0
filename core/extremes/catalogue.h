#pragma once
#include <string_view>
#include <vector>

#include "core/extremes/row.h"

namespace underact::extremes {

/// All rows, in the order of the guide's table.
const std::vector<Row>& catalogue();

/// The row of that key, or null.
const Row* findRow(std::string_view key);

}  // namespace underact::extremes
