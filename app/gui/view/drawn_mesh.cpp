#include "app/gui/view/drawn_mesh.h"

#include <vtkCellArray.h>
#include <vtkFeatureEdges.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyDataNormals.h>
#include <vtkQuadricClustering.h>
#include <vtkReverseSense.h>

#include <QtGlobal>
#include <map>
#include <mutex>

namespace underact::gui {
namespace {

constexpr double kSharp_deg = 40.0;  // a larger angle between faces is an edge
constexpr int kFinest = 256;         // boxes along the longest side; each becomes a vertex
constexpr int kCoarsest = 16;

vtkSmartPointer<vtkPolyData> copyOf(const mesh::Triangles& triangles) {
  const std::vector<Eigen::Vector3f>& corners = triangles.p_MV;
  const std::vector<mesh::Face>& faces = triangles.faces;
  const vtkNew<vtkFloatArray> places;
  places->SetNumberOfComponents(3);
  places->SetNumberOfTuples(static_cast<vtkIdType>(corners.size()));
  for (std::size_t corner = 0; corner < corners.size(); ++corner) {
    places->SetTypedTuple(static_cast<vtkIdType>(corner), corners[corner].data());
  }
  const vtkNew<vtkPoints> points;
  points->SetData(places);
  const vtkNew<vtkCellArray> cells;
  cells->AllocateExact(static_cast<vtkIdType>(faces.size()), static_cast<vtkIdType>(3 * faces.size()));
  for (const mesh::Face& face : faces) cells->InsertNextCell({face[0], face[1], face[2]});
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  return data;
}

/// Vertices that are near each other become one, at the point that fits their faces best.
vtkSmartPointer<vtkPolyData> coarser(vtkPolyData* fine, const TaskMonitor& monitor, std::size_t max) {
  vtkSmartPointer<vtkPolyData> data = fine;
  for (int boxes = kFinest; boxes >= kCoarsest && !monitor.isCancelled(); boxes = boxes * 3 / 4) {
    const vtkNew<vtkQuadricClustering> clusters;
    clusters->SetInputData(fine);
    clusters->SetNumberOfDivisions(boxes, boxes, boxes);
    clusters->CopyCellDataOff();
    // What was closed stays closed: a wall that is flat now keeps both its sides.
    clusters->PreventDuplicateCellsOff();
    clusters->Update();
    data = clusters->GetOutput();
    if (static_cast<std::size_t>(data->GetNumberOfPolys()) <= max) break;
  }
  return data;
}

mesh::Triangles trianglesOf(vtkPolyData* data) {
  mesh::Triangles triangles;
  triangles.p_MV.reserve(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (vtkIdType corner = 0; corner < data->GetNumberOfPoints(); ++corner)
    triangles.p_MV.push_back(Eigen::Map<const Vec3>(data->GetPoint(corner)).cast<float>());
  triangles.faces.reserve(static_cast<std::size_t>(data->GetNumberOfPolys()));
  vtkCellArray* const cells = data->GetPolys();
  for (cells->InitTraversal();;) {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    if (cells->GetNextCell(count, corners) == 0) return triangles;
    const auto at = [corners](int k) { return static_cast<std::int32_t>(corners[k]); };
    triangles.faces.push_back({at(0), at(1), at(2)});
  }
}

vtkSmartPointer<vtkPolyData> withNormals(vtkPolyData* data) {
  const vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(data);
  normals->SetFeatureAngle(kSharp_deg);
  normals->SplittingOn();
  normals->ConsistencyOff();  // the winding was repaired on loading
  normals->Update();
  return normals->GetOutput();
}

vtkSmartPointer<vtkPolyData> edgesOf(vtkPolyData* data) {
  const auto find = [data](bool sharp) {
    const vtkNew<vtkFeatureEdges> edges;
    edges->SetInputData(data);
    edges->SetFeatureAngle(kSharp_deg);
    edges->SetFeatureEdges(sharp);
    edges->BoundaryEdgesOn();
    edges->NonManifoldEdgesOn();
    edges->ManifoldEdgesOff();
    edges->ColoringOff();
    edges->Update();
    return vtkSmartPointer<vtkPolyData>(edges->GetOutput());
  };
  vtkSmartPointer<vtkPolyData> edges = find(true);
  // A rough surface is sharp everywhere: lines all over it would hide it.
  if (4 * edges->GetNumberOfLines() > data->GetNumberOfPolys() && data->GetNumberOfPolys() > 1000) edges = find(false);
  return edges;
}

std::shared_ptr<const DrawnMesh> make(const mesh::Surface& surface, const TaskMonitor& monitor, std::size_t max) {
  DrawnMesh drawn;
  vtkSmartPointer<vtkPolyData> data = copyOf(surface.triangles);
  drawn.is_coarser = surface.triangles.faces.size() > max;
  if (drawn.is_coarser) {
    data = coarser(data, monitor, max);
    drawn.coarser = trianglesOf(data);
  }
  if (monitor.isCancelled()) return nullptr;
  drawn.body = withNormals(data);
  if (monitor.isCancelled()) return nullptr;
  drawn.edges = edgesOf(data);
  drawn.triangles = static_cast<std::size_t>(drawn.body->GetNumberOfPolys());
  drawn.body->ComputeBounds();
  return std::make_shared<const DrawnMesh>(std::move(drawn));
}

struct Kept {
  std::weak_ptr<const mesh::Surface> surface;
  std::shared_ptr<const DrawnMesh> drawn;
};

}  // namespace

std::shared_ptr<const DrawnMesh> drawnMesh(const std::shared_ptr<const mesh::Surface>& surface,
                                           const TaskMonitor& monitor, std::size_t max) {
  static std::mutex mutex;
  static std::map<const mesh::Surface*, Kept> kept;
  {
    const std::scoped_lock lock(mutex);
    std::erase_if(kept, [](const auto& one) { return one.second.surface.expired(); });
    const auto found = kept.find(surface.get());
    if (found != kept.end()) return found->second.drawn;
  }
  std::shared_ptr<const DrawnMesh> drawn =
      make(*surface, monitor, max);  // not under the lock: the window may request another one
  if (drawn == nullptr) return nullptr;
  const std::scoped_lock lock(mutex);
  return kept.emplace(surface.get(), Kept{surface, drawn}).first->second.drawn;
}

vtkSmartPointer<vtkPolyData> bodyOf(const mesh::Triangles& triangles, const TaskMonitor& monitor, std::size_t max) {
  vtkSmartPointer<vtkPolyData> data = copyOf(triangles);
  if (triangles.faces.size() > max) data = coarser(data, monitor, max);
  if (monitor.isCancelled()) return nullptr;
  data = withNormals(data);
  data->ComputeBounds();
  return data;
}

vtkSmartPointer<vtkPolyData> turnedOver(vtkPolyData* body) {
  const vtkNew<vtkReverseSense> turned;
  turned->SetInputData(body);
  turned->ReverseCellsOn();
  turned->ReverseNormalsOff();
  turned->Update();
  return turned->GetOutput();
}

void makeDrawnMeshes(const scene::Description& scene, const TaskMonitor& monitor) {
  for (const scene::Constraint& constraint : scene.constraints) {
    const auto* const mesh = std::get_if<scene::Mesh>(&constraint.shape);
    if (mesh == nullptr || mesh->surface == nullptr || monitor.isCancelled()) continue;
    monitor.report(QT_TRANSLATE_NOOP("step of work", "Preparing the picture"), 1.0);
    static_cast<void>(drawnMesh(mesh->surface, monitor));
  }
}

}  // namespace underact::gui
