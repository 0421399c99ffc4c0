#pragma once
#include <optional>
#include <vector>

#include "app/gui/plot/mark_chart.h"
#include "core/trade/front.h"

namespace underact::gui {

/// For error of the tip's way against processor time.
MarkChart* frontChart(QWidget* parent);

/// Both logarithmic: every way to run the scene as a dot, those that none beats in both filled and joined by a line,
/// the scene as it was as a square, the chosen one ringed. chosen: of the points; none: another way than these is in
/// effect.
MarkSheet frontSheet(const std::vector<trade::Point>& points, const std::optional<std::size_t>& chosen);

}  // namespace underact::gui
