#pragma once
#include <cstdint>

// How a test reaches into the stand-in for the vendor's library: by the one name that it exports besides the 36.
namespace underact::test::hd {

/// Once: at that call. Lasting: at it and every one after it.
enum class Extent : std::uint8_t { Once, Lasting };

class Control {
 public:
  // The arm.
  virtual void placeTip(double x_m, double y_m, double z_m) = 0;
  virtual void holdButtons(int bits) = 0;
  virtual void freeze(bool on) = 0;  // the last sample, for ever
  virtual void plug(bool in) = 0;
  virtual void dock(bool in) = 0;  // the stylus in the inkwell
  /// status: 0x5000 and on; style: 1, 2, 4.
  virtual void needCalibration(std::uint32_t status, std::uint32_t style) = 0;
  virtual void shiftPosition(double x_mm) = 0;  // of what the driver says of the tip, not of the angles
  virtual void limitContinuousForce(double force_N) = 0;
  virtual void haltClock(bool on) = 0;  // the scheduler calls nobody

  // What goes wrong.
  /// The nth of these calls from now on (1: the next) pushes the error and does nothing, and its results are no
  /// numbers.
  virtual void inject(const char* call, int nth, std::uint32_t code, Extent extent) = 0;
  /// The nth of these calls from now on takes so long.
  virtual void delay(const char* call, int nth, int time_ms) = 0;
  /// Each result is random in a tenth of the calls, and each call pushes a random error in a fiftieth.
  virtual void storm(bool on, std::uint64_t seed) = 0;
  virtual void reset() = 0;  // all of the above as at first; the arm stays open where it is

  // What is seen at the arm.
  /// Of the motors now, N.
  virtual void force(double* xyz_N) const = 0;
  /// Forces that came since the library was loaded.
  virtual std::int64_t forces() const = 0;
  virtual std::int64_t pushingForces() const = 0;  // of these, those that were not zero
  /// Forces that were no number or above the limit since reset().
  virtual std::int64_t badForces() const = 0;
  /// Frames since reset() in which an angle that was no number was given, and a force that is not zero came back.
  virtual std::int64_t blindForces() const = 0;
  /// Nanoseconds from a sample given to its force taken, the median since reset(); 0: none.
  virtual std::int64_t latency_ns() const = 0;
  virtual std::int64_t calls(const char* call) const = 0;
  virtual bool isOpen() const = 0;
  virtual int rate_hz() const = 0;

 protected:
  ~Control() = default;
};

inline constexpr const char* kControlName = "underactHdControl";
using FindControl = Control* (*)();

}  // namespace underact::test::hd
