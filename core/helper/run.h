#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "core/base/task_monitor.h"
#include "core/helper/child.h"

namespace underact::helper {

/// The greatest byte that reports progress: a helper writes bytes from 1 to this before its answer.
inline constexpr unsigned char kMaxProgress = 100;

/// A program that is started for one answer.
struct HelperCall {
  std::string program;
  std::string argument;
  int input_fd = -1;  // becomes its standard input
  double max_cpu_s = 1.0, max_time_s = 10.0;
  std::uint64_t max_output = 0;
  std::function<void(unsigned char percent)> progress = {};  // called with each byte of progress
};

/// How an errand ended, and what it wrote.
struct Answer {
  Ending ending = Ending::NotStarted;
  int code = 0;                   // exit status, or the signal that ended it, or errno
  std::vector<std::byte> output;  // without the bytes of progress
  double cpu_s = 0.0;
};

/// Runs a helper to its end: it does not outlive the call, and a cancelled one ends within 50 ms. It inherits no
/// descriptor but its input. NotStarted on systems without POSIX processes.
Answer run(const HelperCall& errand, const TaskMonitor& monitor);

}  // namespace underact::helper
