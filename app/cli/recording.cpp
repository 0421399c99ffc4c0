#include "app/cli/recording.h"

#include <algorithm>
#include <utility>

namespace underact::cli {

std::string formatOf(const std::string& name) {
  std::string ending = name.substr(std::min(name.rfind('.'), name.size()));
  for (char& letter : ending) letter = static_cast<char>(letter | (letter >= 'A' && letter <= 'Z' ? 0x20 : 0));
  if (ending == ".rrd") return "rerun";
  if (ending == ".html") return "page";
  return ending == ".csv" || ending == ".parquet" || ending == ".mcap" ? ending.substr(1) : std::string();
}

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
  if (formatOf(path) == "csv") {
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

std::vector<Sentence> Recording::news() {
  if (csv_ && csv_->hasFailed() && !std::exchange(has_told_, true))
    return {"The recording stopped: its file could not be written further. The run goes on."};
  if (!session_) return {};
  const record::RecorderStatus now = session_->status();
  return record::newsOf(std::exchange(told_, now), now);
}

Problems Recording::close(std::int64_t untaken) {
  if (session_) return session_->stop();
  Problems problems = csv_ ? csv_->close() : Problems{};
  if (csv_ && untaken > 0)
    problems.push_back(
        {std::to_string(untaken) + " ticks are missing in the recording: the computer was too busy to write them."});
  return problems;
}

}  // namespace underact::cli
