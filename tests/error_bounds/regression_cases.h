#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace underact::error_bounds {

/// A worst case that is stored: its row, its error when it was found, and its numbers.
struct RegressionCase {
  std::string key;
  double error_ulp = 0.0;
  std::vector<double> input;
};

/// The cases as a table: key, error_ulp, and the numbers separated by blanks. Numbers read back to the same double; NaN
/// is "nan".
std::string textOf(std::span<const RegressionCase> kept);

/// Reads such a table. Problems, each with its line: not three columns, not a number.
Result<std::vector<RegressionCase>> readRegressionCases(std::string_view text, const std::string& file_name);

}  // namespace underact::error_bounds
