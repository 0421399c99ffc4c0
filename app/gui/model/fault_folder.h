#pragma once
#include <QString>

namespace underact::gui {

/// Where faults are saved: one file each, the newest 20.
QString faultFolder();

}  // namespace underact::gui
