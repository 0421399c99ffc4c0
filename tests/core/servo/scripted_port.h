#pragma once
#include <atomic>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/arm/inverse.h"
#include "core/servo/device_port.h"

namespace underact::test {

/// A device of the tests: the tip is where `tip` says at each read, and what is written is kept. Faults are injected by
/// `spoil`, which may change or withhold the sample.
class ScriptedPort final : public servo::DevicePort {
 public:
  struct Seen {
    std::vector<Vec3> forces;
    std::atomic<std::int64_t> writes{0};
    std::atomic<double> last_size_N{0.0};
    std::atomic<std::int64_t> cuts{0};
  };
  explicit ScriptedPort(Seen& seen, std::size_t keep = 0) : seen_(seen), keep_(keep) { seen_.forces.reserve(keep); }

  std::function<Vec3(std::int64_t)> tip = [](std::int64_t) { return Vec3(0.0, 0.0, 0.06); };
  std::function<bool(std::int64_t, arm::Sample&)> spoil;
  std::function<Problems()> opens_again;
  std::function<void()> written;  // after each force
  std::int64_t period_ns = 1'000'000;
  double frozen_s = 0.0;
  bool takes_rates = false;

  bool read(arm::Sample& sample) noexcept override {
    ++reads_;
    sample.time_ns = time_ns_ += period_ns;
    sample.q_rad = arm::solvePosition(arm::findPreset("omni-thesis")->geometry, tip(reads_)).q_rad;
    return spoil ? spoil(reads_, sample) : true;
  }
  void write(const safety::GatedForce& force) noexcept override {
    if (seen_.forces.size() < keep_) seen_.forces.push_back(force.f_T_W());
    seen_.last_size_N = force.f_T_W().norm();
    ++seen_.writes;
    if (written) written();
  }
  void cut() noexcept override { ++seen_.cuts; }
  servo::DeviceInfo info() const override { return {"Scripted", true, false, frozen_s}; }
  Sentence fixedRateReason() const override { return takes_rates ? Sentence() : DevicePort::fixedRateReason(); }
  void setRate(int rate_hz) override { period_ns = 1'000'000'000 / rate_hz; }
  Problems reopen() override { return opens_again ? opens_again() : Problems{}; }

 private:
  Seen& seen_;
  std::size_t keep_;
  std::int64_t reads_ = 0, time_ns_ = 0;
};

}  // namespace underact::test
