#pragma once
#include <cstdint>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/record/session_writer.h"
#include "core/servo/host.h"

namespace underact::record {

/// When a recording ends by itself, and how its file is written.
struct RecorderOptions {
  std::int64_t most_ticks = 0;                           // at most; 0: until stop()
  std::int64_t reserve_bytes = 64LL << 20;               // with less left on the disk the recording ends in order
  double block_s = kBlock_s;                             // kShortestBlock_s to kLongestBlock_s
  system::Existing existing = system::Existing::Refuse;  // what to do if a file of that name exists
  json::ObjectText run = {};    // what the servo does not know of the run: program, seed, hand, arm model
  bool details = false;         // true tip and hand's force of a simulated arm, and each constraint's target and force
  std::string session_id = {};  // empty: a new one
  double clock_every_s = 10.0;  // between two rows of /clock
};

/// The state of a recording.
struct RecorderStatus {
  bool recording = true;  // false: it ended, by itself or by stop()
  std::int64_t ticks = 0;
  double duration_s = 0.0;
  std::int64_t bytes = 0;    // of the file
  std::int64_t dropped = 0;  // ticks for which there was no space
  std::int64_t disk_left_bytes = 0;
  double disk_left_s = 0.0;  // at the present rate, until it ends by itself; 0: not known yet
  Problems problems;         // why it ended by itself
};

/// Records a servo into a session file, in a thread of its own. The servo never waits for it. The file can be read
/// while it grows; if the program is killed, at most the last 0.25 s are missing.
class Recorder {
 public:
  /// Begins with the next tick. The host must outlive the recorder. Problems: the file cannot be created.
  static Result<std::unique_ptr<Recorder>> start(servo::Host& host, const std::string& path,
                                                 const SessionMetadata& words, const RecorderOptions& options = {});
  ~Recorder();  // as stop(), if that was not called
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  // The thread that calls the host.
  /// Sets a marker at the newest tick.
  void mark(const std::string& label);
  /// Notes how the servo runs now, where that has changed: its scheduling is known once it has begun.
  void noteServo();
  /// Ends the recording and closes the file; takes some milliseconds. Problems: what is missing, and why.
  Problems stop(EndReason reason = EndReason::Stopped);
  /// Any thread.
  RecorderStatus status() const;
  /// The word that no other session has. Any thread.
  const std::string& sessionId() const;
  /// Of the file. Any thread.
  const std::string& path() const;

 private:
  struct Impl;
  explicit Recorder(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// Completes a file of this program that could not be ended in order: as recover(), without checking it first.
Result<std::int64_t> completeFile(const std::string& path);

/// Completes a file that a killed program left: truncates it to the last block that all tables have and marks it as
/// recovered, so that every program opens it. In place. A session that ended in order stays as it is. Gives the number
/// of ticks. Problems: not a session, or damaged beyond what a recording can be, see UntrustedFile; a link; being
/// recorded; it cannot be written.
Result<std::int64_t> recover(const std::string& path);

}  // namespace underact::record
