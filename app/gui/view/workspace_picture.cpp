#include "app/gui/view/workspace_picture.h"

#include <vtkProperty.h>

#include <array>
#include <cmath>

#include "app/gui/view/arm_solids.h"
#include "core/base/units.h"

namespace underact::gui {
namespace {

constexpr double kTick_mm = 20.0, kTickLength_mm = 2.0, kLabelAway_mm = 7.0;
constexpr double kEndOn = 0.95;  // an axis that points at the eye shows no ticks

double signOf(double value) {
  return value < 0.0 ? -1.0 : 1.0;
}

}  // namespace

const Vec3& workspaceHalf_mm() {
  static const Vec3 kHalf_mm(80.0, 60.0, 35.0);
  return kHalf_mm;
}

WorkspacePicture::WorkspacePicture()
    : box_actor_(makeActor(box_.data(), PieceKind::Line)),
      triad_actor_(makeActor(triad_.data(), PieceKind::Mark)) {}  // B is inside the arm

void WorkspacePicture::setTheme(const Theme& theme) {
  theme_ = theme;
  build();
}

void WorkspacePicture::setArm(const arm::Model& model) {
  X_WB_mm_ = model.X_WB;
  X_WB_mm_.translation() *= kMillimetrePerMetre;
  has_box_ = arm::omniGeometry(model).has_value();
  size_ = standOf(model).size;
  build();
}

void WorkspacePicture::show(bool workspace, bool triads) {
  workspace_ = workspace;
  triads_ = triads;
  build();
}

void WorkspacePicture::setLineWidth(double scale) {
  box_actor_->GetProperty()->SetLineWidth(static_cast<float>(1.0 * scale));
  triad_actor_->GetProperty()->SetLineWidth(static_cast<float>(2.0 * scale));
}

void WorkspacePicture::update(const OrbitCamera& camera) {
  const Vec3 back_W = camera.back_W();
  const Vec3 sign(signOf(back_W.x()), back_W.y() < -0.1 ? -1.0 : 1.0, signOf(back_W.z()));
  const Vec3 end_on = (back_W.array().abs() > kEndOn).select(Vec3::Ones(), Vec3::Zero());
  // The upright edge at the left of the box' outline. End on, both near edges bound it, else the two at its sides.
  const Vec3 half_mm = workspaceHalf_mm(), right_W = camera.right_W();
  Vec3 upright_mm(sign.x() * half_mm.x(), 0.0, sign.z() * half_mm.z());
  if (end_on.x() > 0.0) {
    upright_mm.z() = -signOf(right_W.z()) * half_mm.z();
  } else if (end_on.z() > 0.0) {
    upright_mm.x() = -signOf(right_W.x()) * half_mm.x();
  } else if (right_W.x() * upright_mm.x() < right_W.z() * upright_mm.z()) {
    upright_mm.z() = -upright_mm.z();
  } else {
    upright_mm.x() = -upright_mm.x();
  }
  if (sign == sign_ && end_on == end_on_ && upright_mm == upright_mm_) return;
  sign_ = sign;
  end_on_ = end_on;
  upright_mm_ = upright_mm;
  build();
}

void WorkspacePicture::build() {
  box_.clear();
  triad_.clear();
  labels_.clear();
  if (workspace_ && has_box_) {
    const Vec3 half_mm = workspaceHalf_mm();
    addBoxEdges(box_, half_mm, Vec3::Zero(), Mat3::Identity(), theme_.quiet);
    const double below = -sign_.y() * half_mm.y();
    if (end_on_.x() == 0.0) {
      addTicks(0, {0.0, below, sign_.z() * half_mm.z()}, Vec3(0.0, -sign_.y(), sign_.z()).normalized());
    }
    if (end_on_.z() == 0.0) {
      addTicks(2, {sign_.x() * half_mm.x(), below, 0.0}, Vec3(sign_.x(), -sign_.y(), 0.0).normalized());
    }
    if (end_on_.y() == 0.0) addTicks(1, upright_mm_, upright_mm_.cwiseQuotient(half_mm).normalized());
  }
  if (triads_) {
    addTriad(Vec3::Zero(), Mat3::Identity(), QStringLiteral("W"), size_ * 22.0);
    addTriad(X_WB_mm_.translation(), X_WB_mm_.linear(), QStringLiteral("B"), size_ * 22.0);
  }
  box_.done();
  triad_.done();
}

void WorkspacePicture::addTicks(int axis, const Vec3& edge_mm, const Vec3& outward) {
  const double half_mm = workspaceHalf_mm()[axis];
  const int count = static_cast<int>(half_mm / kTick_mm);
  for (int tick = -count; tick <= count; ++tick) {
    const Vec3 p_mm = edge_mm + tick * kTick_mm * Vec3::Unit(axis);
    box_.segment(p_mm, p_mm + kTickLength_mm * outward, theme_.quiet);
    if (std::abs(tick) != (count >= 2 ? count - count % 2 : count) && tick != 0) continue;
    QString text = QString::number(tick * kTick_mm).replace(QLatin1Char('-'), QChar(0x2212));
    if (tick > 0) text += QStringLiteral(" mm");
    labels_.push_back({text, p_mm + kLabelAway_mm * outward, mixed(theme_.quiet, theme_.ink, 0.55), false});
  }
}

void WorkspacePicture::addTriad(const Vec3& p_mm, const Mat3& R, const QString& name, double length_mm) {
  const std::array<QColor, 3> colours{theme_.x_axis, theme_.y_axis, theme_.z_axis};
  const std::array<QString, 3> letters{QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z")};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Vec3 direction = R.col(static_cast<Eigen::Index>(axis));
    triad_.segment(p_mm, p_mm + length_mm * direction, colours[axis]);
    labels_.push_back({letters[axis], p_mm + (1.18 * length_mm) * direction, colours[axis], true});
  }
  const Vec3 corner = -0.41 * length_mm * (R.col(0) + R.col(1) + R.col(2)).normalized();  // away from the three
  labels_.push_back({name, p_mm + corner, mixed(theme_.quiet, theme_.ink, 0.7), true});
}

}  // namespace underact::gui
