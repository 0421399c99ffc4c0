#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/scene/description.h"
#include "core/servo/host.h"

namespace underact::serve {

class Service;

/// A recording that is under way.
struct RecordingNow {
  std::string path;
  std::int64_t ticks = 0;
  bool is_clients = false;  // a client began it, so that one may end it
};

/// A running scene as a service steers it: the command line has the servo's host for itself, in a window the person
/// edits the same scene. One thread: that of the host.
class Steered {
 public:
  Steered() = default;
  virtual ~Steered() = default;
  Steered(const Steered&) = delete;
  Steered& operator=(const Steered&) = delete;

  virtual servo::Host& host() = 0;
  /// Gives the service the ticks and the faults since the last call.
  virtual void drain(Service& service) = 0;
  /// Why no program may steer now, with the way out; empty: one may.
  virtual std::string refusal() const = 0;
  /// As servo::Host::load(), for a client of that name.
  virtual Problems load(const scene::Description& scene, const std::string& by) = 0;
  /// As servo::Host::edit(), for a client of that name.
  virtual Problems edit(const scene::Description& edited, std::int64_t over_ticks, const std::string& by) = 0;

  /// None: nothing is being recorded.
  virtual std::optional<RecordingNow> recording() = 0;
  /// Begins a client's recording. name: of a new file in the sessions folder. Problems: it cannot be made.
  virtual Problems startRecording(const std::string& name) = 0;
  /// Ends the recording, if there is one; what it was. Problems: it is incomplete.
  virtual Result<RecordingNow> endRecording() = 0;
  /// Marks the present tick of the recording, if there is one.
  virtual void mark(const std::string& text) = 0;
};

}  // namespace underact::serve
