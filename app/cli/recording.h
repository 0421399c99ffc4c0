#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/record/csv.h"
#include "core/record/recorder.h"

namespace underact::cli {

/// The format that a name ends in, in any case: "csv", "parquet", "mcap", "rerun", "page"; empty: none.
std::string formatOf(const std::string& name);

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
    if (!csv_ || csv_->hasFailed()) return;
    csv_->add(record);
    ++csv_ticks_;
  }
  /// Notes how the servo runs, once it has begun.
  void noteServo() {
    if (session_) session_->noteServo();
  }
  /// What its person has to know and was not told by the last call: sentences.
  std::vector<Sentence> news();
  /// Problems: what is missing, and why. untaken: ticks that were lost on the way to add().
  Problems close(std::int64_t untaken);
  /// Ticks in it.
  std::int64_t ticks() const { return session_ ? session_->status().ticks : csv_ticks_; }

 private:
  std::optional<record::CsvWriter> csv_;
  std::unique_ptr<record::Recorder> session_;
  record::RecorderStatus told_;
  std::int64_t csv_ticks_ = 0;
  bool has_told_ = false;  // that CSV has failed
};

}  // namespace underact::cli
