#include "app/gui/view/shadow_picture.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/units.h"

namespace underact::gui {
namespace {

// Of an arm of the Omni's size, m.
constexpr double kTop_m = 0.27;         // radius of the desk's top
constexpr double kSharpest_m = 0.004;   // the soft edge of a shadow on the desk itself
constexpr double kSharpestSteps = 2.0;  // and at least, of the grid: a sharper one would have saw teeth
constexpr double kWidening = 0.30;      // and how much it widens with height
constexpr double kFading_m = 0.06;      // at this height it is half as dark: from far above it would look like a stain
constexpr float kMinShade = 0.004F;
constexpr double kDarkest = 0.55, kDarkestOnDark = 0.75;

struct FlatRod {
  double ax, az, bx, bz, from_radius, to_radius, from_height, to_height;
};

double smooth(double share) {
  const double t = std::clamp(share, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

double edgeOf(double height_m, double sharpest_m) {
  return sharpest_m + kWidening * height_m;
}

}  // namespace

ShadowField shadowOf(std::span<const ShadowRod> rods, const Pose& X_WD, double size) {
  constexpr int n = ShadowField::kPoints;
  ShadowField field;
  if (rods.empty()) return field;
  const Pose X_DW = X_WD.inverse();
  std::vector<FlatRod> flat;
  double min_x = kInfinity, max_x = -kInfinity, min_z = kInfinity, max_z = -kInfinity;
  for (const ShadowRod& rod : rods) {
    const Vec3 a = X_DW * rod.from_W, b = X_DW * rod.to_W;
    const double ha = std::max(0.0, a.y() - rod.from_radius_m), hb = std::max(0.0, b.y() - rod.to_radius_m);
    flat.push_back({a.x(), a.z(), b.x(), b.z(), rod.from_radius_m, rod.to_radius_m, ha, hb});
    const double around = std::max(rod.from_radius_m + edgeOf(ha, 0.0), rod.to_radius_m + edgeOf(hb, 0.0));
    min_x = std::min({min_x, a.x() - around, b.x() - around});
    max_x = std::max({max_x, a.x() + around, b.x() + around});
    min_z = std::min({min_z, a.z() - around, b.z() - around});
    max_z = std::max({max_z, a.z() + around, b.z() + around});
  }
  const double sharpest =
      std::max(kSharpest_m * size, kSharpestSteps * std::max(max_x - min_x, max_z - min_z) / (n - 1));
  min_x -= sharpest;
  min_z -= sharpest;
  max_x += sharpest;
  max_z += sharpest;
  const double step_x = (max_x - min_x) / (n - 1), step_z = (max_z - min_z) / (n - 1);
  field.p_WCorner = X_WD * Vec3(min_x, 0.0, min_z);
  field.x_W = X_WD.linear().col(0) * (max_x - min_x);
  field.z_W = X_WD.linear().col(2) * (max_z - min_z);
  field.shade.assign(static_cast<std::size_t>(n * n), 0.0F);
  for (const FlatRod& rod : flat) {
    const double wx = rod.bx - rod.ax, wz = rod.bz - rod.az, length2 = wx * wx + wz * wz;
    const double around =
        std::max(rod.from_radius + edgeOf(rod.from_height, sharpest), rod.to_radius + edgeOf(rod.to_height, sharpest));
    const auto range = [&](double p, double q, double min, double step) {
      const int from = static_cast<int>(std::floor((std::min(p, q) - around - min) / step));
      const int to = static_cast<int>(std::ceil((std::max(p, q) + around - min) / step));
      return std::array<int, 2>{std::max(from, 0), std::min(to, n - 1)};
    };
    const auto [from_x, to_x] = range(rod.ax, rod.bx, min_x, step_x);
    const auto [from_z, to_z] = range(rod.az, rod.bz, min_z, step_z);
    for (int row = from_z; row <= to_z; ++row) {
      for (int column = from_x; column <= to_x; ++column) {
        const double px = min_x + column * step_x - rod.ax, pz = min_z + row * step_z - rod.az;
        const double share = length2 > 0.0 ? std::clamp((px * wx + pz * wz) / length2, 0.0, 1.0) : 0.0;
        const double away = std::sqrt(std::pow(px - share * wx, 2) + std::pow(pz - share * wz, 2));
        const double radius = rod.from_radius + share * (rod.to_radius - rod.from_radius);
        const double height = rod.from_height + share * (rod.to_height - rod.from_height);
        const double edge = edgeOf(height, sharpest);
        const double cover = std::min(1.0, 1.6 * radius / edge) / (1.0 + height / (kFading_m * size));
        const double dark = cover * smooth((radius + edge - away) / (2.0 * std::min(edge, radius + edge)));
        float& shade = field.shade[static_cast<std::size_t>(row * n + column)];
        shade += (1.0F - shade) * static_cast<float>(dark);
      }
    }
  }
  return field;
}

ShadowPicture::ShadowPicture()
    : data_(vtkSmartPointer<vtkPolyData>::New()),
      points_(vtkSmartPointer<vtkPoints>::New()),
      cells_(vtkSmartPointer<vtkCellArray>::New()),
      colours_(vtkSmartPointer<vtkUnsignedCharArray>::New()) {
  constexpr int n = ShadowField::kPoints;
  points_->SetNumberOfPoints(n * n);
  colours_->SetNumberOfComponents(4);
  colours_->SetNumberOfTuples(n * n);
  colours_->SetName("colour");
  colours_->Fill(0.0);
  for (vtkIdType at = 0; at < n * n; ++at) points_->SetPoint(at, 0.0, 0.0, 0.0);
  data_->SetPoints(points_);
  data_->SetPolys(cells_);
  data_->GetPointData()->SetScalars(colours_);
  actor_ = makeActor(data_, PieceKind::Line);  // unlit, and without depth
  top_actor_ = makeActor(top_.data(), PieceKind::Line);
  for (vtkActor* actor : actors()) actor->SetVisibility(false);
}

void ShadowPicture::setTheme(const Theme& theme) {
  theme_ = theme;
  colour();
  buildTop();
}

void ShadowPicture::setLineWidth(double scale) {
  top_actor_->GetProperty()->SetLineWidth(static_cast<float>(1.5 * scale));
}

void ShadowPicture::buildTop() {
  constexpr int kParts = 96;
  const QColor top = paletteOf(theme_).color(QPalette::Window), rim = mixed(theme_.background, theme_.quiet, 0.75);
  top_.clear();
  std::vector<vtkIdType> corners;
  std::vector<Vec3> round_mm;
  for (int part = 0; part < kParts; ++part) {
    const double angle_rad = 2.0 * kPi * part / kParts;
    const Vec3 p_D = stand_.p_DTop + kTop_m * stand_.size * Vec3(std::sin(angle_rad), 0.0, std::cos(angle_rad));
    round_mm.emplace_back(kMillimetrePerMetre * (X_WD_ * p_D));
    corners.push_back(top_.corner(round_mm.back(), top));
  }
  top_.face(corners);
  top_.chain(round_mm, rim, true);
  top_.done();
}

void ShadowPicture::present(std::span<const ShadowRod> rods, const ArmStand& stand) {
  constexpr int n = ShadowField::kPoints;
  const bool is_moved = stand.R_WD != stand_.R_WD || stand.p_WG != stand_.p_WG || stand.size != stand_.size;
  stand_ = stand;
  X_WD_.linear() = stand.R_WD;
  X_WD_.translation() = stand.p_WG;
  if (is_moved) buildTop();
  field_ = shadowOf(rods, X_WD_, stand.size);
  if (field_.shade.empty()) return;
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < n; ++column) {
      const Vec3 p_mm = kMillimetrePerMetre * (field_.p_WCorner + static_cast<double>(column) / (n - 1) * field_.x_W +
                                               static_cast<double>(row) / (n - 1) * field_.z_W);
      points_->SetPoint(row * n + column, p_mm.data());
    }
  }
  cells_->Reset();  // only where there is some shade: what is blended costs time
  for (int row = 0; row + 1 < n; ++row) {
    for (int column = 0; column + 1 < n; ++column) {
      const vtkIdType corner = row * n + column;
      const std::array<vtkIdType, 4> quad{corner, corner + 1, corner + n + 1, corner + n};
      const bool shaded = std::any_of(quad.begin(), quad.end(), [this](vtkIdType at) {
        return field_.shade[static_cast<std::size_t>(at)] > kMinShade;
      });
      if (shaded) cells_->InsertNextCell(4, quad.data());
    }
  }
  cells_->Modified();
  points_->Modified();
  colour();
}

void ShadowPicture::colour() {
  const double darkest = theme_.dark ? kDarkestOnDark : kDarkest;
  const QColor ink = mixed(theme_.background, Qt::black, theme_.dark ? 0.85 : 0.75);
  for (std::size_t at = 0; at < field_.shade.size(); ++at) {
    const std::array<unsigned char, 4> rgba{
        static_cast<unsigned char>(ink.red()), static_cast<unsigned char>(ink.green()),
        static_cast<unsigned char>(ink.blue()),
        static_cast<unsigned char>(std::lround(255.0 * darkest * static_cast<double>(field_.shade[at])))};
    colours_->SetTypedTuple(static_cast<vtkIdType>(at), rgba.data());
  }
  colours_->Modified();
  data_->Modified();
}

void ShadowPicture::update(const OrbitCamera& camera) {
  const Vec3 from_desk_mm = camera.eye_mm() - kMillimetrePerMetre * X_WD_.translation();
  const bool is_seen = shown_ && !field_.shade.empty() && from_desk_mm.dot(X_WD_.linear().col(1)) > 0.0;
  for (vtkActor* actor : actors()) actor->SetVisibility(is_seen);
}

}  // namespace underact::gui
