#pragma once
#include <QString>

#include "core/servo/host.h"

namespace underact::gui {

/// What a fault was, with the arm's own words behind it, see DevicePort::trouble().
QString happenedText(const servo::FaultReport& report);

/// "real time: FIFO 80"
QString schedulingText(const servo::Scheduling& scheduling);

}  // namespace underact::gui
