#pragma once
#include "core/base/types.h"

namespace underact {

/// Of a finite square matrix of at least 1 and at most 6 rows; nothing is allocated (Eigen's PartialPivLU).
using AtMostSix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;
double determinantOf(const AtMostSix& matrix);

}  // namespace underact
