#pragma once
#include <poll.h>
#include <sys/socket.h>

#include <array>
#include <cstring>
#include <string>

#include "core/arm/inverse.h"
#include "core/servo/device_port.h"

namespace underact::test {

/// An arm behind a socket, as one behind USB is: each write sends a frame of three doubles, N; each read waits up to
/// 20 ms for a frame of three doubles, where the tip is, m.
class WirePort final : public servo::DevicePort {
 public:
  using Frame = std::array<double, 3>;
  explicit WirePort(int fd) : fd_(fd) {}

  bool read(arm::Sample& sample) noexcept override {
    pollfd ready{fd_, POLLIN, 0};
    Frame tip_m{};
    if (::poll(&ready, 1, 20) <= 0 || ::recv(fd_, tip_m.data(), sizeof(tip_m), 0) != sizeof(tip_m)) return false;
    sample.time_ns = ++reads_ * 1'000'000;
    sample.q_rad =
        arm::solvePosition(arm::findPreset("omni-thesis")->geometry, Vec3(tip_m[0], tip_m[1], tip_m[2])).q_rad;
    return true;
  }
  void write(const safety::GatedForce& force) noexcept override {
    send({force.f_T_W().x(), force.f_T_W().y(), force.f_T_W().z()});
  }
  void cut() noexcept override { send({}); }
  servo::DeviceInfo info() const override { return {"Arm behind a wire", false, true}; }
  Sentence rateRefusal(int /*rate_hz*/) const override { return {}; }
  servo::ZeroForceMessage zeroForceMessage() const override { return {fd_, std::string(sizeof(Frame), '\0')}; }

 private:
  void send(const Frame& force_N) noexcept { (void)::send(fd_, force_N.data(), sizeof(force_N), MSG_NOSIGNAL); }
  int fd_;
  std::int64_t reads_ = 0;
};

}  // namespace underact::test
