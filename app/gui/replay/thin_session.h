#pragma once
#include <functional>
#include <span>

#include "app/gui/model/session_data.h"

namespace underact::gui {

/// One value of a session against time, s: of each of `columns` stretches the least and the greatest, in the order they
/// came, so that a spike of one tick is drawn. largest_step: one that is larger breaks the line. points: at least 4
/// (columns + 2); what is left over repeats the last. Gives how many were used; values that are not finite are left
/// out.
std::size_t thinSession(const std::vector<SessionRow>& rows, const std::function<float(const SessionRow&)>& value,
                        std::size_t columns, float largest_step, std::span<PlotPoint> points);

/// The way of (away_mm, force_N) along an axis: of each of `groups` stretches the extreme points, in order. points: at
/// least 4 (groups + 2).
std::size_t thinSessionPath(const std::vector<SessionRow>& rows, std::size_t axis, std::size_t groups,
                            std::span<PlotPoint> points);

}  // namespace underact::gui
