#include "tests/support/stroke.h"

#include <cmath>

#include "tests/support/crossed_bodies.h"

namespace underact::test {

bool Stroke::begin(const Vec3& q_M) {
  state_ = {};
  q_M_ = q_M;
  clear_ = 0.0;
  return distance(q_M) > near_ && windingOf(triangles_, q_M) < 0.5L && goOn(q_M);
}

bool Stroke::goTo(const Vec3& q_M, double step) {
  const Vec3 from_M = q_M_;
  const int ticks = static_cast<int>(std::ceil((q_M - from_M).norm() / step));
  for (int tick = 1; tick <= ticks; ++tick) {
    if (!goOn(from_M + (q_M - from_M) * (static_cast<double>(tick) / ticks))) return false;
  }
  return true;
}

bool Stroke::strike(const std::vector<Vec3>& aims, Random& random) {
  Vec3 through_M;
  do {
    through_M = aims[random.below(aims.size())] + random.between(0.0, 3.0) * random.direction();
  } while (!begin(through_M + random.between(0.5, 8.0) * random.direction()));
  const double step = std::exp(random.between(std::log(0.01), std::log(1.5)));
  for (int turn = 0; turn < 4; ++turn) {
    if (!goTo(through_M, step)) return false;
    through_M += random.between(0.5, 6.0) * random.direction();
  }
  return true;
}

bool Stroke::goOn(const Vec3& q_M) {
  const mesh::Hit hit = followProxy(surface_, mesh::FreeSide::Outside, q_M, state_);
  clear_ -= (q_M - q_M_).norm();
  q_M_ = q_M;
  if (hit.face >= 0) {
    clear_ = 0.0;
    ++held_;
    return true;
  }
  if (clear_ > 0.0) return true;
  clear_ = distance(q_M);
  return clear_ < near_ || windingOf(triangles_, q_M) < 0.5L;
}

double Stroke::distance(const Vec3& q_M) const {
  mesh::SearchState search;
  return std::sqrt(nearestPoint(surface_, mesh::Search::Global, q_M, search).squared);
}

}  // namespace underact::test
