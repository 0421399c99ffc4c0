#include "app/gui/view/solid_forms.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace underact::gui {
namespace {

constexpr int kEdgeParts = 2, kCapParts = 4;

void addQuarter(std::vector<Ring>& profile, double radius, double z, double edge, double from_rad, int parts) {
  for (int part = 0; part <= parts; ++part) {
    const double angle_rad = from_rad + 0.5 * kPi * part / parts;
    profile.push_back({radius + edge * std::cos(angle_rad), z + edge * std::sin(angle_rad)});
  }
}

}  // namespace

Pose frameAlong(const Vec3& p_W, const Vec3& z_W) {
  Pose X_WS = Pose::Identity();
  const Vec3 x_W = z_W.unitOrthogonal();
  X_WS.linear() << x_W, z_W.cross(x_W), z_W;
  X_WS.translation() = p_W;
  return X_WS;
}

std::vector<Ring> roundedRod(double from_m, double to_m, double radius_m, double edge_m) {
  const double edge = std::min({edge_m, radius_m, 0.5 * std::abs(to_m - from_m)});
  std::vector<Ring> profile{{0.0, from_m}};
  addQuarter(profile, radius_m - edge, from_m + edge, edge, -0.5 * kPi, kEdgeParts);
  addQuarter(profile, radius_m - edge, to_m - edge, edge, 0.0, kEdgeParts);
  profile.push_back({0.0, to_m});
  return profile;
}

std::vector<Ring> taperedRod(double from_m, double to_m, double from_radius_m, double to_radius_m) {
  std::vector<Ring> profile;
  addQuarter(profile, 0.0, from_m, from_radius_m, -0.5 * kPi, kCapParts);
  addQuarter(profile, 0.0, to_m, to_radius_m, 0.0, kCapParts);
  profile.front().radius = profile.back().radius = 0.0;
  return profile;
}

std::vector<std::array<Eigen::Vector2d, 2>> stripNormals(std::span<const Ring> profile) {
  constexpr double kSmooth = 0.69;  // the cosine of the angle between strips: 45 degrees and less
  std::vector<Eigen::Vector2d> own;
  std::vector<double> lengths;
  for (std::size_t strip = 0; strip + 1 < profile.size(); ++strip) {
    const Eigen::Vector2d offset(profile[strip + 1].radius - profile[strip].radius,
                                 profile[strip + 1].z - profile[strip].z);
    const double length = offset.norm();
    lengths.push_back(length);
    own.push_back(length > 0.0 ? Eigen::Vector2d(offset.y() / length, -offset.x() / length) : Eigen::Vector2d::Zero());
  }
  for (std::size_t strip = 0; strip < own.size(); ++strip) {  // without length: as its neighbour
    if (own[strip].isZero() && strip > 0) own[strip] = own[strip - 1];
  }
  // By their lengths: the side of a rod is straight up to its rounded edge.
  const auto between = [&](std::size_t strip, std::size_t other) {
    const Eigen::Vector2d sum = lengths[strip] * own[strip] + lengths[other] * own[other];
    return own[strip].dot(own[other]) > kSmooth && !sum.isZero() ? Eigen::Vector2d(sum.normalized()) : own[strip];
  };
  std::vector<std::array<Eigen::Vector2d, 2>> normals;
  for (std::size_t strip = 0; strip < own.size(); ++strip) {
    normals.push_back({strip > 0 ? between(strip, strip - 1) : own[strip],
                       strip + 1 < own.size() ? between(strip, strip + 1) : own[strip]});
  }
  return normals;
}

}  // namespace underact::gui
