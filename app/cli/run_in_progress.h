#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "app/cli/command.h"
#include "app/cli/json_object.h"
#include "app/cli/progress.h"
#include "app/cli/recording.h"
#include "app/cli/run_summary.h"
#include "app/stream/live_stream.h"
#include "core/servo/host.h"
#include "core/system/signals.h"

namespace underact::cli {

/// A run in progress: takes the ticks as they come, up to the requested number.
class Run {
 public:
  Run(std::int64_t wanted, std::optional<Recording> recording, std::optional<stream::LiveStream> live,
      const Streams& streams)
      : wanted_(wanted), recording_(std::move(recording)), live_(std::move(live)), streams_(streams) {}

  void take(servo::Host& host);
  void tell(const servo::FaultReport& report) { summary_.tell(report.tick, report.fault); }
  bool isDone() const { return summary_.ticks() >= wanted_; }
  std::int64_t left() const { return wanted_ - summary_.ticks(); }
  const RunSummary& summary() const { return summary_; }
  /// What became of the live data, where there was any.
  void addStream(JsonObject& summary) const;
  /// untaken: ticks that take() did not get. Problems: what is missing in the recording; the last one says how much.
  Problems closeRecording(std::int64_t untaken);

 private:
  std::int64_t wanted_;
  std::optional<Recording> recording_;
  std::optional<stream::LiveStream> live_;
  const Streams& streams_;
  RunSummary summary_;
  Progress progress_{streams_};
};

/// Until the run is done or interrupted.
void runFast(servo::Host& host, Run& run, const system::Interrupt& interrupt);
/// Runs it at the speed of the servo's own thread, which runs.
void runInRealTime(servo::Host& host, Run& run, const system::Interrupt& interrupt, const Streams& streams);

/// Adds every fault to the summary, and writes the first to a file if requested.
Problems reportFaults(servo::Host& host, Run& run, const std::string& file, const Streams& streams);

}  // namespace underact::cli
