#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/serve/steered.h"
#include "core/json/object_text.h"
#include "core/record/recorder.h"
#include "core/system/private_file.h"

namespace underact::serve {

struct HostAloneOptions {
  std::string sessions_folder;                              // for recordings by clients
  std::function<void(const servo::TickRecord&)> tick = {};  // gets every tick, too
  json::ObjectText run = {};                                // what the servo does not know of the run, for the sessions
};

/// A host that a service has for itself, with the sessions it records.
class HostAlone final : public Steered {
 public:
  /// host: loaded; it outlives this.
  HostAlone(servo::Host& host, HostAloneOptions options);
  ~HostAlone() override;

  servo::Host& host() override { return host_; }
  void drain(Service& service) override;
  std::string refusal() const override { return {}; }
  Problems load(const scene::Description& scene, const std::string& by) override;
  Problems edit(const scene::Description& edited, std::int64_t over_ticks, const std::string& by) override;
  std::optional<RecordingNow> recording() override;
  Problems startRecording(const std::string& name) override;
  Result<RecordingNow> endRecording() override;
  void mark(const std::string& text) override;

  /// Records into a new file from now on, until close(). Problems: it cannot be made.
  Problems startRecordingAt(const std::string& path, system::Existing existing);
  /// Notes in the recording how the servo runs, once it has begun.
  void noteServo();
  /// What the person has to know of the recordings and was not told by the last call: sentences.
  std::vector<Sentence> news();
  /// Closes the recording. Problems: it, or that of startRecordingAt(), is incomplete.
  Problems close();

 private:
  void takeNews();
  Problems startInto(const std::string& path, system::Existing existing, bool is_clients);

  servo::Host& host_;
  HostAloneOptions options_;
  std::unique_ptr<record::Recorder> recorder_;
  record::RecorderStatus told_;
  std::vector<Sentence> news_;  // of one that has ended
  bool is_clients_ = false;
  Problems unwritten_;  // of what close() is asked about
};

}  // namespace underact::serve
