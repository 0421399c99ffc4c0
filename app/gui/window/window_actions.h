#pragma once
#include <functional>
#include <vector>

#include "app/gui/feature/feature.h"

namespace underact::gui {

/// The window's own actions: start and stop, files, undo, the layout, and what the window is used for.
void addWindowActions(const FeatureParts& parts, const std::vector<FeatureRow>& rows,
                      const std::function<void()>& arrange, const std::function<void(const QString&)>& choose);

}  // namespace underact::gui
