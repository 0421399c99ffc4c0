#pragma once
#include <vtkActor.h>
#include <vtkPlane.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <vector>

#include "app/gui/kit/theme.h"
#include "app/gui/model/layers.h"
#include "app/gui/view/contact_patch.h"
#include "app/gui/view/drawn_mesh.h"
#include "app/gui/view/section_cap.h"
#include "core/scene/description.h"
#include "core/tick/report.h"

namespace underact::gui {

/// The meshes of a scene: slightly translucent bodies, so that a stylus inside is visible, with their sharp edges; on
/// demand the edges of all triangles, and a cut across an axis, which hides the side nearer to the eye and fills the
/// section of a closed mesh; and a patch on the surface at each contact. mm, in W. A mesh that moves only gets a new
/// placement.
class MeshPicture {
 public:
  MeshPicture();
  void setScene(const scene::Description& scene);
  void setTheme(const Theme& theme);
  void show(const Layers& layers);
  void present(const tick::TickReport& report);
  /// The cut as seen by the eye. Each frame: what has not moved is not cut again.
  void update(const Vec3& eye_mm);
  void setLineWidth(double device_pixels_per_pixel);

  const std::vector<Vec3>& extent_mm() const { return extent_mm_; }
  /// The cut's face, among the solids.
  vtkActor* face() const { return face_actor_; }
  /// After solids and lines, in this order. New with each scene that has other meshes.
  std::vector<vtkActor*> actors() const;
  std::size_t triangles() const;
  std::size_t patchCorners() const { return patch_.corners(); }
  /// Where the cut is, across each axis.
  const Vec3& section_mm() const { return section_mm_; }
  /// How often the meshes were cut since the picture was made.
  std::size_t cuts() const { return cuts_; }
  const SectionCap& cap() const { return cap_; }

 private:
  struct Shown {
    target::MeshPlace place;
    Eigen::Matrix4d X = Eigen::Matrix4d::Identity();  // from its frame and unit to W in mm
    std::size_t constraint = 0;                       // its index
    std::shared_ptr<const DrawnMesh> drawn;
    vtkSmartPointer<vtkActor> body, edges, wires;
    bool is_turned = false;  // the body is that of a mirror image
  };
  Shown makeShown(const std::shared_ptr<const mesh::Surface>& surface) const;
  void colour(const Shown& shown) const;
  void placeAll(const scene::Description& scene);
  void drawPatch();
  void drawCut();

  Theme theme_ = Theme::light();
  std::vector<Shown> meshes_;
  std::vector<Vec3> extent_mm_;
  ContactPatch patch_;
  vtkSmartPointer<vtkActor> patch_actor_;
  std::vector<std::pair<std::size_t, Vec3>> touched_;  // index of meshes_, target in m: that the patch shows
  bool show_wires_ = false, show_section_ = false, show_patch_ = true, section_follows_ = true;
  int section_axis_ = 2;
  Vec3 tip_mm_ = Vec3::Zero(), section_mm_ = Vec3::Zero();
  vtkSmartPointer<vtkPlane> section_;
  SectionCap cap_;
  vtkSmartPointer<vtkActor> face_actor_, outline_actor_;
  bool cut_is_old_ = true;  // the meshes or the plane have changed
  int cut_axis_ = 2;        // of the last one
  double cut_at_mm_ = 0.0;
  std::size_t cuts_ = 0;
};

}  // namespace underact::gui
