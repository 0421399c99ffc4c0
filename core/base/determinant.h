#pragma once
#include "core/base/types.h"

namespace underact {

using AtMostSix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;  // allocates nothing

/// Of a finite square matrix of at least one row and at most six (Eigen's PartialPivLU).
double determinantOf(const AtMostSix& matrix);

}  // namespace underact
