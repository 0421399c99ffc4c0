#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/base/types.h"

namespace underact::test {

/// Haply's service and the Inverse3 behind it, made from the messages that its own client crate publishes: but for the
/// sockets (core/web_socket) it shares no line with device/haply or app/serve. A WebSocket and plain HTTP at a free
/// port of this computer. Any thread.
class HaplyService {
 public:
  struct Options {
    std::string version = "3.5.0";  // below 3.5 a force is in "values", from then on in "vector"
    std::string id = "04C3";
    std::string axes = "XYZ";
    bool is_middle_origin = false;
    bool has_grip = true;
    bool has_version = true;  // answers GET /version
  };
  HaplyService();
  explicit HaplyService(const Options& options);
  ~HaplyService();
  int port() const;

  // The hand.
  void placeTip(const Vec3& p_WT);
  void turnTip(const Mat3& R_WT);
  void holdButton(bool held);
  void freeze(bool on);  // the same state to the bit
  // What can happen to it.
  void unplugArm(bool on);
  void setStatus(bool calibrated, bool has_power, bool ready);
  void stop();                                       // the service: all connections are gone, nobody listens
  void start();                                      // at the same port
  void hold(bool on);                                // it does not answer
  void sayInstead(std::optional<std::string> text);  // of each state
  /// The force at the motors, N, in W: of the last frame, while its client is connected and the arm is plugged in.
  Vec3 force_N() const;
  std::int64_t forces() const;  // frames with one, while the arm is plugged in
  std::int64_t pushes() const;  // of them, with one that is not 0
  std::int64_t frames() const;
  std::string greeting() const;  // the first frame of the last client
  std::string stateText(bool is_full) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace underact::test
