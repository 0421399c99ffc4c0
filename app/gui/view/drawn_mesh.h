#pragma once
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cstddef>
#include <memory>

#include "core/base/task_monitor.h"
#include "core/mesh/surface.h"
#include "core/scene/description.h"

namespace underact::gui {

/// Meshes with more triangles are drawn coarser; what is felt has all of them.
inline constexpr std::size_t kMaxDrawn = 100'000;

/// Triangles as they are drawn: with normals, smooth but for sharp edges. most: above, they are made coarser. Any
/// thread. null: it was cancelled.
vtkSmartPointer<vtkPolyData> bodyOf(const mesh::Triangles& triangles, const TaskMonitor& monitor, std::size_t max);

/// A mesh as it is drawn, in its own frame and unit.
struct DrawnMesh {
  vtkSmartPointer<vtkPolyData> body;   // triangles with normals: smooth, but with breaks at sharp edges
  vtkSmartPointer<vtkPolyData> edges;  // the sharp ones, and the borders
  mesh::Triangles coarser;             // its triangles, if it is coarser; closed if the surface is
  std::size_t triangles = 0;
  bool is_coarser = false;
};

/// Made once for each surface and kept as long as the surface exists. Takes a second for millions of triangles. Any
/// thread. null: it was cancelled. most: triangles above which it is made coarser; ignored if it exists already.
std::shared_ptr<const DrawnMesh> drawnMesh(const std::shared_ptr<const mesh::Surface>& surface,
                                           const TaskMonitor& monitor = {}, std::size_t max = kMaxDrawn);

/// The body with the winding of its faces reversed; for a placement that mirrors it, so that its outside remains its
/// front. Normals are kept: they are mirrored correctly. Takes some milliseconds.
vtkSmartPointer<vtkPolyData> turnedOver(vtkPolyData* body);

/// For all loaded meshes of a scene, in advance of the view.
void makeDrawnMeshes(const scene::Description& scene, const TaskMonitor& monitor);

}  // namespace underact::gui
