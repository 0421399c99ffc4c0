#pragma once
#include <QString>
#include <cstdint>

#include "core/record/recorder.h"

namespace underact::gui {

/// "01:23", "1:02:03": as a running clock.
QString clockText(double seconds);

/// "1.2 s", "5 min", "2 h 10 min", "9 days": as in speech.
QString spanText(double seconds);

/// "820 kB", "4.2 MB", "1.3 GB".
QString bytesText(std::int64_t bytes);

/// The disk has space for less than 10 min at this rate, or less than 1 GB left.
bool isDiskLow(const record::RecorderStatus& status);

/// "12.0 GB left, enough for 9 days"
QString diskText(const record::RecorderStatus& status);

}  // namespace underact::gui
