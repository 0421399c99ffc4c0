#pragma once
#include <string_view>
#include <vector>

#include "tests/error_bounds/row.h"

namespace underact::error_bounds {

/// All rows, in the order of the guide's table.
const std::vector<Row>& catalogue();

/// The row of that key, or null.
const Row* findRow(std::string_view key);

}  // namespace underact::error_bounds
