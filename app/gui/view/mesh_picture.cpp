#include "app/gui/view/mesh_picture.h"

#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>

#include "app/gui/view/pieces.h"
#include "app/gui/view/scene_view.h"
#include "core/base/units.h"

namespace underact::gui {
namespace {

constexpr double kBody = 0.62;  // opacity: solid, and yet the stylus inside is visible
constexpr double kFace = 0.35;  // of the constraint's colour in the section: flat, and distinct from the body
constexpr double kInner = 0.6;  // brightness of the side that only a hole or a cut shows

/// What scene::compile() makes of it.
target::MeshPlace placeOf(const scene::Mesh& mesh) {
  target::MeshPlace place;
  place.surface = mesh.surface;
  place.R_WM = Eigen::Quaterniond(Mat3(mesh.X_WM.topLeftCorner<3, 3>())).normalized().toRotationMatrix();
  place.p_WM = kMetrePerMillimetre * mesh.X_WM.topRightCorner<3, 1>();
  place.scale_m = kMetrePerMillimetre * mesh.scale_mm_per_unit;
  if (mesh.surface->origin_M != Vec3::Zero()) place.p_WM += place.scale_m * (place.R_WM * mesh.surface->origin_M);
  return place;
}

}  // namespace

MeshPicture::MeshPicture()
    : patch_actor_(makeActor(patch_.data(), PieceKind::Tint)),
      section_(vtkSmartPointer<vtkPlane>::New()),
      face_actor_(makeActor(cap_.face(), PieceKind::Solid)),
      outline_actor_(makeActor(cap_.outline(), PieceKind::Line)) {
  patch_actor_->GetProperty()->LightingOff();
  patch_actor_->GetProperty()->SetOpacity(0.7);
  face_actor_->GetProperty()->LightingOff();
  face_actor_->GetProperty()->BackfaceCullingOff();
}

void MeshPicture::setScene(const scene::Description& scene) {
  std::vector<Shown> before = std::move(meshes_);
  meshes_.clear();
  for (std::size_t index = 0; index < scene.constraints.size(); ++index) {
    const auto* const mesh = std::get_if<scene::Mesh>(&scene.constraints[index].shape);
    if (mesh == nullptr || mesh->surface == nullptr) continue;
    const auto same = std::find_if(before.begin(), before.end(),
                                   [&](const Shown& one) { return one.place.surface == mesh->surface; });
    if (same != before.end()) {
      meshes_.push_back(std::move(*same));
      before.erase(same);
    } else {
      meshes_.push_back(makeShown(mesh->surface));
    }
    meshes_.back().constraint = index;
  }
  placeAll(scene);
  cut_is_old_ = true;
  touched_.clear();
  drawPatch();
}

void MeshPicture::placeAll(const scene::Description& scene) {
  extent_mm_.clear();
  for (Shown& shown : meshes_) {
    const auto& mesh = std::get<scene::Mesh>(scene.constraints[shown.constraint].shape);
    shown.place = placeOf(mesh);
    if (const bool mirrors = shown.place.scale_m < 0.0; mirrors != shown.is_turned) {
      shown.is_turned = mirrors;
      vtkPolyDataMapper::SafeDownCast(shown.body->GetMapper())
          ->SetInputData(mirrors ? turnedOver(shown.drawn->body) : shown.drawn->body);
    }
    shown.X.block<3, 3>(0, 0) = mesh.scale_mm_per_unit * shown.place.R_WM;
    shown.X.block<3, 1>(0, 3) = mesh.X_WM.topRightCorner<3, 1>();
    if (mesh.surface->origin_M != Vec3::Zero())
      shown.X.block<3, 1>(0, 3) += mesh.scale_mm_per_unit * (shown.place.R_WM * mesh.surface->origin_M);
    for (vtkActor* actor : {shown.body.Get(), shown.edges.Get(), shown.wires.Get()}) place(*actor, shown.X);
    const Vec3 low = mesh.surface->low_M.cast<double>(), high = mesh.surface->high_M.cast<double>();
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 p_M((corner & 1) != 0 ? low.x() : high.x(), (corner & 2) != 0 ? low.y() : high.y(),
                     (corner & 4) != 0 ? low.z() : high.z());
      extent_mm_.push_back(kMillimetrePerMetre * target::toWorkspace(shown.place, p_M));
    }
  }
}

MeshPicture::Shown MeshPicture::makeShown(const std::shared_ptr<const mesh::Surface>& surface) const {
  Shown shown;
  shown.place.surface = surface;
  shown.drawn = drawnMesh(surface);
  shown.body = makeActor(shown.drawn->body, PieceKind::Body);
  shown.body->GetProperty()->SetOpacity(kBody);
  shown.edges = makeActor(shown.drawn->edges, PieceKind::Line);
  shown.wires = makeActor(shown.drawn->body, PieceKind::Line);
  shown.wires->GetProperty()->SetRepresentationToWireframe();
  shown.wires->GetProperty()->SetOpacity(0.5);
  shown.wires->SetVisibility(show_wires_);
  colour(shown);
  for (vtkActor* actor : {shown.body.Get(), shown.edges.Get(), shown.wires.Get()}) {
    if (show_section_) actor->GetMapper()->AddClippingPlane(section_);
  }
  return shown;
}

