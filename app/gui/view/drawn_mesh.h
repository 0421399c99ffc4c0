#pragma once
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cstddef>
#include <memory>

#include "core/base/watch.h"
#include "core/mesh/surface.h"
#include "core/scene/description.h"

namespace underact::gui {

/// More triangles than these are drawn coarser; what is felt has all of them.
inline constexpr std::size_t kMostDrawn = 100'000;

/// A mesh as it is drawn, in its own frame and unit.
struct DrawnMesh {
  vtkSmartPointer<vtkPolyData> body;   // triangles with normals: smooth, but broken where the surface is
  vtkSmartPointer<vtkPolyData> edges;  // the sharp ones, and the borders
  mesh::Triangles coarser;             // its triangles, where it is coarser; as closed as the surface is
  std::size_t triangles = 0;
  bool is_coarser = false;
};

/// Made once for each surface, and kept as long as that is there. Takes a second for millions of triangles. Any thread.
/// null: it was cancelled. most: triangles, of what is not made coarser; where it is made already, as it was then.
std::shared_ptr<const DrawnMesh> drawnMesh(const std::shared_ptr<const mesh::Surface>& surface, const Watch& watch = {},
                                           std::size_t most = kMostDrawn);

/// A body whose faces' corners go round the other way; for one that a placement mirrors, so that its outside is its
/// front. Normals stay: those are mirrored right. Some milliseconds.
vtkSmartPointer<vtkPolyData> turnedOver(vtkPolyData* body);

/// Of all meshes of a scene that are loaded, so that the view finds them made.
void makeDrawnMeshes(const scene::Description& scene, const Watch& watch);

}  // namespace underact::gui
