#pragma once
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <QColor>
#include <array>
#include <span>
#include <vector>

#include "app/gui/view/solid_forms.h"

namespace underact::gui {

/// One colour for each Finish.
using Finishes = std::array<QColor, kFinishes>;

/// The surfaces of the solids of a link, mm, each point with the colour of its finish.
vtkSmartPointer<vtkPolyData> meshOfLink(std::span<const ArmSolid> solids, std::size_t link, const Finishes& finishes);

/// Those of all links in one, each displaced by X_WLinks (of the base first), as often as there are configurations,
/// but once where a link is in the same place in several; without colours.
vtkSmartPointer<vtkPolyData> meshOfArms(std::span<const ArmSolid> solids, std::span<const std::vector<Pose>> X_WLinks);

/// The light that a surface reflects, as the renderer computes it, for lines along its edges: directions to the lights
/// in W, of length 1, and their strength.
struct EdgeShade {
  double ambient = 0.0, diffuse = 0.0;
  std::array<Vec3, 2> lights_W{Vec3::UnitZ(), Vec3::UnitZ()};
  std::array<double, 2> strengths{1.0, 0.0};
  QColor of(const QColor& colour, const Vec3& normal_W) const;
};

/// The outline of a solid at X_WLink, as seen from the eye: without multisampling the edge of a surface is jagged, and
/// a smooth line of the surface's own shade hides that.
void addOutline(Lines& lines, const ArmSolid& solid, const Pose& X_WLink, const Vec3& eye_mm, const EdgeShade& shade,
                const QColor& colour);

}  // namespace underact::gui
