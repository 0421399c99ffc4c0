#pragma once
#include <optional>

#include "core/servo/host.h"

namespace underact::gui {

/// Read-only access to a servo, for displays. For the window's thread, as long as the host lives. The functions are
/// those of servo::Host.
class ServoFacts {
 public:
  ServoFacts(servo::Host& host) : host_(&host) {}
  servo::Snapshot snapshot() const { return host_->snapshot(); }
  const servo::Timing& timing() const { return host_->timing(); }
  const scene::Description& scene() const { return host_->scene(); }
  std::uint64_t revision() const { return host_->revision(); }
  Result<tick::TickProgram> programOf(const scene::Description& scene) const { return host_->programOf(scene); }
  bool running() const { return host_->running(); }
  bool holdToRun() const { return host_->holdToRun(); }
  double forceShare() const { return host_->forceShare(); }
  int rateHz() const { return host_->rateHz(); }
  int maxLate() const { return host_->maxLate(); }
  system::Scheduling scheduling() const { return host_->scheduling(); }
  const system::SchedulingRequest& schedulingWanted() const { return host_->schedulingWanted(); }
  Sentence unguarded() const { return host_->unguarded(); }
  servo::DeviceInfo device() const { return host_->device(); }
  Sentence trouble() const { return host_->trouble(); }

 private:
  servo::Host* host_;
};

/// Control of a servo, except for its scene (Document), its arm (ArmChoice) and its rate (ServoRate).
class ServoControl {
 public:
  explicit ServoControl(servo::Host& host) : host_(&host) {}
  void start() const { host_->start(); }
  void stop() const { host_->stop(); }
  void setHoldToRun(bool on) const { host_->setHoldToRun(on); }
  Problems setForceShare(double share) const { return host_->setForceShare(share); }
  Problems restart() const { return host_->restart(); }
  std::optional<servo::FaultReport> takeFault() const { return host_->takeFault(); }

 private:
  servo::Host* host_;
};

}  // namespace underact::gui
