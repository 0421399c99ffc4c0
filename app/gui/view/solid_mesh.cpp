#include "app/gui/view/solid_mesh.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "app/gui/view/arm_mesh.h"
#include "core/base/units.h"

namespace underact::gui {
namespace {

constexpr int kMinSectors = 12, kMaxSectors = 48, kRodSectors = 12;
constexpr double kSamePlace = 1e-6;      // of two poses of a link
constexpr double kBentParts = 24.0;      // of a half circle
constexpr double kFlatness_m = 0.00007;  // at most, between a circle and its chords: less than a pixel

/// Corners of a circle.
int sectorsOf(double radius_m) {
  const double wanted = kPi / std::sqrt(2.0 * kFlatness_m / std::max(radius_m, kFlatness_m));
  return std::clamp(4 * static_cast<int>(std::ceil(0.25 * wanted)), kMinSectors, kMaxSectors);
}

class LinkMesh {
 public:
  LinkMesh() {
    normals_->SetNumberOfComponents(3);
    normals_->SetName("normal");
    colours_->SetNumberOfComponents(3);
    colours_->SetName("colour");
  }

  void add(const TurnedForm& form) {
    double widest_m = 0.0;
    for (const Ring& ring : form.profile) widest_m = std::max(widest_m, ring.radius);
    const int sectors = sectorsOf(widest_m);
    const std::vector<std::array<Eigen::Vector2d, 2>> normals = stripNormals(form.profile);
    for (std::size_t strip = 0; strip < normals.size(); ++strip) {
      const Ring &lower = form.profile[strip], &upper = form.profile[strip + 1];
      if (lower.radius == upper.radius && lower.z == upper.z) continue;
      const vtkIdType first = points_->GetNumberOfPoints();
      for (int sector = 0; sector <= sectors; ++sector) {
        const double angle_rad = 2.0 * kPi * sector / sectors, c = std::cos(angle_rad), s = std::sin(angle_rad);
        point(form.X_WS, {lower.radius * c, lower.radius * s, lower.z},
              {normals[strip][0].x() * c, normals[strip][0].x() * s, normals[strip][0].y()});
        point(form.X_WS, {upper.radius * c, upper.radius * s, upper.z},
              {normals[strip][1].x() * c, normals[strip][1].x() * s, normals[strip][1].y()});
      }
      for (int sector = 0; sector < sectors; ++sector) {
        const vtkIdType corner = first + 2 * sector;
        quad({corner, corner + 2, corner + 3, corner + 1});
      }
    }
  }

  void add(const BentForm& form) {
    const int parts = std::max(4, static_cast<int>(form.turn_rad / kPi * kBentParts));
    const vtkIdType first = points_->GetNumberOfPoints();
    const Vec3 across_W = form.from_W.cross(form.to_W);
    for (int part = 0; part <= parts; ++part) {
      const double angle_rad = form.turn_rad * part / parts;
      const Vec3 out_W = std::cos(angle_rad) * form.from_W + std::sin(angle_rad) * form.to_W;
      for (int sector = 0; sector <= kRodSectors; ++sector) {
        const double around_rad = 2.0 * kPi * sector / kRodSectors;
        const Vec3 normal_W = std::cos(around_rad) * out_W + std::sin(around_rad) * across_W;
        point(Pose::Identity(), form.p_WC + form.radius_m * out_W + form.rod_m * normal_W, normal_W);
      }
    }
    for (int part = 0; part < parts; ++part) {
      for (int sector = 0; sector < kRodSectors; ++sector) {
        const vtkIdType corner = first + part * (kRodSectors + 1) + sector, next = corner + kRodSectors + 1;
        quad({corner, corner + 1, next + 1, next});
      }
    }
  }

