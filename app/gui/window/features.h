#pragma once
#include <vector>

#include "app/gui/feature/feature.h"

namespace underact::gui {

/// All features of the window, in the order of its panels. Generated from the lines underact_feature() in the top
/// CMakeLists.txt.
std::vector<FeatureRow> features();

/// The panels of all features.
std::vector<PanelRow> panelsOf(const std::vector<FeatureRow>& rows);

/// The guide's pages for every part of a window with these features.
std::vector<HelpPage> helpPages(const std::vector<FeatureRow>& rows);

}  // namespace underact::gui
