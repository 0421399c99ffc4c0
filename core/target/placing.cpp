#include "core/target/placing.h"

#include <cmath>

namespace underact::target {
namespace {

// Kinds: one for each shape, and for each way in which it is held.
constexpr std::int64_t kOfInfluenced = 32, kOfMesh = 64;
// Opposite directions have no shorter arc between them: they change over in the middle.
constexpr double kOpposite = 1e-6;

/// Passes each number of a shape that moves with it, and its place in a placing; false: the shape is not carried.
template <class AnyShape, class OnePlacing, class Pass>
bool withNumbers(AnyShape& shape, OnePlacing& placing, const Pass& pass) noexcept UNDERACT_REAL_TIME {
  bool is_carried = false;
  withChosen(shape, [&](auto& one) noexcept UNDERACT_REAL_TIME {
    if constexpr (shape::kIsPlain<decltype(one)>) {
      is_carried = true;
      pass(one.p_WC, placing.p_W);
      if constexpr (requires { one.axis_W; }) pass(one.axis_W, placing.axis_W);
      if constexpr (requires { one.normal_W; }) pass(one.normal_W, placing.axis_W);
      if constexpr (requires { one.R_WB; }) pass(one.R_WB, placing.R_W);
      if constexpr (requires { one.half_m; }) pass(one.half_m, placing.size_m);
      if constexpr (requires { one.semi_m; }) pass(one.semi_m, placing.size_m);
      if constexpr (requires { one.radius_m; }) pass(one.radius_m, placing.size_m);
    }
  });
  return is_carried;
}

struct Take {
  template <class Number>
  void operator()(const Number& number, Number& place) const noexcept UNDERACT_REAL_TIME {
    place = number;
  }
  void operator()(double radius_m, Vec3& size_m) const noexcept UNDERACT_REAL_TIME { size_m.setConstant(radius_m); }
};

struct Give {
  template <class Number>
  void operator()(Number& number, const Number& place) const noexcept UNDERACT_REAL_TIME {
    number = place;
  }
  void operator()(double& radius_m, const Vec3& size_m) const noexcept UNDERACT_REAL_TIME { radius_m = size_m.x(); }
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
  if (const auto* held = std::get_if<NearestOnShape>(&goal); held != nullptr && !held->weighted) {
    if (withNumbers(held->shape, placing, Take{})) placing.kind = 1 + static_cast<std::int64_t>(held->shape.index());
  } else if (const auto* influenced = std::get_if<InfluencedShape>(&goal)) {
    if (withNumbers(influenced->shape, placing, Take{}))
      placing.kind = kOfInfluenced + static_cast<std::int64_t>(influenced->shape.index());
  } else if (const auto* mesh = std::get_if<MeshPlace>(&goal)) {
    placing.p_W = mesh->p_WM;
    placing.R_W = mesh->R_WM;
    placing.size_m.setConstant(mesh->scale_m);
    placing.kind = mesh->scale_m > 0.0 ? kOfMesh : kOfMesh + 1;  // nothing is carried into its mirror image
  }
  return placing;
}

void put(Goal& goal, const Placing& placing) noexcept {
  if (auto* held = std::get_if<NearestOnShape>(&goal)) {
    if (!held->weighted && placing.kind == 1 + static_cast<std::int64_t>(held->shape.index()))
      withNumbers(held->shape, placing, Give{});
  } else if (auto* influenced = std::get_if<InfluencedShape>(&goal)) {
    if (placing.kind == kOfInfluenced + static_cast<std::int64_t>(influenced->shape.index()))
      withNumbers(influenced->shape, placing, Give{});
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
