#pragma once
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/arm/model.h"
#include "core/base/task_monitor.h"

namespace underact::gui {

/// A mesh that is a part of an arm, as it is drawn, in the frame and unit of its file.
struct ArmMesh {
  vtkSmartPointer<vtkPolyData> body;  // triangles with normals, about the origin
  Vec3 origin = Vec3::Zero();
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();  // its bounds, with the origin added
};

/// The meshes of an arm, one for each solid of its model: null where the solid is none, or its file was not read.
struct ArmMeshes {
  std::vector<std::shared_ptr<const ArmMesh>> of_solids;
  Problems problems;  // why not, each with its place in the arm's file
};

/// The largest file of a mesh of an arm, and the most triangles that an arm is drawn with; with more it is coarser.
inline constexpr std::uint64_t kLargestArmMesh = std::uint64_t{64} << 20;
inline constexpr std::size_t kMaxArmTriangles = 200'000;

std::size_t countMeshes(const arm::Model& model);

/// Reads them in the reader's own process, with its bounds; what is in use already is not read again. Any thread but
/// the servo's: it takes a moment for a file. Cancelled: what is missing has no problem.
ArmMeshes readArmMeshes(const arm::Model& model, const TaskMonitor& monitor);

}  // namespace underact::gui
