#pragma once
#include <optional>
#include <vector>

#include "app/gui/plot/mark_chart.h"
#include "core/tradeoff/front.h"

namespace underact::gui {

/// An empty chart of the error of the tip's path against processor time.
MarkChart* frontChart(QWidget* parent);

/// Both axes logarithmic: every combination as a dot, those on the front filled and joined by a line, the scene as it
/// was as a square, the chosen one ringed. chosen: index into the points; none: another combination is set.
MarkSheet frontSheet(const std::vector<tradeoff::Point>& points, const std::optional<std::size_t>& chosen);

}  // namespace underact::gui
