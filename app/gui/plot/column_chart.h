#pragma once
#include <vector>

#include "app/gui/plot/chart.h"

namespace underact::gui {

class ColumnRows;

/// A chart of the columns that were chosen, against time: titled by their units.
Chart columnChart(const std::vector<int>& columns);
/// Its curves in colours that colour-blind people can tell apart.
void setColumnColours(Chart& chart, const Theme& theme);
/// Fills it from from_s to to_s; shift_s: added to each time. helpers: curves after those of the columns.
void fillColumnChart(Chart& chart, const ColumnRows& rows, double from_s, double to_s, double shift_s);

}  // namespace underact::gui
