#pragma once
#include <QString>

#include "core/servo/host.h"

namespace underact::gui {

/// "real time: FIFO 80"
QString schedulingText(const system::Scheduling& scheduling);

}  // namespace underact::gui
