#pragma once
#include <functional>
#include <span>

#include "app/gui/model/session_data.h"

namespace underact::gui {

/// One value of a session against time, s: the minimum and maximum of each of `columns` ranges, in order of time, so
/// that a spike of one tick is drawn. largest_step: a larger one breaks the line. points: at least 4 (columns + 2);
/// unused ones repeat the last. Returns how many were used; values that are not finite are left out.
std::size_t thinSession(const std::vector<SessionRow>& rows, const std::function<float(const SessionRow&)>& value,
                        std::size_t columns, float largest_step, std::span<PlotPoint> points);

/// The path of (away_mm, force_N) along an axis: the extreme points of each of `groups` ranges, in order of time.
/// points: at least 4 (groups + 2).
std::size_t thinSessionPath(const std::vector<SessionRow>& rows, std::size_t axis, std::size_t groups,
                            std::span<PlotPoint> points);

}  // namespace underact::gui
