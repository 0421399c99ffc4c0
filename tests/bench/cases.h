#pragma once
#include <string>
#include <vector>

#include "core/shape/shape.h"

namespace underact::bench {

struct NamedShape {
  std::string name;
  shape::Shape shape;
};

/// One of each type, in the places of the thesis's tests.
inline std::vector<NamedShape> shapes() {
  return {{"point", shape::makePoint({0, 0, 0}, {}).value()},
          {"sphere", shape::makeSphere({0, 0, 0}, 0.05, {}).value()},
          {"line", shape::makeLine({0, 0.03, 0}, {-1, -2, 1}, {}).value()},
          {"plane", shape::makePlane({0, 0, 0}, {1, 1, 1}, {}).value()},
          {"circle", shape::makeCircle({0.01, 0.02, 0.03}, {-1, 1, -1}, 0.04, {}).value()},
          {"cylinder", shape::makeCylinder({0.03, 0, 0.03}, {-1, 1, -1}, 0.03, {}).value()},
          {"box", shape::makeBox({0, 0, 0}, {0.06, 0.06, 0.06}, Mat3::Identity(), {}).value()}};
}

}  // namespace underact::bench
