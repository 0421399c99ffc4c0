#pragma once
#include <memory>
#include <optional>
#include <string>

#include "core/record/csv.h"
#include "core/record/recorder.h"

namespace underact::cli {

/// What `run --record FILE` writes: CSV where the name ends in .csv, else a session.
class Recording {
 public:
  /// Whether a file may be made at path, before anything runs. Problems: those of checkNew(), with the way out.
  static Problems check(const std::string& path, system::Existing existing);
  /// Before the first tick. options: of a session; existing of both. Problems: the file could not be created.
  static Result<Recording> start(servo::Host& host, const std::string& path, const record::SessionMetadata& words,
                                 const record::RecorderOptions& options);
  /// For a CSV file; a session gets the ticks from the servo itself.
  void add(const servo::TickRecord& record) {
    if (csv_) csv_->add(record);
  }
  /// Notes how the servo runs, once it has begun.
  void noteServo() {
    if (session_) session_->noteServo();
  }
  /// It cannot be written further; close() gives the reason.
  bool hasFailed() const;
  Problems close();

 private:
  std::optional<record::CsvWriter> csv_;
  std::unique_ptr<record::Recorder> session_;
};

}  // namespace underact::cli