  void add(const BoxForm& form) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const double side : {-1.0, 1.0}) {
        const Vec3 normal = side * Vec3::Unit(axis), u = Vec3::Unit((axis + 1) % 3), v = normal.cross(u);
        const vtkIdType first = points_->GetNumberOfPoints();
        for (const auto& [a, b] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}})
          point(form.X_WS, form.half_m.cwiseProduct(normal + a * u + b * v), normal);
        quad({first, first + 1, first + 2, first + 3});
      }
    }
  }

  void add(const MeshForm& form) {
    const vtkIdType first = points_->GetNumberOfPoints();
    vtkPolyData& body = *form.mesh->body;
    vtkDataArray& normals = *body.GetPointData()->GetNormals();
    for (vtkIdType corner = 0; corner < body.GetNumberOfPoints(); ++corner) {
      const Vec3 p = form.mesh->origin + Eigen::Map<const Vec3>(body.GetPoint(corner));
      const Vec3 normal = Eigen::Map<const Vec3>(normals.GetTuple3(corner)).cwiseQuotient(form.m_per_unit);
      point(form.X_WS, p.cwiseProduct(form.m_per_unit), normal.stableNormalized());
    }
    const bool is_mirrored = form.m_per_unit.prod() < 0.0;  // its corners go round the other way then
    vtkCellArray& triangles = *body.GetPolys();
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    for (triangles.InitTraversal(); triangles.GetNextCell(count, corners) != 0;) {
      std::array<vtkIdType, 3> three{first + corners[0], first + corners[1], first + corners[2]};
      if (is_mirrored) std::swap(three[1], three[2]);
      cells_->InsertNextCell(3, three.data());
    }
  }

  void setColour(const QColor& colour) {
    colour_ = {static_cast<unsigned char>(colour.red()), static_cast<unsigned char>(colour.green()),
               static_cast<unsigned char>(colour.blue())};
  }

  void setLink(const Pose& X_WLink) { X_WLink_ = X_WLink; }

  vtkSmartPointer<vtkPolyData> done() {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points_);
    data->SetPolys(cells_);
    data->GetPointData()->SetNormals(normals_);
    data->GetPointData()->SetScalars(colours_);
    return data;
  }

 private:
  void point(const Pose& X_WS, const Vec3& p_S, const Vec3& normal_S) {
    const Vec3 p_mm = kMillimetrePerMetre * (X_WLink_ * Vec3(X_WS * p_S));
    const Vec3 normal_W = X_WLink_.linear() * Vec3(X_WS.linear() * normal_S);
    points_->InsertNextPoint(p_mm.data());
    normals_->InsertNextTuple(normal_W.data());
    colours_->InsertNextTypedTuple(colour_.data());
  }
  void quad(const std::array<vtkIdType, 4>& corners) { cells_->InsertNextCell(4, corners.data()); }

  vtkNew<vtkPoints> points_;
  vtkNew<vtkFloatArray> normals_;
  vtkNew<vtkUnsignedCharArray> colours_;
  vtkNew<vtkCellArray> cells_;
  std::array<unsigned char, 3> colour_{};
  Pose X_WLink_ = Pose::Identity();
};

struct OutlinePen {
  Lines& lines;
  const Pose& X_WLink;
  const Vec3& eye_mm;
  const EdgeShade& shade;
  const QColor& colour;
};

/// Of a ring, the angle to either side of the eye's within which its surface faces the eye.
double facingHalf_rad(double away, double up, const Ring& ring, const Eigen::Vector2d& normal) {
  const double amplitude = normal.x() * away, limit = normal.x() * ring.radius - normal.y() * (up - ring.z);
  if (limit <= -std::abs(amplitude)) return kPi;
  if (limit >= std::abs(amplitude)) return 0.0;
  return std::acos(std::clamp(limit / amplitude, -1.0, 1.0));
}

