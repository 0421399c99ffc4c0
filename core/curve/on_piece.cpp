#include "core/curve/on_piece.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/curve/along.h"

namespace underact::curve {
namespace {

using Quintic = std::array<double, 6>;  // Bernstein's coefficients

/// A part of a cubic, from u on, relative to q.
struct Part {
  Cubic r;
  double u;
  double width;
};

/// (p - q).p' / 3 over a part.
Quintic slopeOf(const Cubic& r) noexcept UNDERACT_REAL_TIME {
  const Vec3 h0 = r[1] - r[0], h1 = r[2] - r[1], h2 = r[3] - r[2];
  return {h0.dot(r[0]),
          (3.0 * h0.dot(r[1]) + 2.0 * h1.dot(r[0])) / 5.0,
          (3.0 * h0.dot(r[2]) + 6.0 * h1.dot(r[1]) + h2.dot(r[0])) / 10.0,
          (h0.dot(r[3]) + 6.0 * h1.dot(r[2]) + 3.0 * h2.dot(r[1])) / 10.0,
          (2.0 * h1.dot(r[3]) + 3.0 * h2.dot(r[2])) / 5.0,
          h2.dot(r[3])};
}

/// A lower bound of the squared distance of the part: the least coefficient of it.
double minOfPiece(const Cubic& r, const Quintic& slope) noexcept UNDERACT_REAL_TIME {
  double sum = r[0].squaredNorm(), min = sum;
  for (const double g : slope) {
    sum += g;
    min = std::min(min, sum);
  }
  return std::max(min, 0.0);
}

struct Value {
  double value;
  double slope;
};

Value valueOf(Quintic g, double v) noexcept UNDERACT_REAL_TIME {
  for (std::size_t left = 5; left > 1; --left) {
    for (std::size_t i = 0; i < left; ++i) g[i] += v * (g[i + 1] - g[i]);
  }
  const double rise = g[1] - g[0];
  return {g[0] + v * rise, 5.0 * rise};
}

/// The root of a quintic whose coefficients increase from below to above 0.
double rootOf(const Quintic& g) noexcept UNDERACT_REAL_TIME {
  double low = 0.0, high = 1.0, v = g[0] / (g[0] - g[5]), width = 1.0;
  for (int i = 0; i < 64; ++i) {
    const Value at = valueOf(g, v);
    if (at.value == 0.0) break;
    (at.value < 0.0 ? low : high) = v;
    double next = at.slope > 0.0 ? v - at.value / at.slope : 2.0;
    if (i % 2 == 1) {  // two steps that did not halve the bracket
      if (high - low > 0.5 * width) next = 2.0;
      width = high - low;
    }
    if (std::abs(next - v) <= 0x1p-53) break;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (next == low || next == high) break;
    v = next;
  }
  return v;
}

void offerAt(const Curve& curve, std::int32_t piece, double u, const Vec3& q_W,
             Found& found) noexcept UNDERACT_REAL_TIME {
  const Vec3 p_W = pointOn(curve, piece, u);
  const double squared = (p_W - q_W).squaredNorm();
  if (squared <= found.limit) offer({squared, p_W, piece, u}, found);
}

void seekOnLine(const Curve& curve, std::int32_t piece, const Vec3& q_W, Found& found) noexcept UNDERACT_REAL_TIME {
  if (!visit(found)) return;
  const Vec3& p_WA = curve.controls_W[static_cast<std::size_t>(piece)];
  const Vec3 along_W = curve.controls_W[static_cast<std::size_t>(piece) + 1] - p_WA;
  const double foot = (q_W - p_WA).dot(along_W), whole = along_W.squaredNorm();
  const double u = foot <= 0.0 ? 0.0 : foot >= whole ? 1.0 : foot / whole;
  offerAt(curve, piece, u, q_W, found);
}

void seekOnCubic(const Curve& curve, std::int32_t piece, const Vec3& q_W, Found& found) noexcept UNDERACT_REAL_TIME {
  std::array<Part, kMaxParts> parts;
  std::size_t count = 1;
  parts[0] = {cubicOf(curve, piece), 0.0, 1.0};
  for (Vec3& r : parts[0].r) r -= q_W;
  while (count > 0) {
    if (!visit(found)) return;
    const Part part = parts[--count];
    const Quintic g = slopeOf(part.r);
    const double min = minOfPiece(part.r, g);
    if (min > found.limit) continue;
    const bool ends_nearer = part.r[3].squaredNorm() < part.r[0].squaredNorm();
    const auto offerFrom = [&](double v) noexcept UNDERACT_REAL_TIME {
      offerAt(curve, piece, part.u + part.width * v, q_W, found);
    };
    if (std::all_of(g.begin(), g.end(), [](double x) noexcept UNDERACT_REAL_TIME { return x >= 0.0; })) {
      offerFrom(0.0);
    } else if (std::all_of(g.begin(), g.end(), [](double x) noexcept UNDERACT_REAL_TIME { return x <= 0.0; })) {
      offerFrom(1.0);
    } else if (std::is_sorted(g.begin(), g.end())) {
      offerFrom(rootOf(g));
    } else if (part.width <= kSmallest || min >= (1.0 - kFlat) * found.best.squared) {
      offerFrom(ends_nearer ? 1.0 : 0.0);
    } else {
      const Halves halves = halvesOf(part.r);
      const double width = 0.5 * part.width;
      Part& first = parts[count + (ends_nearer ? 0 : 1)];  // the nearer half next, for its limit
      Part& second = parts[count + (ends_nearer ? 1 : 0)];
      first = {halves.first, part.u, width};
      second = {halves.second, part.u + width, width};
      count += 2;
    }
  }
}

}  // namespace

void seekOnPiece(const Curve& curve, std::int32_t piece, const Vec3& q_W, Found& found) noexcept {
  if (curve.kind == CurveKind::Spline) {
    seekOnCubic(curve, piece, q_W, found);
  } else {
    seekOnLine(curve, piece, q_W, found);
  }
}

}  // namespace underact::curve
