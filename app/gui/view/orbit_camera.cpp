#include "app/gui/view/orbit_camera.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace underact::gui {
namespace {

constexpr double kNearest_mm = 40.0, kFarthest_mm = 30000.0;
constexpr double kParallelEye = 1e4;  // of the distance

double slope(double share) {
  return std::tan(0.5 * OrbitCamera::kViewAngle_rad) * share;
}

}  // namespace

Vec3 OrbitCamera::right_W() const {
  return R_WD * Vec3(std::cos(azimuth_rad), 0.0, -std::sin(azimuth_rad));
}

Vec3 OrbitCamera::back_W() const {
  return R_WD * Vec3(std::sin(azimuth_rad) * std::cos(elevation_rad), std::sin(elevation_rad),
                     std::cos(azimuth_rad) * std::cos(elevation_rad));
}

Vec3 OrbitCamera::up_W() const {
  return back_W().cross(right_W());
}

Vec3 OrbitCamera::eye_mm() const {
  return focus_mm + (parallel ? kParallelEye : 1.0) * distance_mm * back_W();
}

OnScreen project(const OrbitCamera& camera, const QSizeF& size, const Vec3& p_mm) {
  const Vec3 from_eye_mm = p_mm - camera.eye_mm();
  const double depth_mm = camera.parallel ? camera.distance_mm : -from_eye_mm.dot(camera.back_W());
  const double pixel_mm = pixelLength_mm(size, std::max(depth_mm, 1e-6));
  return {{0.5 * size.width() + from_eye_mm.dot(camera.right_W()) / pixel_mm,
           0.5 * size.height() - from_eye_mm.dot(camera.up_W()) / pixel_mm},
          depth_mm};
}

double pixelLength_mm(const QSizeF& size, double depth_mm) {
  return 2.0 * depth_mm * slope(1.0) / std::max(size.height(), 1.0);
}

OrbitCamera orbited(OrbitCamera camera, const QSizeF& size, const QPointF& offset) {
  const double turn = kPi / std::max(size.height(), 1.0);
  camera.azimuth_rad = std::remainder(camera.azimuth_rad - turn * offset.x(), 2.0 * kPi);
  camera.elevation_rad = std::clamp(camera.elevation_rad + turn * offset.y(), -0.5 * kPi, 0.5 * kPi);
  return camera;
}

OrbitCamera panned(OrbitCamera camera, const QSizeF& size, const QPointF& offset) {
  const double pixel_mm = pixelLength_mm(size, camera.distance_mm);
  camera.focus_mm += pixel_mm * (offset.y() * camera.up_W() - offset.x() * camera.right_W());
  return camera;
}

OrbitCamera zoomed(OrbitCamera camera, const QSizeF& size, const QPointF& pointer, double factor) {
  const double distance_mm = std::clamp(factor * camera.distance_mm, kNearest_mm, kFarthest_mm);
  const double pixel_mm = pixelLength_mm(size, camera.distance_mm - distance_mm);  // may be negative: the way back
  camera.focus_mm += pixel_mm * ((pointer.x() - 0.5 * size.width()) * camera.right_W() -
                                 (pointer.y() - 0.5 * size.height()) * camera.up_W());
  camera.distance_mm = distance_mm;
  return camera;
}

OrbitCamera lookingFrom(OrbitCamera camera, const Vec3& from_W) {
  const Vec3 from_D = camera.R_WD.transpose() * from_W.normalized();
  camera.elevation_rad = std::asin(std::clamp(from_D.y(), -1.0, 1.0));
  camera.azimuth_rad = std::hypot(from_D.x(), from_D.z()) > 1e-6 ? std::atan2(from_D.x(), from_D.z()) : 0.0;
  return camera;
}

OrbitCamera fitted(OrbitCamera camera, const QSizeF& size, std::span<const Vec3> points_mm, const QMarginsF& room) {
  if (points_mm.empty() || size.isEmpty()) return camera;
  const Vec3 right_W = camera.right_W(), up_W = camera.up_W(), back_W = camera.back_W();
  // The slopes of the four planes through the eye that bound the picture; a narrow picture gives up its margins first.
  const double aspect = size.width() / size.height();
  const auto side = [](double margin, double length) { return slope(std::max(1.0 - 2.0 * margin / length, 0.3)); };
  const double to_right = aspect * side(room.right(), size.width()), to_left = aspect * side(room.left(), size.width());
  const double to_top = side(room.top(), size.height()), to_bottom = side(room.bottom(), size.height());
  if (camera.parallel) {
    Vec3 min = Vec3::Constant(kInfinity), max = -min;
    for (const Vec3& p_mm : points_mm) {
      const Vec3 p(p_mm.dot(right_W), p_mm.dot(up_W), p_mm.dot(back_W));
      min = min.cwiseMin(p);
      max = max.cwiseMax(p);
    }
    camera.distance_mm =
        std::clamp(std::max((max.x() - min.x()) / (to_right + to_left), (max.y() - min.y()) / (to_top + to_bottom)),
                   kNearest_mm, kFarthest_mm);
    const double x = 0.5 * (max.x() + min.x() + camera.distance_mm * (to_left - to_right));
    const double y = 0.5 * (max.y() + min.y() + camera.distance_mm * (to_bottom - to_top));
    camera.focus_mm = x * right_W + y * up_W + 0.5 * (min.z() + max.z()) * back_W;
    return camera;
  }
  // Each point keeps the eye behind the four planes: eye_z slope >= p_z slope + (p_x - eye_x), and so on.
  double right = -kInfinity, left = -kInfinity, top = -kInfinity, bottom = -kInfinity, depth_sum = 0.0;
  for (const Vec3& p_mm : points_mm) {
    const double x = p_mm.dot(right_W), y = p_mm.dot(up_W), z = p_mm.dot(back_W);
    right = std::max(right, to_right * z + x);
    left = std::max(left, to_left * z - x);
    top = std::max(top, to_top * z + y);
    bottom = std::max(bottom, to_bottom * z - y);
    depth_sum += z;
  }
  const double eye_z = std::max((right + left) / (to_right + to_left), (top + bottom) / (to_top + to_bottom));
  // In the looser direction: in the middle of what the planes allow.
  const double eye_x = 0.5 * ((right - to_right * eye_z) + (to_left * eye_z - left));
  const double eye_y = 0.5 * ((top - to_top * eye_z) + (to_bottom * eye_z - bottom));
  camera.distance_mm = std::clamp(eye_z - depth_sum / static_cast<double>(points_mm.size()), kNearest_mm, kFarthest_mm);
  camera.focus_mm = eye_x * right_W + eye_y * up_W + (eye_z - camera.distance_mm) * back_W;
  return camera;
}

OrbitCamera between(const OrbitCamera& a, const OrbitCamera& b, double share) {
  OrbitCamera camera;
  camera.parallel = b.parallel;
  camera.focus_mm = a.focus_mm + share * (b.focus_mm - a.focus_mm);
  camera.distance_mm = a.distance_mm * std::pow(b.distance_mm / a.distance_mm, share);
  camera.azimuth_rad = a.azimuth_rad + share * std::remainder(b.azimuth_rad - a.azimuth_rad, 2.0 * kPi);
  camera.elevation_rad = a.elevation_rad + share * (b.elevation_rad - a.elevation_rad);
  camera.R_WD = a.R_WD == b.R_WD || share >= 1.0
                    ? b.R_WD
                    : Eigen::Quaterniond(a.R_WD).slerp(share, Eigen::Quaterniond(b.R_WD)).toRotationMatrix();
  return camera;
}

}  // namespace underact::gui
