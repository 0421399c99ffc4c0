#pragma once
#include <vector>

#include "app/gui/feature/feature.h"

namespace underact::gui {

/// All that the window can do, in the order of its panels. Made of the lines underact_feature() of the top
/// CMakeLists.txt.
std::vector<FeatureRow> features();

/// Of all of them.
std::vector<PanelRow> panelsOf(const std::vector<FeatureRow>& rows);

/// The guide's pages for all parts of a window with these features.
std::vector<HelpPage> helpPages(const std::vector<FeatureRow>& rows);

}  // namespace underact::gui
