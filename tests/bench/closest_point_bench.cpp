#include <benchmark/benchmark.h>

#include "tests/bench/cases.h"

// ns for each closest point, over points on and off the shapes as a hand would have them; the alternative of a shape is
// the same shape in the metric of unequal gains.
namespace underact {
namespace {

void measureClosestPoint(benchmark::State& state, const shape::Shape& shape) {
  std::vector<Vec3> tips;
  for (int i = 0; i < 1024; ++i) tips.push_back(0.001 * Vec3(i % 97 - 48, i % 61 - 30, i % 53 - 26.5));
  std::size_t next = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(closestPoint(shape, tips[next]));
    next = (next + 1) % tips.size();
  }
}

const bool kShapesRegistered = [] {
  for (const bench::NamedShape& one : bench::shapes()) {
    benchmark::RegisterBenchmark(("closest/" + one.name).c_str(), measureClosestPoint, one.shape);
    benchmark::RegisterBenchmark(("closest_weighted/" + one.name).c_str(), measureClosestPoint,
                                 shape::scaled(one.shape, Vec3(1.0, 0.5, 0.7)));
  }
  return true;
}();

}  // namespace
}  // namespace underact
