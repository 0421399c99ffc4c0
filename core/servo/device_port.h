#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/arm/sample.h"
#include "core/base/real_time.h"
#include "core/base/result.h"
#include "core/safety/gate.h"

namespace underact::servo {

/// Ticks a second that a servo can be asked for.
inline constexpr int kSlowest_hz = 100, kFastest_hz = 10'000;

/// What the window says of a device.
struct DeviceInfo {
  Sentence title;  // "Simulated arm"
  bool simulated = false;
  bool untested = false;    // never tried on the hardware it is for
  double frozen_s = 0.0;    // a sample the same to the bit for so long is no hand's; 0: it may well be
  std::string serial = {};  // what tells this arm from others of its kind; empty: it has none, or it is not known here
};

/// A message to an arm that means zero force, and where to write it.
struct LastWord {
  int fd = -1;
  std::string bytes;
};

/// What an arm with a clock of its own calls once a period.
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
  /// The newest sample. false: none came in time; then zero is written.
  virtual bool read(arm::Sample& sample) noexcept UNDERACT_REAL_TIME = 0;
  /// Sends the force, N in W; it holds until the next write() or cut(). The servo thread.
  virtual void write(const safety::GatedForce& force) noexcept UNDERACT_REAL_TIME = 0;
  /// Zero force, now, from any thread, also while read() or write() is at work; it lasts until the next write(). The
  /// watchdog's way, when ticks stop.
  virtual void cut() noexcept UNDERACT_REAL_TIME = 0;
  /// Opens the arm again after it was lost; the servo thread does not run. Problems: why it cannot be opened.
  virtual Problems reopen() { return {}; }
  /// Why the servo cannot tick at another rate than the one the arm was opened for; empty: it can. The thread that owns
  /// the arm.
  virtual Sentence fixedRate() const;
  /// Why it cannot tick at that rate, where fixedRate() leaves a choice that is not free; empty: it can.
  virtual Sentence refusesRate(int /*rate_hz*/) const { return fixedRate(); }
  /// From the next read() on that many a second, and its clock goes on without a jump; the servo thread does not run.
  /// Where refusesRate() says nothing against it.
  virtual void setRate(int /*rate_hz*/) {}
  /// What writes zero force from outside this process, for an arm behind a file descriptor: a guard does so when the
  /// program dies. fd < 0: there is no such way.
  virtual LastWord lastWord() const { return {}; }
  /// An arm whose driver has a scheduler of its own drives the servo: from now until endDrive() it calls tick() once a
  /// period, in its thread, and the servo's own thread steps aside. false: it has none. The thread that owns the arm.
  virtual bool drive(Ticks& /*ticks*/, int /*rate_hz*/) { return false; }
  /// No tick() is at work any more when it returns.
  virtual void endDrive() {}
  /// What the arm's side says is wrong, in the user's words and with a way out, where read() gives no sample or no
  /// force goes out; empty: nothing. Any thread; not the tick.
  virtual Sentence trouble() const { return {}; }
  /// What the arm says of itself, a line each, for people and reports; empty: nothing more than info(). The thread that
  /// owns the arm.
  virtual std::vector<std::string> listing() const { return {}; }
  /// Any thread.
  virtual DeviceInfo info() const = 0;
};

}  // namespace underact::servo
