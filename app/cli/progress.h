#pragma once
#include <ostream>

#include "app/cli/command.h"

namespace underact::cli {

/// A line of percent on a terminal, and nothing elsewhere.
class Progress {
 public:
  explicit Progress(const Streams& streams) : streams_(streams) {}
  /// share: 0 to 1.
  void show(double share) {
    const int percent = static_cast<int>(100.0 * share);
    if (!streams_.progress || percent == shown_) return;
    shown_ = percent;
    streams_.err << '\r' << percent << " %" << (percent == 100 ? "\n" : "") << std::flush;
  }

 private:
  const Streams& streams_;
  int shown_ = -1;
};

}  // namespace underact::cli
