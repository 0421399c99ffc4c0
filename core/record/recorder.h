#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/record/session_writer.h"
#include "core/servo/host.h"

namespace underact::record {

/// When a recording ends by itself, and how its file is written.
struct RecorderOptions {
  std::int64_t max_ticks = 0;  // at most; 0: until stop()
  /// With less left on the disk the recording ends in order; none: 64 MiB, or less where the disk is small.
  std::optional<std::int64_t> reserve_bytes = {};
  double block_s = kBlock_s;                             // kShortestBlock_s to kLongestBlock_s
  system::Existing existing = system::Existing::Refuse;  // what to do if a file of that name exists
  json::ObjectText run = {};    // what the servo does not know of the run: program, seed, hand, arm model
  bool details = false;         // true tip and hand's force of a simulated arm, and each constraint's target and force
  std::string session_id = {};  // empty: a new one
  double clock_every_s = 10.0;  // between two rows of /clock
  SessionLimits limits = {};    // of one file; tests have smaller ones
};

/// The state of a recording.
struct RecorderStatus {
  bool recording = true;  // false: it ended, by itself or by stop()
  std::int64_t ticks = 0;
  double duration_s = 0.0;
  std::int64_t bytes = 0;    // of all files
  std::int64_t dropped = 0;  // ticks for which there was no space
  std::int64_t disk_left_bytes = 0;
  double disk_left_s = 0.0;        // at the present rate, until it ends by itself; 0: not known yet
  Problems problems;               // why it ended by itself, and what is missing
  std::vector<std::string> files;  // the parts of the recording; another one begins before a limit of a session is met
};

/// The file of a part of the recording at path: NAME_2.h5 beside NAME.h5.
std::string nameOfPart(const std::string& path, int part);

/// What a person has to know at once of a recording and what an earlier status did not say: that it went on in another
/// file, that it ended by itself, that ticks are missing.
std::vector<Sentence> newsOf(const RecorderStatus& before, const RecorderStatus& now);

/// Records a servo into a session file, in a thread of its own. The servo never waits for it. The file can be read
/// while it grows; if the program is killed, at most the last 0.25 s are missing. Before a limit of SessionLimits is
/// met it goes on in another file, without a tick missing between the two: NAME_2.h5 beside NAME.h5, or the next free
/// number.
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
  /// The word that no other session has; of the first file. Any thread.
  const std::string& sessionId() const;
  /// Of the first file. Any thread.
  const std::string& path() const;

 private:
  struct Impl;
  explicit Recorder(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// Completes a file of this program that could not be ended in order: as recover(), without checking it first.
Result<std::int64_t> completeFile(const std::string& path);

/// Completes a file that a killed program left: truncates it to the last block that all tables have and marks it as
/// recovered, so that every program opens it. On a copy beside it (".part"), which takes its place once it can be read
/// whole. A session that ended in order stays as it is. Gives the number of ticks. Problems: not a session, or damaged
/// beyond what a recording can be, see UntrustedFile; a link; being recorded; no room for the copy. Then nothing was
/// changed.
Result<std::int64_t> recover(const std::string& path);

}  // namespace underact::record
