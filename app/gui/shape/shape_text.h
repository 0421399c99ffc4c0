#pragma once
#include <QString>
#include <vector>

#include "core/scene/description.h"

namespace underact::gui {

/// One line of the geometry read-out: "Radius", "50.0 mm".
struct ShapeLine {
  QString label;
  QString value;
};

/// A constraint in numbers: type and side, then lengths in mm and directions as unit vectors.
std::vector<ShapeLine> shapeText(const scene::Constraint& constraint);

/// "Sphere"
QString shapeName(const scene::Shape& shape);

}  // namespace underact::gui
