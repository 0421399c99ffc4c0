#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/arm/sample.h"
#include "core/base/real_time.h"
#include "core/base/result.h"
#include "core/safety/gate.h"

namespace underact::servo {

/// The range of servo rates.
inline constexpr int kSlowest_hz = 100, kFastest_hz = 10'000;

/// What is known of a device.
struct DeviceInfo {
  Sentence title;  // "Simulated arm"
  bool simulated = false;
  bool untested = false;    // never run with the hardware it is for
  double frozen_s = 0.0;    // bit-identical samples for so long mean a frozen arm; 0: they may be normal
  std::string serial = {};  // tells this arm from others of its kind; empty: none, or unknown
};

/// The message that tells an arm zero force, and where to write it.
struct ZeroForceMessage {
  int fd = -1;
  std::string bytes;
};

/// What a simulated arm knows of the last read() and no real arm says.
struct Truth {
  Vec3 p_WT = Vec3::Zero();        // the tip, m, without encoders
  Vec3 f_hand_T_W = Vec3::Zero();  // of the hand's spring and damper on the tip, N; its mass moves with the tip
};

/// Called once a period by an arm with a clock of its own.
class Ticks {
 public:
  /// One tick; the arm's thread, never two at once.
  virtual void tick() noexcept UNDERACT_REAL_TIME = 0;

 protected:
  ~Ticks() = default;
};

/// An arm. Constructed open, destroyed closed, both outside the servo thread.
class DevicePort {
 public:
  virtual ~DevicePort() = default;
  /// The newest sample; waits at most two periods. false: none came in time; then zero is written.
  virtual bool read(arm::Sample& sample) noexcept UNDERACT_REAL_TIME = 0;
  /// Sends the force, N in W; it holds until the next write() or cut(). The servo thread.
  virtual void write(const safety::GatedForce& force) noexcept UNDERACT_REAL_TIME = 0;
  /// What a simulated arm knows of the last read(); false: a real one. The servo thread, after read().
  virtual bool truth(Truth& /*truth*/) const noexcept UNDERACT_REAL_TIME { return false; }
  /// Zero force, now, from any thread, also during read() or write(); it lasts until the next write(). Called by the
  /// watchdog when ticks stop.
  virtual void cut() noexcept UNDERACT_REAL_TIME = 0;
  /// Opens a lost arm again; the servo thread does not run meanwhile. Problems: why it cannot be opened.
  virtual Problems reopen() { return {}; }
  /// Why the rate is fixed to that with which the arm was opened; empty: it is not. The thread that owns the arm.
  virtual Sentence fixedRateReason() const;
  /// Why this rate is not possible, where some others are; empty: it is.
  virtual Sentence rateRefusal(int /*rate_hz*/) const { return fixedRateReason(); }
  /// Changes the rate from the next read() on; the arm's clock goes on without a jump. Only where rateRefusal() is
  /// empty, and while the servo thread does not run.
  virtual void setRate(int /*rate_hz*/) {}
  /// The message of zero force, for an arm behind a file descriptor: a guard sends it when the program dies. fd < 0:
  /// there is none.
  virtual ZeroForceMessage zeroForceMessage() const { return {}; }
  /// For an arm whose driver has a scheduler of its own: until endDrive() it calls tick() once a period, in its thread,
  /// and the servo's own thread is not used. false: it has none. The thread that owns the arm.
  virtual bool drive(Ticks& /*ticks*/, int /*rate_hz*/) { return false; }
  /// Ends drive(); no tick() runs any more when it returns.
  virtual void endDrive() {}
  /// What the device reports as wrong, in the user's words and with a way out, where read() gives no sample or no force
  /// goes out; empty: nothing. Any thread; not in the tick.
  virtual Sentence trouble() const { return {}; }
  /// Details of the arm, a line each, for people and reports; empty: nothing beyond info(). The thread that owns the
  /// arm.
  virtual std::vector<std::string> listing() const { return {}; }
  /// Any thread.
  virtual DeviceInfo info() const = 0;
};

}  // namespace underact::servo
