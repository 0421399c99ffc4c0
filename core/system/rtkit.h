#pragma once
#include "core/base/sentence.h"

namespace underact::system {

/// What rtkit answered.
struct RtkitAnswer {
  int priority = 0;  // that the calling thread has from now on (SCHED_RR); 0: none
  Sentence refusal;  // why not, a few words
};

/// Asks RealtimeKit, over the system's D-Bus (DBUS_SYSTEM_BUS_ADDRESS, where it is set), to make the calling thread
/// real-time, at priority 20 or the highest that the service grants. The service demands a limit on real time without
/// a rest first: RLIMIT_RTTIME of the process goes down to 200 ms at most, and the kernel ends a process that computes
/// through all of it. Waits up to 1 s for each of three answers.
RtkitAnswer askRtkit();

}  // namespace underact::system
