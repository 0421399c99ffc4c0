#pragma once
#include "core/base/sentence.h"

namespace underact::system {

/// The answer of rtkit.
struct RtkitAnswer {
  int priority = 0;  // of the calling thread from now on (SCHED_RR); 0: refused
  Sentence refusal;  // why not, a few words
};

/// Asks RealtimeKit, over the system's D-Bus (DBUS_SYSTEM_BUS_ADDRESS, where it is set), for real-time scheduling of
/// the calling thread, at priority 20 or the highest that the service grants. The service requires a limit on
/// uninterrupted real-time computation first: RLIMIT_RTTIME of the process is lowered to 200 ms at most, and the kernel
/// ends a process that exceeds it. Waits up to 1 s for each of three answers.
RtkitAnswer askRtkit();

}  // namespace underact::system
