#pragma once
#include <QString>

#include "core/scene/difference.h"

namespace underact::gui {

/// A difference between two scenes as the panels name it: "stiffness", "0.25 N/mm", "0.5 N/mm".
struct DifferenceWords {
  QString what, one, other;
};

DifferenceWords differenceWords(const scene::Difference& difference);

}  // namespace underact::gui
