#include <atomic>
#include <mutex>

#include "core/sim/arm_model.h"
#include "device/chosen_arm.h"
#include "device/replayed_arm.h"
#include "device/simulated_arm.h"
#include "tests/contract/drivers.h"

namespace underact::test {
namespace {

/// What its motors are told; the port in front of it may be gone.
struct Motors {
  mutable std::mutex mutex;
  Vec3 f_N = Vec3::Zero();
  std::atomic<std::int64_t> forces{0};
  void take(const Vec3& force_N) {
    const std::scoped_lock lock(mutex);
    f_N = force_N;
    ++forces;
  }
};

/// The simulated arm, with an eye on its border.
class Watched final : public servo::DevicePort {
 public:
  Watched(const device::SimulatedArm::Options& options, Motors& motors) : arm_(options), motors_(motors) {}
  ~Watched() override { motors_.take(Vec3::Zero()); }  // an arm that is gone pushes nobody
  device::SimulatedArm& arm() { return arm_; }

  bool read(arm::Sample& sample) noexcept override { return arm_.read(sample); }
  void write(const safety::GatedForce& force) noexcept override {
    motors_.take(force.f_T_W());
    arm_.write(force);
  }
  void cut() noexcept override {
    motors_.take(Vec3::Zero());
    arm_.cut();
  }
  servo::DeviceInfo info() const override { return arm_.info(); }
  Sentence fixedRateReason() const override { return arm_.fixedRateReason(); }
  void setRate(int rate_hz) override { arm_.setRate(rate_hz); }

 private:
  device::SimulatedArm arm_;
  Motors& motors_;
};

/// Chosen in another one's place, and behind the replayed arm.
std::unique_ptr<servo::DevicePort> asInTheWindow(std::unique_ptr<servo::DevicePort> arm,
                                                 const device::SimulatedArm::Options& options) {
  auto chosen = std::make_unique<device::ChosenArm>(std::make_unique<device::SimulatedArm>(options));
  chosen->choose(std::move(arm));
  chosen->reopen();
  return std::make_unique<device::ReplayedArm>(std::move(chosen), options.rate_hz);
}

class SimulatedFarSide final : public FarSide {
 public:
  explicit SimulatedFarSide(bool replayed) : replayed_(replayed) {}
  Result<std::unique_ptr<servo::DevicePort>> open() override {
    device::SimulatedArm::Options options;
    options.arm = *arm::findPreset(arm::kDefaultArm);
    options.model = *sim::findArmModel(sim::kDefaultArmModel);
    auto watched = std::make_unique<Watched>(options, motors_);
    arm_ = &watched->arm();
    std::unique_ptr<servo::DevicePort> port = std::move(watched);
    if (replayed_) port = asInTheWindow(std::move(port), options);
    return port;
  }
  Vec3 force_N() const override {
    const std::scoped_lock lock(motors_.mutex);
    return motors_.f_N;
  }
  std::int64_t forces() const override { return motors_.forces; }
  void placeTip(const Vec3& p_WT) override { arm_->setSetpoint({p_WT, Vec3::Zero(), Mat3::Identity(), false}); }
  void holdButton(bool held) override { arm_->holdButton(held); }
  bool hasCable() const override { return false; }
  bool mustMove() const override { return false; }
  double resolution_m() const override { return 2e-3; }  // its friction over the stiffness of the hand, 0.26 / 300

 private:
  bool replayed_;
  Motors motors_;
  device::SimulatedArm* arm_ = nullptr;
};

}  // namespace

std::unique_ptr<FarSide> simulatedFarSide(std::string& /*why*/) {
  return std::make_unique<SimulatedFarSide>(false);
}

std::unique_ptr<FarSide> replayedFarSide(std::string& /*why*/) {
  return std::make_unique<SimulatedFarSide>(true);
}

}  // namespace underact::test