void outlineOf(const OutlinePen& pen, const TurnedForm& form) {
  const Pose X_WS = pen.X_WLink * form.X_WS;
  const Vec3 eye_S = X_WS.inverse() * Vec3(kMetrePerMillimetre * pen.eye_mm);
  const double away = std::hypot(eye_S.x(), eye_S.y()), facing_rad = std::atan2(eye_S.y(), eye_S.x());
  const std::vector<std::array<Eigen::Vector2d, 2>> normals = stripNormals(form.profile);
  struct Station {
    Ring ring;
    Eigen::Vector2d normal;
    double half_rad;
  };
  const auto at = [&](const Station& station, double share, const Station& next, double half_rad, double side) {
    const double radius = station.ring.radius + share * (next.ring.radius - station.ring.radius);
    const double z = station.ring.z + share * (next.ring.z - station.ring.z);
    const double angle_rad = facing_rad + side * half_rad;
    return Vec3(kMillimetrePerMetre * (X_WS * Vec3(radius * std::cos(angle_rad), radius * std::sin(angle_rad), z)));
  };
  const auto shadeOf = [&](const Station& station, double half_rad, double side) {
    const double angle_rad = facing_rad + side * half_rad;
    const Vec3 normal_S(station.normal.x() * std::cos(angle_rad), station.normal.x() * std::sin(angle_rad),
                        station.normal.y());
    return pen.shade.of(pen.colour, X_WS.linear() * normal_S);
  };
  const auto join = [&](const Station& a, const Station& b) {
    const double turn_rad = b.half_rad - a.half_rad;
    if ((a.half_rad == 0.0 || a.half_rad == kPi) && a.half_rad == b.half_rad) return;  // all of it, or nothing, is seen
    const auto towardsEye = [&](const Station& station, double angle_rad) {  // above 0: it faces the eye there
      return station.normal.x() * (away * std::cos(angle_rad) - station.ring.radius) +
             station.normal.y() * (eye_S.z() - station.ring.z);
    };
    const auto shareAt = [&](double angle_rad) {  // between the two, where the surface turns away from the eye
      const double of_a = towardsEye(a, angle_rad), of_b = towardsEye(b, angle_rad);
      return of_a == of_b ? 0.5 : std::clamp(of_a / (of_a - of_b), 0.0, 1.0);
    };
    if (turn_rad == 0.0 && a.ring.z == b.ring.z && a.ring.radius == b.ring.radius) return;
    const int parts = std::max(1, static_cast<int>(std::abs(turn_rad) / 0.12));
    for (const double side : {-1.0, 1.0}) {
      for (int part = 0; part < parts; ++part) {
        const double from = static_cast<double>(part) / parts, to = (part + 1.0) / parts;
        const double from_rad = a.half_rad + from * turn_rad, to_rad = a.half_rad + to * turn_rad;
        pen.lines.segment(at(a, shareAt(from_rad), b, from_rad, side), at(a, shareAt(to_rad), b, to_rad, side),
                          shadeOf(a, 0.5 * (from_rad + to_rad), side));
      }
    }
  };
  std::optional<Station> last;
  for (std::size_t strip = 0; strip < normals.size(); ++strip) {
    for (std::size_t end = 0; end < 2; ++end) {
      Station station{form.profile[strip + end], normals[strip][end], 0.0};
      station.half_rad = facingHalf_rad(away, eye_S.z(), station.ring, station.normal);
      if (last) join(*last, station);
      last = station;
    }
  }
}

void outlineOf(const OutlinePen& pen, const BentForm& form) {
  constexpr int kParts = 30;
  std::array<std::optional<Vec3>, 2> last;
  for (int part = 0; part <= kParts; ++part) {
    const double angle_rad = form.turn_rad * part / kParts;
    const Vec3 out = std::cos(angle_rad) * form.from_W + std::sin(angle_rad) * form.to_W;
    const Vec3 along = pen.X_WLink.linear() * Vec3(std::cos(angle_rad) * form.to_W - std::sin(angle_rad) * form.from_W);
    const Vec3 p_mm = kMillimetrePerMetre * (pen.X_WLink * Vec3(form.p_WC + form.radius_m * out));
    const Vec3 side = along.cross(pen.eye_mm - p_mm);
    if (side.norm() < 1e-9) {
      last = {};
      continue;
    }
    for (std::size_t index = 0; index < 2; ++index) {
      const Vec3 normal = (index == 0 ? 1.0 : -1.0) * side.normalized();
      const Vec3 q_mm = p_mm + kMillimetrePerMetre * form.rod_m * normal;
      if (last[index]) pen.lines.segment(*last[index], q_mm, pen.shade.of(pen.colour, normal));
      last[index] = q_mm;
    }
  }
}