void MeshPicture::colour(const Shown& shown) const {
  for (vtkActor* actor : {shown.body.Get(), shown.edges.Get(), shown.wires.Get()}) setColour(*actor, theme_.constraint);
  const vtkSmartPointer<vtkProperty> inner = vtkSmartPointer<vtkProperty>::New();
  inner->DeepCopy(shown.body->GetProperty());
  inner->SetColor(kInner * theme_.constraint.redF(), kInner * theme_.constraint.greenF(),
                  kInner * theme_.constraint.blueF());
  shown.body->SetBackfaceProperty(inner);
}

void MeshPicture::setTheme(const Theme& theme) {
  theme_ = theme;
  for (const Shown& shown : meshes_) colour(shown);
  setColour(*patch_actor_, theme.target);
  setColour(*face_actor_, mixed(theme.background, theme.constraint, kFace));
  setColour(*outline_actor_, theme.constraint);
}

void MeshPicture::show(const Layers& layers) {
  show_wires_ = layers.wires;
  for (const Shown& shown : meshes_) {
    shown.wires->SetVisibility(show_wires_);
    for (vtkActor* actor : {shown.body.Get(), shown.edges.Get(), shown.wires.Get()}) {
      actor->GetMapper()->RemoveAllClippingPlanes();
      if (layers.section) actor->GetMapper()->AddClippingPlane(section_);
    }
  }
  show_section_ = layers.section;
  section_axis_ = std::clamp(layers.section_axis, 0, 2);
  section_follows_ = layers.section_follows;
  section_mm_ = section_follows_ ? tip_mm_ : layers.section_mm;
  show_patch_ = layers.target;
  drawPatch();
}

void MeshPicture::present(const tick::TickReport& report) {
  if (!report.p_WT.allFinite()) return;
  tip_mm_ = kMillimetrePerMetre * report.p_WT;
  if (section_follows_) section_mm_ = tip_mm_;
  std::vector<std::pair<std::size_t, Vec3>> touched;
  for (std::size_t index = 0; index < meshes_.size(); ++index) {
    if (meshes_[index].constraint >= report.held.size()) continue;
    const tick::ConstraintReport& held = report.held[meshes_[index].constraint];
    if (held.acts && held.status == target::Status::Unique && held.p_WP.allFinite())
      touched.emplace_back(index, held.p_WP);
  }
  if (touched == touched_) return;
  touched_ = std::move(touched);
  drawPatch();
}

void MeshPicture::drawPatch() {
  patch_.clear();
  if (show_patch_) {
    for (const auto& [index, p_WP] : touched_) patch_.add(meshes_[index].place, p_WP);
  }
  patch_.done();
  patch_actor_->SetVisibility(patch_.corners() > 0);
}

void MeshPicture::update(const Vec3& eye_mm) {
  face_actor_->SetVisibility(show_section_);
  outline_actor_->SetVisibility(show_section_);
  if (!show_section_) return;
  const Vec3 axis = Vec3::Unit(section_axis_);
  const double away = axis.dot(eye_mm - section_mm_) > 0.0 ? -1.0 : 1.0;
  section_->SetOrigin(section_mm_.x(), section_mm_.y(), section_mm_.z());
  section_->SetNormal(away * axis.x(), away * axis.y(), away * axis.z());
  if (cut_is_old_ || cut_axis_ != section_axis_ || cut_at_mm_ != section_mm_[section_axis_]) drawCut();
}

void MeshPicture::drawCut() {
  cut_is_old_ = false;
  cut_axis_ = section_axis_;
  cut_at_mm_ = section_mm_[section_axis_];
  ++cuts_;
  cap_.clear();
  for (const Shown& shown : meshes_) {
    const mesh::Surface& surface = *shown.place.surface;
    const mesh::Triangles& triangles = shown.drawn->is_coarser ? shown.drawn->coarser : surface.triangles;
    cap_.add(triangles, shown.X, cut_axis_, cut_at_mm_, surface.is_closed);
  }
  cap_.done();
}

void MeshPicture::setLineWidth(double scale) {
  for (const Shown& shown : meshes_) {
    shown.edges->GetProperty()->SetLineWidth(static_cast<float>(1.5 * scale));
    shown.wires->GetProperty()->SetLineWidth(static_cast<float>(1.0 * scale));
  }
  outline_actor_->GetProperty()->SetLineWidth(static_cast<float>(2.0 * scale));
}

std::vector<vtkActor*> MeshPicture::actors() const {
  std::vector<vtkActor*> all;
  for (const Shown& shown : meshes_) all.push_back(shown.body);
  for (const Shown& shown : meshes_) {
    all.push_back(shown.edges);
    all.push_back(shown.wires);
  }
  all.push_back(outline_actor_);
  all.push_back(patch_actor_);
  return all;
}

std::size_t MeshPicture::triangles() const {
  std::size_t count = 0;
  for (const Shown& shown : meshes_) count += shown.drawn->triangles;
  return count;
}

}  // namespace underact::gui
