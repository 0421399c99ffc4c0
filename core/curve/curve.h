#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/result.h"
#include "core/curve/boxes.h"

namespace underact::curve {

/// How the points are joined. Polyline: by straight lines. Spline: by cubics through every point, see spline.h.
enum class CurveKind : std::uint8_t { Polyline, Spline };

/// A path through points of the workspace; const from makeCurve() on. A sequence of pieces: straight lines, or cubic
/// Bezier curves, of which one between two points is split where its arc length requires it.
struct Curve {
  CurveKind kind = CurveKind::Polyline;
  bool is_closed = false;        // ends where it begins
  std::vector<Vec3> controls_W;  // m; of piece i: controlsPerPiece() and one more from there times i on
  std::vector<double> s_m;       // arc length from the begin to that of each piece, and to the end
  double largest_m = 0.0;        // of all coordinates
  Boxes boxes;
};

/// Neighbours nearer to each other than this, or than the rounding of their coordinates, are merged: they would give
/// the curve a direction that is noise.
inline constexpr double kSamePoint_m = 1e-12;
/// A coordinate beyond this is a mistake of units, as everywhere in scenes (1e6 mm).
inline constexpr double kFarthest_m = 1e3;

/// A curve through points_W, m, in their order; closed: and back to the first. Allocates; a million points take 0.2 s
/// and 61 MB, a spline of them 1 s and 170 MB (with sharp corners everywhere 3 s and 500 MB). Problems: fewer than 2
/// different points (closed: 3), more than kMaxPoints, one that is not finite or too far out.
Result<std::shared_ptr<const Curve>> makeCurve(std::vector<Vec3> points_W, CurveKind kind, bool closed,
                                               const SourceLocation& place = {});

/// How much memory it takes.
std::size_t bytesOf(const Curve& curve);

/// Controls of a piece that the next one does not share: 3 for a cubic, 1 for a line.
inline int controlsPerPiece(CurveKind kind) noexcept UNDERACT_REAL_TIME {
  return kind == CurveKind::Spline ? 3 : 1;
}
/// At least 1 for a curve of makeCurve().
inline std::int32_t pieceCount(const Curve& curve) noexcept UNDERACT_REAL_TIME {
  return static_cast<std::int32_t>(curve.s_m.size()) - 1;
}
/// Arc length from the begin to the end, m; of a closed curve once round.
inline double lengthOf(const Curve& curve) noexcept UNDERACT_REAL_TIME {
  return curve.s_m[curve.s_m.size() - 1];
}

}  // namespace underact::curve
