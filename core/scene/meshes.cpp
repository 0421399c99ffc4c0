#include "core/scene/meshes.h"

#include <cmath>

#include "core/base/nearest_rotation.h"
#include "core/base/translate.h"
#include "core/base/units.h"
#include "core/scene/manipulators.h"
#include "core/scene/rules.h"

namespace underact::scene {
namespace {

using json::numberText;

constexpr double kSmallestScale = 1e-9, kLargestScale = 1e9;  // mm per unit

}  // namespace

void readMesh(ObjectReader& object, Mesh& into) {
  readPlacement(object, into);
  if (const json::Value* checksum = object.find("checksum")) {
    readText(*checksum, object.pathOf("checksum"), into.checksum, object.findings());
  }
}

void checkPlacement(const std::string& what, const std::string& file, double scale_mm_per_unit,
                    const Eigen::Matrix4d& X_WM, const Control& control, const Say& say) {
  if (file.empty()) say("file", phrase(TRANSLATE_NOOP("problem", "A %1 needs the name of its file."), {what}));
  const double unit_mm = std::abs(scale_mm_per_unit);  // below 0: the mirror image
  if (!(unit_mm >= kSmallestScale && unit_mm <= kLargestScale)) {
    say("scale_mm_per_unit",
        phrase(
            TRANSLATE_NOOP("problem",
                           "This must be from 1e-9 to 1e9 mm (1: the file is in mm; 1000: in m; 25.4: in inches), or "
                           "negative to mirror at the file's origin; here it is %1."),
            {numberText(scale_mm_per_unit)}));
  }
  if (const Sentence sentence = poseProblem(X_WM); !sentence.empty()) say("X_WM", sentence);
  const Vec3& kp = control.gains.kp_N_per_mm;
  const bool weighted = control.space == tick::Space::Cartesian && control.anisotropy == Anisotropy::Weighted;
  if (weighted && !(kp.x() == kp.y() && kp.y() == kp.z())) {
    say("file",
        phrase(TRANSLATE_NOOP("problem",
                              "The nearest point of a %1 is not searched in the gains' own metric. Set "
                              "\"anisotropy\" to \"euclidean\" in the control, or give every axis the same kp."),
               {what}));
  }
}

void checkMesh(const Mesh& mesh, target::Side side, const Control& control, const Say& say) {
  checkPlacement("mesh", mesh.file, mesh.scale_mm_per_unit, mesh.X_WM, control, say);
  checkSettings(mesh, say);
  if (side == target::Side::Both || mesh.search == Search::Hybrid) return;
  say("search",
      phrase(TRANSLATE_NOOP("problem", "A wall's proxy follows the surface and needs no search. Remove \"search\".")));
}

Result<target::MeshPlace> makeMeshPlace(const Mesh& mesh, target::Side side, const SourceLocation& place) {
  if (mesh.surface == nullptr)
    return Problems{{phrase(TRANSLATE_NOOP("problem", "The mesh %1 is not loaded."), {json::shown(mesh.file)}), place}};
  if (side != target::Side::Both && !mesh.surface->is_closed) {
    return Problems{
        {phrase(TRANSLATE_NOOP("problem",
                               "The mesh %1 has holes or edges that do not fit together, so it has no inside "
                               "and no outside. Remove \"side\": the stylus is then held to its surface."),
                {json::shown(mesh.file)}),
         place}};
  }
  target::MeshPlace placed;
  placed.surface = mesh.surface;
  placed.R_WM = nearestRotation(Mat3(mesh.X_WM.topLeftCorner<3, 3>()));
  placed.p_WM = kMetrePerMillimetre * mesh.X_WM.topRightCorner<3, 1>();
  placed.scale_m = kMetrePerMillimetre * mesh.scale_mm_per_unit;
  if (mesh.surface->origin_M != Vec3::Zero()) placed.p_WM += placed.scale_m * (placed.R_WM * mesh.surface->origin_M);
  placed.search = mesh.search;
  placed.lean = mesh::forceShadingOf(kRadPerDegree * mesh.smooth_deg);
  return placed;
}

}  // namespace underact::scene
