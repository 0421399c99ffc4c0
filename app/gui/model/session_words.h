#pragma once
#include <QString>
#include <cstdint>

#include "core/record/recorder.h"

namespace underact::gui {

/// "01:23", "1:02:03": as a clock that runs.
QString clockText(double seconds);

/// "1.2 s", "5 min", "2 h 10 min", "9 days": as one says it.
QString spanText(double seconds);

/// "820 kB", "4.2 MB", "1.3 GB".
QString bytesText(std::int64_t bytes);

/// The disk will not take 10 min more at this pace, or less than 1 GB is left on it.
bool isDiskLow(const record::RecorderStatus& status);

/// "12.0 GB left, enough for 9 days"
QString diskText(const record::RecorderStatus& status);

}  // namespace underact::gui
