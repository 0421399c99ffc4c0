#include "core/base/determinant.h"

#include <Eigen/LU>

namespace underact {

double determinantOf(const AtMostSix& matrix) {
  return matrix.partialPivLu().determinant();
}

}  // namespace underact
