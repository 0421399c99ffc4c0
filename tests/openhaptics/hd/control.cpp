#include <algorithm>

#include "tests/openhaptics/hd/library.h"

namespace underact::test::hd {

void Library::placeTip(double x_m, double y_m, double z_m) {
  const std::scoped_lock lock(mutex);
  arm_.setpoint.p_WT = Vec3(x_m, y_m, z_m);
}

void Library::holdButtons(int bits) {
  const std::scoped_lock lock(mutex);
  buttons_ = bits;
}

void Library::freeze(bool on) {
  const std::scoped_lock lock(mutex);
  arm_.frozen = on;
}

void Library::plug(bool in) {
  const std::scoped_lock lock(mutex);
  plugged_ = in;
  if (in) return;
  motors_N_.setZero();  // no cable, no current
  in_frame_ = false;
}

void Library::dock(bool in) {
  const std::scoped_lock lock(mutex);
  docked_ = in;
}

void Library::needCalibration(std::uint32_t status, std::uint32_t style) {
  const std::scoped_lock lock(mutex);
  calibration_ = status;
  style_ = style;
}

void Library::shiftPosition(double x_mm) {
  const std::scoped_lock lock(mutex);
  shift_mm_ = x_mm;
}

void Library::limitContinuousForce(double force_N) {
  const std::scoped_lock lock(mutex);
  continuous_N_ = force_N;
}

void Library::haltClock(bool on) {
  const std::scoped_lock lock(mutex);
  halted_ = on;
}

void Library::inject(const char* call, int nth, std::uint32_t code, Extent extent) {
  const std::scoped_lock lock(mutex);
  plans_[call].push_back({calls_[call] + nth, code, extent, 0});
}

void Library::delay(const char* call, int nth, int time_ms) {
  const std::scoped_lock lock(mutex);
  plans_[call].push_back({calls_[call] + nth, 0, Extent::Once, time_ms});
}

void Library::storm(bool on, std::uint64_t seed) {
  const std::scoped_lock lock(mutex);
  storm_ = on;
  random_ = test::Random(test::Seed{seed});
}

void Library::reset() {
  const std::scoped_lock lock(mutex);
  arm_.setpoint.p_WT = Vec3(0.0, 0.0, 0.06);
  arm_.frozen = storm_ = halted_ = docked_ = false;
  plugged_ = true;
  buttons_ = 0;
  calibration_ = 0x5000;
  style_ = 4;
  shift_mm_ = 0.0;
  continuous_N_ = 0.88;
  plans_.clear();
  errors_.clear();
  latencies_ns_.clear();
  bad_forces_ = blind_forces_ = 0;
}

void Library::force(double* xyz_N) const {
  const std::scoped_lock lock(mutex);
  std::copy_n(motors_N_.data(), 3, xyz_N);
}

std::int64_t Library::forces() const {
  const std::scoped_lock lock(mutex);
  return forces_;
}

std::int64_t Library::pushingForces() const {
  const std::scoped_lock lock(mutex);
  return pushing_forces_;
}

std::int64_t Library::badForces() const {
  const std::scoped_lock lock(mutex);
  return bad_forces_;
}

std::int64_t Library::blindForces() const {
  const std::scoped_lock lock(mutex);
  return blind_forces_;
}

std::int64_t Library::latency_ns() const {
  const std::scoped_lock lock(mutex);
  if (latencies_ns_.empty()) return 0;
  std::vector<std::int64_t> sorted = latencies_ns_;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2), sorted.end());
  return sorted[sorted.size() / 2];
}

std::int64_t Library::calls(const char* call) const {
  const std::scoped_lock lock(mutex);
  const auto found = calls_.find(call);
  return found == calls_.end() ? 0 : found->second;
}

bool Library::isOpen() const {
  const std::scoped_lock lock(mutex);
  return is_open_;
}

int Library::rate_hz() const {
  const std::scoped_lock lock(mutex);
  return rate_hz_;
}

}  // namespace underact::test::hd
