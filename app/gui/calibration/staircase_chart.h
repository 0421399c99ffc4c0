#pragma once
#include "app/gui/plot/mark_chart.h"
#include "core/calibration/measurement.h"

namespace underact::gui {

/// An empty chart of the difference of stiffness against the trial.
MarkChart* staircaseChart(QWidget* parent);

/// The difference on a logarithmic scale: filled right, hollow wrong, a ring at a reversal; the threshold as a
/// line in a band of one standard deviation either way.
MarkSheet staircaseSheet(const calibration::Measurement& run);

}  // namespace underact::gui
