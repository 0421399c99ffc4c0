#include "app/serve/host_alone.h"

#include <filesystem>
#include <utility>

#include "app/serve/service.h"

namespace underact::serve {

HostAlone::HostAlone(servo::Host& host, HostAloneOptions options) : host_(host), options_(std::move(options)) {}

HostAlone::~HostAlone() = default;

void HostAlone::drain(Service& service) {
  host_.drain([&](const servo::TickRecord& record) {
    if (options_.tick) options_.tick(record);
    service.add(record);
  });
  while (const std::optional<servo::FaultReport> report = host_.takeFault()) service.add(report->fault, report->tick);
}

Problems HostAlone::load(const scene::Description& scene, const std::string&) {
  return host_.load(scene);
}

Problems HostAlone::edit(const scene::Description& edited, std::int64_t over_ticks, const std::string&) {
  return host_.edit(edited, over_ticks);
}

std::optional<RecordingNow> HostAlone::recording() {
  if (recorder_ && !recorder_->status().recording) static_cast<void>(endRecording());  // it ended by itself
  if (!recorder_) return std::nullopt;
  return RecordingNow{recorder_->path(), recorder_->status().ticks, is_clients_};
}

Problems HostAlone::startRecording(const std::string& name) {
  if (system::makePrivateFolder(options_.sessions_folder) != 0)
    return Problems{{"The sessions folder " + options_.sessions_folder + " cannot be made."}};
  return startInto(options_.sessions_folder + "/" + name, system::Existing::Refuse, true);
}

Problems HostAlone::startRecordingAt(const std::string& path, system::Existing existing) {
  return startInto(path, existing, false);
}

Problems HostAlone::startInto(const std::string& path, system::Existing existing, bool is_clients) {
  record::RecorderOptions wanted;
  wanted.existing = existing;
  wanted.run = options_.run;
  record::SessionMetadata words;
  words.name = std::filesystem::path(path).stem().string();
  Result<std::unique_ptr<record::Recorder>> started = record::Recorder::start(host_, path, words, wanted);
  if (!started) return started.problems();
  recorder_ = std::move(started).value();
  told_ = {};
  is_clients_ = is_clients;
  return {};
}

Result<RecordingNow> HostAlone::endRecording() {
  if (!recorder_) return RecordingNow{};
  const Problems problems = recorder_->stop();
  takeNews();
  const RecordingNow ended{recorder_->path(), recorder_->status().ticks, is_clients_};
  recorder_.reset();
  if (problems.empty()) return ended;
  if (!is_clients_) unwritten_.insert(unwritten_.end(), problems.begin(), problems.end());
  return problems;
}

void HostAlone::mark(const std::string& text) {
  if (recorder_) recorder_->mark(text);
}

void HostAlone::noteServo() {
  if (recorder_) recorder_->noteServo();
}

void HostAlone::takeNews() {
  if (!recorder_) return;
  const record::RecorderStatus now = recorder_->status();
  const std::vector<Sentence> more = record::newsOf(std::exchange(told_, now), now);
  news_.insert(news_.end(), more.begin(), more.end());
}

std::vector<Sentence> HostAlone::news() {
  static_cast<void>(recording());  // ends one that ended by itself
  takeNews();
  return std::exchange(news_, {});
}

Problems HostAlone::close() {
  is_clients_ = false;
  static_cast<void>(endRecording());  // it keeps the problems
  return std::exchange(unwritten_, {});
}

}  // namespace underact::serve
