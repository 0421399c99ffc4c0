#include "core/target/placing.h"

#include <cmath>

namespace underact::target {
namespace {

// Kinds: one for each shape, and for each way in which it is held.
constexpr std::int64_t kOfInfluenced = 32, kOfMesh = 64;
// Opposite directions have no shorter arc between them: they change over in the middle.
constexpr double kOpposite = 1e-6;

/// Passes the numbers of a shape, in W, to visit(position, axis, rotation, size); null: it has none.
template <class AnyShape, class Visit>
bool withNumbers(AnyShape& shape, const Visit& visit) noexcept UNDERACT_REAL_TIME {
  if (auto* point = std::get_if<shape::Point>(&shape)) return visit(point->p_WC);
  if (auto* sphere = std::get_if<shape::Sphere>(&shape)) return visit(sphere->p_WC, sphere->radius_m);
  if (auto* line = std::get_if<shape::Line>(&shape)) return visit(line->p_WC, line->axis_W);
  if (auto* plane = std::get_if<shape::Plane>(&shape)) return visit(plane->p_WC, plane->normal_W);
  if (auto* circle = std::get_if<shape::Circle>(&shape)) return visit(circle->p_WC, circle->axis_W, circle->radius_m);
  if (auto* cylinder = std::get_if<shape::Cylinder>(&shape))
    return visit(cylinder->p_WC, cylinder->axis_W, cylinder->radius_m);
  if (auto* box = std::get_if<shape::Box>(&shape)) return visit(box->p_WC, box->R_WB, box->half_m);
  return false;
}

struct Take {
  Placing& into;
  bool operator()(const Vec3& p_W) const noexcept UNDERACT_REAL_TIME {
    into.p_W = p_W;
    return true;
  }
  bool operator()(const Vec3& p_W, double radius_m) const noexcept UNDERACT_REAL_TIME {
    into.size_m.setConstant(radius_m);
    return (*this)(p_W);
  }
  bool operator()(const Vec3& p_W, const Vec3& axis_W) const noexcept UNDERACT_REAL_TIME {
    into.axis_W = axis_W;
    return (*this)(p_W);
  }
  bool operator()(const Vec3& p_W, const Vec3& axis_W, double radius_m) const noexcept UNDERACT_REAL_TIME {
    into.axis_W = axis_W;
    return (*this)(p_W, radius_m);
  }
  bool operator()(const Vec3& p_W, const Mat3& R_W, const Vec3& size_m) const noexcept UNDERACT_REAL_TIME {
    into.R_W = R_W;
    into.size_m = size_m;
    return (*this)(p_W);
  }
};

struct Give {
  const Placing& from;
  bool operator()(Vec3& p_W) const noexcept UNDERACT_REAL_TIME {
    p_W = from.p_W;
    return true;
  }
  bool operator()(Vec3& p_W, double& radius_m) const noexcept UNDERACT_REAL_TIME {
    radius_m = from.size_m.x();
    return (*this)(p_W);
  }
  bool operator()(Vec3& p_W, Vec3& axis_W) const noexcept UNDERACT_REAL_TIME {
    axis_W = from.axis_W;
    return (*this)(p_W);
  }
  bool operator()(Vec3& p_W, Vec3& axis_W, double& radius_m) const noexcept UNDERACT_REAL_TIME {
    axis_W = from.axis_W;
    return (*this)(p_W, radius_m);
  }
  bool operator()(Vec3& p_W, Mat3& R_W, Vec3& size_m) const noexcept UNDERACT_REAL_TIME {
    R_W = from.R_W;
    size_m = from.size_m;
    return (*this)(p_W);
  }
};

Vec3 directionBetween(const Vec3& from, const Vec3& to, double share) noexcept UNDERACT_REAL_TIME {
  if (from == to) return to;
  const Vec3 mean = (1.0 - share) * from + share * to;
  const double length = mean.norm();
  if (!(length > kOpposite)) return share < 0.5 ? from : to;
  return mean / length;
}

Mat3 rotationBetween(const Mat3& from, const Mat3& to, double share) noexcept UNDERACT_REAL_TIME {
  if (from == to) return to;
  const Eigen::Quaterniond first(from), last(to);
  const double sign = first.coeffs().dot(last.coeffs()) < 0.0 ? -1.0 : 1.0;
  const Eigen::Vector4d mean = (1.0 - share) * first.coeffs() + sign * share * last.coeffs();
  return Eigen::Quaterniond(Eigen::Vector4d(mean / mean.norm())).toRotationMatrix();
}

bool isRotation(const Mat3& R) {
  return R.allFinite() && (R * R.transpose() - Mat3::Identity()).cwiseAbs().maxCoeff() < 1e-6 && R.determinant() > 0.0;
}

}  // namespace

Placing placingOf(const Goal& goal) noexcept {
  Placing placing;
  const Take take{placing};
  if (const auto* held = std::get_if<NearestOnShape>(&goal); held != nullptr && !held->weighted) {
    if (withNumbers(held->shape, take)) placing.kind = 1 + static_cast<std::int64_t>(held->shape.index());
  } else if (const auto* influenced = std::get_if<InfluencedShape>(&goal)) {
    if (withNumbers(influenced->shape, take))
      placing.kind = kOfInfluenced + static_cast<std::int64_t>(influenced->shape.index());
  } else if (const auto* mesh = std::get_if<MeshPlace>(&goal)) {
    take(mesh->p_WM, mesh->R_WM, Vec3(Vec3::Constant(mesh->scale_m)));
    placing.kind = mesh->scale_m > 0.0 ? kOfMesh : kOfMesh + 1;  // nothing is carried into its mirror image
  }
  return placing;
}

void put(Goal& goal, const Placing& placing) noexcept {
  const Give give{placing};
  if (auto* held = std::get_if<NearestOnShape>(&goal)) {
    if (!held->weighted && placing.kind == 1 + static_cast<std::int64_t>(held->shape.index()))
      withNumbers(held->shape, give);
  } else if (auto* influenced = std::get_if<InfluencedShape>(&goal)) {
    if (placing.kind == kOfInfluenced + static_cast<std::int64_t>(influenced->shape.index()))
      withNumbers(influenced->shape, give);
  } else if (auto* mesh = std::get_if<MeshPlace>(&goal); mesh != nullptr && placing.kind >= kOfMesh) {
    mesh->p_WM = placing.p_W;
    mesh->R_WM = placing.R_W;
    mesh->scale_m = placing.size_m.x();
  }
}

Placing between(const Placing& from, const Placing& to, double share) noexcept {
  if (share >= 1.0) return to;
  Placing placing = to;
  placing.p_W = from.p_W + share * (to.p_W - from.p_W);
  placing.size_m = from.size_m + share * (to.size_m - from.size_m);
  placing.axis_W = directionBetween(from.axis_W, to.axis_W, share);
  placing.R_W = rotationBetween(from.R_W, to.R_W, share);
  return placing;
}

bool isSame(const Placing& a, const Placing& b) noexcept {
  return a.kind == b.kind && a.p_W == b.p_W && a.axis_W == b.axis_W && a.R_W == b.R_W && a.size_m == b.size_m;
}

bool isValid(const Placing& placing, const Placing& end) {
  const bool has_size = end.size_m == Vec3::Zero() || (placing.size_m.array() * end.size_m.array() > 0.0).all();
  return placing.kind == end.kind && placing.p_W.allFinite() && placing.size_m.allFinite() && has_size &&
         std::abs(placing.axis_W.norm() - 1.0) < 1e-6 && isRotation(placing.R_W);
}

}  // namespace underact::target
