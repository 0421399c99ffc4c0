#pragma once
#include <functional>
#include <vector>

#include "app/gui/feature/feature.h"

namespace underact::gui {

/// The window's own actions: start and stop, files, undo, the layout.
void addWindowActions(const FeatureParts& parts, const std::vector<FeatureRow>& rows,
                      const std::function<void()>& arrange);

}  // namespace underact::gui
