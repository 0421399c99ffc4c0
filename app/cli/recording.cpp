#include "app/cli/recording.h"

#include <utility>

namespace underact::cli {

Problems Recording::check(const std::string& path, system::Existing existing) {
  if (path.empty()) return {};
  Problems problems = system::checkNew(path, existing);
  if (!problems.empty() && system::checkNew(path, system::Existing::Replace).empty())
    problems.front().sentence = oneAfterAnother(
        {problems.front().sentence, "With --overwrite it is replaced; the target of a link is not changed."});
  return problems;
}

Result<Recording> Recording::start(servo::Host& host, const std::string& path, const record::SessionMetadata& words,
                                   const record::RecorderOptions& options) {
  Recording recording;
  if (path.ends_with(".csv")) {
    Result<record::CsvWriter> csv = record::CsvWriter::create(path, options.existing);
    if (!csv) return csv.problems();
    recording.csv_ = std::move(csv).value();
    return recording;
  }
  Result<std::unique_ptr<record::Recorder>> session = record::Recorder::start(host, path, words, options);
  if (!session) return session.problems();
  recording.session_ = std::move(session).value();
  return recording;
}

bool Recording::hasFailed() const {
  return (csv_ && csv_->hasFailed()) || (session_ && !session_->status().problems.empty());
}

Problems Recording::close() {
  if (csv_) return csv_->close();
  return session_ ? session_->stop() : Problems{};
}

}  // namespace underact::cli
