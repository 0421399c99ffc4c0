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

/// A constraint in numbers: its type and side, then its lengths in mm and its directions, made unit length.
std::vector<ShapeLine> shapeText(const scene::Constraint& constraint);

/// "Sphere"
QString shapeName(const scene::Shape& shape);

}  // namespace underact::gui
