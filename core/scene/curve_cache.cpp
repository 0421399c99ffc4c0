#include "core/scene/curve_cache.h"

#include <algorithm>
#include <mutex>
#include <utility>
#include <vector>

#include "core/base/nearest_rotation.h"
#include "core/base/units.h"

namespace underact::scene {
namespace {

/// All input of a curve, and the curve made of it, which this does not keep alive.
struct Kept {
  std::weak_ptr<const std::vector<Vec3>> points;
  curve::CurveKind kind = curve::CurveKind::Spline;
  bool closed = false;
  double scale_mm_per_unit = 1.0;
  Eigen::Matrix4d X_WM = Eigen::Matrix4d::Identity();
  std::weak_ptr<const curve::Curve> made;
};

bool isOf(const Kept& kept, const Curve& curve) {
  return kept.points.lock() == curve.points && kept.kind == curve.kind && kept.closed == curve.closed &&
         kept.scale_mm_per_unit == curve.scale_mm_per_unit && kept.X_WM == curve.X_WM;
}

Result<std::shared_ptr<const curve::Curve>> makeInWorkspace(const Curve& curve, const SourceLocation& place) {
  const Mat3 R_WM = nearestRotation(Mat3(curve.X_WM.topLeftCorner<3, 3>()));
  const Vec3 p_WM = kMetrePerMillimetre * curve.X_WM.topRightCorner<3, 1>();
  const double scale_m = kMetrePerMillimetre * curve.scale_mm_per_unit;
  std::vector<Vec3> points_W;
  points_W.reserve(curve.points->size());
  for (const Vec3& p_M : *curve.points) points_W.push_back(p_WM + scale_m * (R_WM * p_M));
  return curve::makeCurve(std::move(points_W), curve.kind, curve.closed, place);
}

}  // namespace

Result<std::shared_ptr<const curve::Curve>> cachedCurve(const Curve& curve, const SourceLocation& place) {
  static std::mutex mutex;
  static std::vector<Kept> all;
  {
    const std::scoped_lock lock(mutex);
    std::erase_if(all, [](const Kept& kept) { return kept.points.expired() || kept.made.expired(); });
    const auto found = std::find_if(all.begin(), all.end(), [&](const Kept& kept) { return isOf(kept, curve); });
    if (found != all.end()) {
      if (std::shared_ptr<const curve::Curve> made = found->made.lock()) return made;
    }
  }
  auto made = makeInWorkspace(curve, place);  // without the lock: another thread may ask for another one
  if (!made) return made.problems();
  const std::scoped_lock lock(mutex);
  all.push_back({curve.points, curve.kind, curve.closed, curve.scale_mm_per_unit, curve.X_WM, made.value()});
  return made;
}

}  // namespace underact::scene
