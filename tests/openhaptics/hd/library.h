#pragma once
#include <array>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "core/sim/plant.h"
#include "tests/openhaptics/hd/control.h"
#include "tests/support/random.h"

// A stand-in for the vendor's library: its 36 calls, a scheduler in a thread of its own, and a simulated arm at the end
// of the cable. It is as unkind as the facts allow: a force stays at the motors until another one comes.
namespace underact::test::hd {

inline constexpr std::uint32_t kNoDevice = 0xFFFFFFFF;
inline constexpr std::uint32_t kTheDevice = 7;

struct ErrorInfo {
  std::uint32_t code;
  std::int32_t internal;
  std::uint32_t device;
};

/// The arm at the end of the cable.
class Arm {
 public:
  Arm();
  void advance(std::int64_t period_ns);
  std::array<double, 6> deviceAngles();  // through its encoders, with a tremor of one step
  /// mm, by the lengths and the device's own angles; written down once more, not taken from core/arm.
  static std::array<double, 3> position_mm(const std::array<double, 6>& angles);

  sim::Plant plant;
  sim::PlantState state;
  sim::HandSetpoint setpoint;
  Vec3 f_T_W = Vec3::Zero();
  bool frozen = false;  // the last angles, for ever
  std::int64_t periods = 0;

 private:
  std::array<double, 6> shown_{};
};

using Callback = std::uint32_t (*)(void*);

class Library final : public Control {
 public:
  static Library& the();

  void placeTip(double x_m, double y_m, double z_m) override;
  void holdButtons(int bits) override;
  void freeze(bool on) override;
  void plug(bool in) override;
  void dock(bool in) override;
  void needCalibration(std::uint32_t status, std::uint32_t style) override;
  void shiftPosition(double x_mm) override;
  void limitContinuousForce(double force_N) override;
  void haltClock(bool on) override;
  void inject(const char* call, int nth, std::uint32_t code, Extent extent) override;
  void delay(const char* call, int nth, int time_ms) override;
  void storm(bool on, std::uint64_t seed) override;
  void reset() override;
  void force(double* xyz_N) const override;
  std::int64_t forces() const override;
  std::int64_t pushingForces() const override;
  std::int64_t badForces() const override;
  std::int64_t blindForces() const override;
  std::int64_t latency_ns() const override;
  std::int64_t calls(const char* call) const override;
  bool isOpen() const override;
  int rate_hz() const override;

  // The calls; exports.cpp counts them, fails them, and holds the lock.
  struct Entry {
    bool fails = false;
    int delay_ms = 0;
  };
  Entry enter(const char* call);
  void push(std::uint32_t code) { errors_.push_back(code); }
  ErrorInfo pop();
  std::uint32_t init();
  void disable();
  void beginFrame();
  void endFrame();
  void dropForce() { has_pending_ = false; }
  void setForce(const double* force_N);
  void switchForce(bool on);
  bool forceIsOn() const { return force_is_on_; }
  std::uint32_t current() const { return is_open_ ? kTheDevice : kNoDevice; }
  /// Fills values for a parameter in the unit of the library; false: there is no such.
  bool get(std::uint32_t parameter, double* values);
  const char* text(std::uint32_t parameter);
  void updateCalibration(std::uint32_t style);
  std::uint32_t calibrationStatus() const { return plugged_ ? calibration_ : 0; }
  std::uint32_t calibrationStyle() const { return style_; }
  bool isRandom() { return storm_ && random_.between(0.0, 1.0) < 0.1; }
  double randomNumber();
  std::uint32_t randomCode();
  void sawNoNumber() { blind_ = true; }

  bool setRate(unsigned long rate_hz);
  unsigned long schedule(Callback callback, void* self, std::uint16_t priority);
  void unschedule(unsigned long handle);
  bool isScheduled(unsigned long handle) const;
  void startClock(std::unique_lock<std::mutex>& lock);
  void stopClock(std::unique_lock<std::mutex>& lock);

  mutable std::mutex mutex;

 private:
  struct Plan {
    std::int64_t at = 0;  // the number of the call
    std::uint32_t code = 0;
    Extent extent = Extent::Once;
    int delay_ms = 0;
  };
  struct Task {
    unsigned long handle;
    Callback callback;
    void* self;
    std::uint16_t priority;
  };
  Library() = default;
  void run();
  std::vector<Task> tasks() const;
  bool isGone() const { return !is_open_ || !plugged_; }

  Arm arm_;
  bool plugged_ = true, docked_ = false, is_open_ = false, force_is_on_ = false, in_frame_ = false;
  int buttons_ = 0, shown_buttons_ = 0, last_buttons_ = 0;
  std::uint32_t calibration_ = 0x5000, style_ = 4;
  double shift_mm_ = 0.0, continuous_N_ = 0.88;
  std::array<double, 6> angles_{};
  Vec3 pending_N_ = Vec3::Zero(), motors_N_ = Vec3::Zero();
  bool has_pending_ = false, blind_ = false;
  std::int64_t forces_ = 0, pushing_forces_ = 0, bad_forces_ = 0, blind_forces_ = 0, frame_began_ns_ = 0;
  std::vector<std::int64_t> latencies_ns_;

  std::deque<std::uint32_t> errors_;
  std::map<std::string, std::int64_t> calls_;
  std::map<std::string, std::vector<Plan>> plans_;
  bool storm_ = false;
  test::Random random_{test::Seed{1}};

  std::map<unsigned long, Task> tasks_;
  unsigned long next_handle_ = 1;
  int rate_hz_ = 1000;
  bool runs_ = false, halted_ = false;
  std::condition_variable wake_;
  std::thread clock_;
};

}  // namespace underact::test::hd
