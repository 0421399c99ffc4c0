#pragma once
#include <cstdint>
#include <vector>

#include "core/base/sentence.h"

namespace underact::system {

/// How real-time scheduling is obtained. Auto: FIFO, then rtkit, then none.
enum class SchedulingMethod : std::uint8_t { Auto, Fifo, Rtkit, Normal };

/// The scheduling requested for the servo thread.
struct SchedulingRequest {
  SchedulingMethod method = SchedulingMethod::Auto;
  int core = -1;            // the core it runs on; -1: an isolated one where there is one, else all
  bool lock_memory = true;  // lock the program's memory, where the system's limit allows
};

/// The scheduling granted to the servo thread.
struct Scheduling {
  Sentence name;               // "FIFO 80", "rtkit 20", "normal", "manual", "not begun": for the status bar
  Sentence hint;               // how to get better scheduling; empty: it is the best
  std::vector<Sentence> also;  // "memory locked", "all cores", "denormals flushed", ...: a phrase each
};

}  // namespace underact::system
