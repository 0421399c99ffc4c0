#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "core/shape/shape.h"

// ns for each closest point, over points on and off the shapes as a hand would have them; the alternative of a shape is
// the same shape in the metric of unequal gains.
namespace underact {
namespace {

struct Case {
  const char* name;
  shape::Shape shape;
};

std::vector<Case> cases() {
  return {{"point", shape::makePoint({0, 0, 0}, {}).value()},
          {"sphere", shape::makeSphere({0, 0, 0}, 0.05, {}).value()},
          {"line", shape::makeLine({0, 0.03, 0}, {-1, -2, 1}, {}).value()},
          {"plane", shape::makePlane({0, 0, 0}, {1, 1, 1}, {}).value()},
          {"circle", shape::makeCircle({0.01, 0.02, 0.03}, {-1, 1, -1}, 0.04, {}).value()},
          {"cylinder", shape::makeCylinder({0.03, 0, 0.03}, {-1, 1, -1}, 0.03, {}).value()},
          {"box", shape::makeBox({0, 0, 0}, {0.06, 0.06, 0.06}, Mat3::Identity(), {}).value()}};
}

void measure(benchmark::State& state, const shape::Shape& shape) {
  std::vector<Vec3> tips;
  for (int i = 0; i < 1024; ++i) tips.push_back(0.001 * Vec3(i % 97 - 48, i % 61 - 30, i % 53 - 26.5));
  std::size_t next = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(closestPoint(shape, tips[next]));
    next = (next + 1) % tips.size();
  }
}

const bool kRegistered = [] {
  for (const Case& one : cases()) {
    benchmark::RegisterBenchmark((std::string("closest/") + one.name).c_str(), measure, one.shape);
    benchmark::RegisterBenchmark((std::string("closest_weighted/") + one.name).c_str(), measure,
                                 shape::scaled(one.shape, Vec3(1.0, 0.5, 0.7)));
  }
  return true;
}();

}  // namespace
}  // namespace underact
