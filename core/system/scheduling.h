#pragma once
#include <cstdint>
#include <vector>

#include "core/base/sentence.h"

namespace underact::system {

/// Which way to real time is tried. Auto: FIFO, then rtkit, then none.
enum class Way : std::uint8_t { Auto, Fifo, Rtkit, Normal };

/// What is asked of the system for the servo thread.
struct SchedulingWanted {
  Way way = Way::Auto;
  int core = -1;            // the one core it runs on; -1: an isolated one where there is any, else all
  bool lock_memory = true;  // no page of the program leaves the memory, where the system's limit allows
};

/// What scheduling the system granted the servo thread.
struct Scheduling {
  Sentence name;               // "FIFO 80", "rtkit 20", "normal", "manual", "not begun": for the status bar
  Sentence hint;               // how to get better; empty: it is as good as it gets
  std::vector<Sentence> also;  // "memory locked", "all cores", "denormals flushed", ...: a phrase each
};

}  // namespace underact::system
