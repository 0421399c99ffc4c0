#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "core/base/units.h"
#include "core/curve/curve.h"
#include "tests/support/property.h"

namespace underact::curve {

/// A curve said a second time and in other words: a polyline by its points, a spline by Barry and Goldman's pyramid
/// over knots, in long double. Shares no line with core/curve.
class Oracle {
 public:
  using Long = long double;
  using Point = Eigen::Matrix<Long, 3, 1>;

  Oracle(const std::vector<Vec3>& points_W, CurveKind kind, bool closed) : kind_(kind) {
    for (const Vec3& p_W : points_W) points_.push_back(p_W.cast<Long>());
    const Point before = closed ? points_.back() : Point(2.0L * points_[0] - points_[1]);
    const Point last = points_.back(), last_but_one = points_[points_.size() - 2];
    pieces_ = static_cast<int>(points_.size()) - (closed ? 0 : 1);
    if (closed) {
      const Point first = points_[0], second = points_[1];
      points_.push_back(first);
      points_.push_back(second);
    } else {
      points_.push_back(2.0L * last - last_but_one);
    }
    points_.insert(points_.begin(), before);
  }

  int pieces() const { return pieces_; }

  /// The point of piece i at a share of it: of its knots' interval, which a line goes through evenly, too.
  Point at(int i, Long share) const {
    const Point* p = &points_[static_cast<std::size_t>(i)];
    if (kind_ == CurveKind::Polyline) return p[1] + share * (p[2] - p[1]);
    Long knot[4] = {0, 0, 0, 0};
    for (int k = 0; k < 3; ++k) knot[k + 1] = knot[k] + std::sqrt((p[k + 1] - p[k]).norm());
    const Long t = knot[1] + share * (knot[2] - knot[1]);
    Point level[4] = {p[0], p[1], p[2], p[3]};
    for (int width = 1; width <= 3; ++width) {
      for (int k = 0; k + width <= 3; ++k) {
        // The middle one of the last but one level has the interval of the piece itself, not of its width.
        const int from = width == 3 ? 1 : k, to = width == 3 ? 2 : k + width;
        level[k] = ((knot[to] - t) * level[k] + (t - knot[from]) * level[k + 1]) / (knot[to] - knot[from]);
      }
    }
    return level[0];
  }

  /// The least distance from q that `samples` shares of each piece and a ternary search about each valley among them
  /// find; never too small.
  Long distance(const Vec3& q_W, int samples) const {
    const Point q = q_W.cast<Long>();
    Long best = std::numeric_limits<Long>::infinity();
    for (int i = 0; i < pieces_; ++i) best = std::min(best, distanceOfPiece(q, i, samples));
    return best;
  }

 private:
  Long distanceOfPiece(const Point& q, int i, int samples) const {
    const auto off = [&](Long share) { return (at(i, share) - q).norm(); };
    if (kind_ == CurveKind::Polyline) return offLine(q, at(i, 0), at(i, 1));
    Long best = std::numeric_limits<Long>::infinity();
    std::vector<Long> values;
    for (int k = 0; k <= samples; ++k) values.push_back(off(static_cast<Long>(k) / samples));
    for (int k = 0; k <= samples; ++k) {
      const auto value = [&](int j) { return values[static_cast<std::size_t>(std::clamp(j, 0, samples))]; };
      if (value(k) > value(k - 1) || value(k) > value(k + 1)) continue;
      Long low = static_cast<Long>(std::max(k - 1, 0)) / samples,
           high = static_cast<Long>(std::min(k + 1, samples)) / samples;
      for (int round = 0; round < 100; ++round) {
        const Long a = low + (high - low) / 3, b = high - (high - low) / 3;
        (off(a) < off(b) ? high : low) = off(a) < off(b) ? b : a;
      }
      best = std::min({best, value(k), off(low)});
    }
    return best;
  }

  static Long offLine(const Point& q, const Point& a, const Point& b) {
    const Long share = std::clamp((q - a).dot(b - a) / (b - a).squaredNorm(), 0.0L, 1.0L);
    return (a + share * (b - a) - q).norm();
  }

  CurveKind kind_;
  int pieces_ = 0;
  std::vector<Point> points_;  // with the one before and the one behind
};

inline std::shared_ptr<const Curve> curveOf(const std::vector<Vec3>& points_W, CurveKind kind, bool closed = false) {
  return makeCurve(points_W, kind, closed).value();
}

/// A hand-sized path of steps in random directions, each turning by a part of the last one.
inline std::vector<Vec3> randomPath(test::Random& random, int count, double step_m) {
  std::vector<Vec3> points_W{random.inBox(0.05)};
  Vec3 heading = random.direction();
  for (int i = 1; i < count; ++i) {
    heading = (heading + random.between(0.0, 1.5) * random.direction()).normalized();
    points_W.push_back(points_W.back() + step_m * random.between(0.05, 2.0) * heading);
  }
  return points_W;
}

}  // namespace underact::curve