void outlineOf(const OutlinePen& pen, const BoxForm& form) {
  const Pose X_WS = pen.X_WLink * form.X_WS;
  const Vec3 eye_S = X_WS.inverse() * Vec3(kMetrePerMillimetre * pen.eye_mm);
  for (int axis = 0; axis < 3; ++axis) {  // edges along it
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const double a : {-1.0, 1.0}) {
      for (const double b : {-1.0, 1.0}) {
        const bool seen_a = a * eye_S[u] > form.half_m[u], seen_b = b * eye_S[v] > form.half_m[v];
        if (!seen_a && !seen_b) continue;
        Vec3 from;
        from[axis] = -form.half_m[axis];
        from[u] = a * form.half_m[u];
        from[v] = b * form.half_m[v];
        Vec3 to = from;
        to[axis] = form.half_m[axis];
        const Vec3 normal = seen_a ? Vec3(a * Vec3::Unit(u)) : Vec3(b * Vec3::Unit(v));
        const Vec3 from_mm = kMillimetrePerMetre * (X_WS * from), to_mm = kMillimetrePerMetre * (X_WS * to);
        pen.lines.segment(from_mm, to_mm, pen.shade.of(pen.colour, X_WS.linear() * normal));
      }
    }
  }
}

/// A mesh has none: the edges that turn away from the eye are others in each picture, of as many as it has.
void outlineOf(const OutlinePen&, const MeshForm&) {}

}  // namespace

vtkSmartPointer<vtkPolyData> meshOfLink(std::span<const ArmSolid> solids, std::size_t link, const Finishes& finishes) {
  LinkMesh mesh;
  for (const ArmSolid& solid : solids) {
    if (solid.link != link) continue;
    mesh.setColour(finishes[static_cast<std::size_t>(solid.finish)]);
    std::visit([&](const auto& form) { mesh.add(form); }, solid.form);
  }
  return mesh.done();
}

vtkSmartPointer<vtkPolyData> meshOfArms(std::span<const ArmSolid> solids, std::span<const std::vector<Pose>> X_WLinks) {
  LinkMesh mesh;
  for (std::size_t index = 0; index < X_WLinks.size(); ++index) {
    const auto isThere = [&](std::size_t link) {  // twice in one place, a translucent surface is speckled
      return std::any_of(
          X_WLinks.begin(), X_WLinks.begin() + static_cast<std::ptrdiff_t>(index),
          [&](const std::vector<Pose>& before) { return before[link].isApprox(X_WLinks[index][link], kSamePlace); });
    };
    for (const ArmSolid& solid : solids) {
      if (isThere(solid.link)) continue;
      mesh.setLink(X_WLinks[index][solid.link]);
      std::visit([&](const auto& form) { mesh.add(form); }, solid.form);
    }
  }
  return mesh.done();
}

QColor EdgeShade::of(const QColor& colour, const Vec3& normal_W) const {
  double share = ambient;
  for (std::size_t light = 0; light < lights_W.size(); ++light)
    share += diffuse * strengths[light] * std::max(0.0, normal_W.dot(lights_W[light]));
  const auto lit = [share](float part) { return std::min(1.0F, static_cast<float>(share) * part); };
  return QColor::fromRgbF(lit(colour.redF()), lit(colour.greenF()), lit(colour.blueF()));
}

void addOutline(Lines& lines, const ArmSolid& solid, const Pose& X_WLink, const Vec3& eye_mm, const EdgeShade& shade,
                const QColor& colour) {
  const OutlinePen pen{lines, X_WLink, eye_mm, shade, colour};
  std::visit([&](const auto& form) { outlineOf(pen, form); }, solid.form);
}

}  // namespace underact::gui
