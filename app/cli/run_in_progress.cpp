#include "app/cli/run_in_progress.h"

#include <algorithm>
#include <chrono>
#include <ostream>
#include <thread>
#include <utility>

#include "core/base/printed.h"
#include "core/record/fault_file.h"

namespace underact::cli {
namespace {

constexpr std::int64_t kTicksAtOnce = 1000;  // far fewer than the servo keeps for us
constexpr std::chrono::milliseconds kBetweenDrains{20};

}  // namespace

void Run::take(servo::Host& host) {
  host.drain([this](const servo::TickRecord& record) {
    if (isDone()) return;
    summary_.add(record);
    if (recording_) recording_->add(record);
    if (live_) live_->send(record);
  });
  if (recording_) {
    for (const Sentence& sentence : recording_->news()) streams_.err << sentence << '\n';
  }
  progress_.show(static_cast<double>(summary_.ticks()) / static_cast<double>(wanted_));
}

Problems Run::closeRecording(std::int64_t untaken) {
  if (!recording_) return {};
  Problems problems = recording_->close(untaken);
  if (!problems.empty())
    problems.push_back({"The recording is not whole: it has " + std::to_string(recording_->ticks()) + " of " +
                        std::to_string(summary_.ticks() + untaken) + " ticks."});
  return problems;
}

void Run::addStream(JsonObject& summary) const {
  if (!live_) return;
  JsonObject stream;
  stream.addInteger("sent", live_->sent());
  stream.addInteger("lost", live_->lost());
  summary.addObject("stream", stream);
  if (live_->lost() > 0)
    streams_.err << live_->lost() << " packets of live data were lost: the network did not take them.\n";
}

void runFast(servo::Host& host, Run& run, const system::Interrupt& interrupt) {
  while (!run.isDone() && !interrupt.came()) {
    host.run(std::min(kTicksAtOnce, run.left()));
    run.take(host);
  }
}

void runInRealTime(servo::Host& host, Run& run, const system::Interrupt& interrupt, const Streams& streams) {
  for (bool is_guarded = true; !run.isDone() && !interrupt.came();) {
    std::this_thread::sleep_for(kBetweenDrains);
    run.take(host);
    const Sentence unguarded = host.unguarded();
    if (std::exchange(is_guarded, unguarded.empty()) != is_guarded)
      streams.err << (is_guarded ? "The arm is guarded again." : unguarded) << '\n';
  }
}

Problems reportFaults(servo::Host& host, Run& run, const std::string& file, const Streams& streams) {
  Problems problems;
  bool first = run.summary().faulted();  // one after the last requested tick does not belong to this run
  while (const std::optional<servo::FaultReport> report = host.takeFault()) {
    run.tell(*report);
    if (!report->trouble.empty()) streams.err << printed(report->trouble) << '\n';
    if (first && !file.empty())
      problems = record::writeFaultFile(record::faultText(*report, record::wordsOf(*report)), file);
    first = false;
  }
  return problems;
}

}  // namespace underact::cli
