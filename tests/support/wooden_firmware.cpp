#include "tests/support/wooden_firmware.h"

#include <algorithm>
#include <cmath>

namespace underact::test {
namespace {

constexpr double kTurn_rad = 6.283185307179586;
constexpr double kUpper_m = 0.205, kFore_m = 0.245, kFoot_m = 0.080;
constexpr double kOriginX_m = 0.220, kOriginZ_m = 0.080;
constexpr std::array<double, 3> kGear{16.0, 12.0, 12.0};  // turns of a motor a turn of its body
constexpr double kCounts = 2000.0;                        // a turn of a motor
constexpr std::int64_t kWatchdog_ns = 500'000'000;
constexpr double kInertia_kg_m2 = 0.008, kDamping_N_m_s = 0.05;  // 0.2 kg at 0.2 m; made up
constexpr double kStep_s = 1e-4;
constexpr std::int64_t kTremor_ns = 50'000'000;

// Where the counters stand in a posture, and what a current does, by protocol.
std::array<double, 3> countSigns(int protocol) {
  return protocol == 1 ? std::array<double, 3>{-1, -1, -1} : std::array<double, 3>{1, 1, 1};
}
std::array<double, 3> currentSigns(int protocol) {
  return protocol == 1 ? std::array<double, 3>{1, -1, -1} : std::array<double, 3>{1, 1, 1};
}
constexpr std::array<double, 3> kHome_rad{0.0, 0.0, kTurn_rad / 4.0};

int wordAt(std::span<const std::uint8_t> bytes, std::size_t word) {
  const int value = bytes[2 * word] + 256 * bytes[2 * word + 1];
  return value < 32768 ? value : value - 65536;
}

void setWord(std::vector<std::uint8_t>& bytes, std::size_t word, int value) {
  const int wrapped = ((value % 65536) + 65536) % 65536;
  bytes[2 * word] = static_cast<std::uint8_t>(wrapped % 256);
  bytes[2 * word + 1] = static_cast<std::uint8_t>(wrapped / 256);
}

}  // namespace

WoodenFirmware::WoodenFirmware(const Built& built) : built_(built) {
  body_rad_ = kHome_rad;
  losePower();  // plugged in as it should be: in its home posture
  if (built_.protocol == 2 && built_.is_calibrated) offset_ = {0, 0, 6000};
  placeTip(Vec3(0.0, 0.0, 0.06));
}

/// x_W is y of the source, y_W its z, z_W its x.
Vec3 WoodenFirmware::tipOf(const std::array<double, 3>& body_rad) const {
  const auto& [a, b, c] = body_rad;
  const double out_m = kUpper_m * std::sin(b) + kFore_m * std::sin(c);
  const double up_m = kFoot_m + kUpper_m * std::cos(b) - kFore_m * std::cos(c);
  return {std::sin(a) * out_m, up_m - kOriginZ_m, std::cos(a) * out_m - kOriginX_m};
}

/// By differences: the formula is the one that is looked at.
Mat3 WoodenFirmware::jacobian() const {
  constexpr double kBy_rad = 1e-5;
  Mat3 J;
  for (std::size_t body = 0; body < 3; ++body) {
    std::array<double, 3> before = body_rad_, after = body_rad_;
    before[body] -= kBy_rad, after[body] += kBy_rad;
    J.col(static_cast<Eigen::Index>(body)) = (tipOf(after) - tipOf(before)) / (2.0 * kBy_rad);
  }
  return J;
}

std::array<int, 3> WoodenFirmware::countsNow() const {
  std::array<int, 3> counts{};
  for (std::size_t body = 0; body < 3; ++body) {
    const double turns = (body_rad_[body] - kHome_rad[body]) / kTurn_rad;
    const double moved = countSigns(built_.protocol)[body] * turns * kGear[body] * kCounts;
    counts[body] = static_cast<int>(std::lround(moved)) + offset_[body];
  }
  return counts;
}

bool WoodenFirmware::isPowered(std::int64_t time_ns) const {
  return has_heard_ && time_ns - heard_ns_ < kWatchdog_ns;
}

Vec3 WoodenFirmware::torques_N_m(std::int64_t time_ns) const {
  if (!isPowered(time_ns)) return Vec3::Zero();
  Vec3 torque_N_m;
  for (std::size_t body = 0; body < 3; ++body) {
    torque_N_m[static_cast<Eigen::Index>(body)] =
        1e-3 * currents_mA_[body] * built_.torque_N_m_per_A[body] * kGear[body] * currentSigns(built_.protocol)[body];
  }
  return torque_N_m;
}

void WoodenFirmware::moveUntil(std::int64_t time_ns) {
  const double passed_s = 1e-9 * static_cast<double>(time_ns - time_ns_);
  const Vec3 torque_N_m = torques_N_m(time_ns);
  time_ns_ = time_ns;
  if (is_held_ || passed_s > 0.1) return;  // it was let go just now, or nobody has looked for long
  for (double left_s = passed_s; left_s > 0.0; left_s -= kStep_s) {
    const double dt_s = std::min(left_s, kStep_s);
    for (std::size_t body = 0; body < 3; ++body) {
      const double torque = torque_N_m[static_cast<Eigen::Index>(body)];
      rate_[body] = (rate_[body] + dt_s * torque / kInertia_kg_m2) / (1.0 + dt_s * kDamping_N_m_s / kInertia_kg_m2);
      body_rad_[body] += dt_s * rate_[body];
      joules_ += dt_s * rate_[body] * torque;
    }
  }
}

void WoodenFirmware::receive(std::span<const std::uint8_t> report, std::int64_t time_ns) {
  const std::scoped_lock lock(mutex_);
  if (report.size() != built_.report_bytes) return;
  moveUntil(time_ns);
  heard_ns_ = time_ns;
  has_heard_ = true;
  if (built_.protocol == 2 && wordAt(report, 3) == 1) {
    const std::array<int, 3> before = countsNow();
    for (std::size_t body = 0; body < 3; ++body) offset_[body] += wordAt(report, 4 + body) - before[body];
    currents_mA_ = {};
    wants_calibration_ = false;
    return;
  }
  for (std::size_t body = 0; body < 3; ++body) currents_mA_[body] = wordAt(report, body);
  for (std::size_t body = 0; body < 3 && sent_ns_ >= 0; ++body) {
    if (std::abs(currents_mA_[body] - then_mA_[body]) <= 5) continue;
    reactions_ns_.push_back(time_ns - sent_ns_);
    sent_ns_ = -1;
  }
  ++taken_;
  pushes_ += currents_mA_ != std::array<int, 3>{} ? 1 : 0;
}

std::vector<std::uint8_t> WoodenFirmware::report(std::int64_t time_ns) {
  const std::scoped_lock lock(mutex_);
  moveUntil(time_ns);
  std::vector<std::uint8_t> bytes(built_.report_bytes, 0);
  std::array<int, 3> counts = countsNow();
  counts[0] += static_cast<int>(time_ns / kTremor_ns % 2);  // no hand is still
  for (std::size_t body = 0; body < 3; ++body) setWord(bytes, body, counts[body]);
  if (built_.protocol == 2) {
    setWord(bytes, 3, button_ ? 10'000 : 0);
    setWord(bytes, 6, wants_calibration_ ? 1 : 0);
  }
  if (is_placed_) {
    sent_ns_ = time_ns;
    then_mA_ = currents_mA_;
  }
  is_placed_ = false;
  if (!is_frozen_ || frozen_.empty()) frozen_ = bytes;
  return frozen_;
}

void WoodenFirmware::placeTip(const Vec3& p_WT) {
  const std::scoped_lock lock(mutex_);
  body_rad_ = {std::atan2(p_WT.x(), p_WT.z() + kOriginX_m), 0.35, 0.65};
  for (int round = 0; round < 20; ++round) {  // Newton, from the middle of the workspace
    const Vec3 step_rad = jacobian().fullPivLu().solve(p_WT - tipOf(body_rad_));
    for (std::size_t body = 0; body < 3; ++body) body_rad_[body] += step_rad[static_cast<Eigen::Index>(body)];
  }
  rate_ = {};
  is_held_ = true;
  is_placed_ = true;
}

void WoodenFirmware::letGo() {
  const std::scoped_lock lock(mutex_);
  is_held_ = false;
  joules_ = 0.0;
}

Vec3 WoodenFirmware::tip() const {
  const std::scoped_lock lock(mutex_);
  return tipOf(body_rad_);
}

void WoodenFirmware::holdButton(bool held) {
  const std::scoped_lock lock(mutex_);
  button_ = held;
}

void WoodenFirmware::freeze(bool on) {
  const std::scoped_lock lock(mutex_);
  is_frozen_ = on;
}

void WoodenFirmware::pressCalibration() {
  const std::scoped_lock lock(mutex_);
  body_rad_ = kHome_rad;
  wants_calibration_ = true;
}

void WoodenFirmware::losePower() {
  const std::scoped_lock lock(mutex_);
  offset_ = {};
  const std::array<int, 3> counts = countsNow();
  for (std::size_t body = 0; body < 3; ++body) offset_[body] = -counts[body];
  currents_mA_ = {};
  has_heard_ = false;
}

Vec3 WoodenFirmware::force_N(std::int64_t time_ns) const {
  const std::scoped_lock lock(mutex_);
  return jacobian().transpose().fullPivLu().solve(torques_N_m(time_ns));
}

std::array<int, 3> WoodenFirmware::currents_mA(std::int64_t time_ns) const {
  const std::scoped_lock lock(mutex_);
  return isPowered(time_ns) ? currents_mA_ : std::array<int, 3>{};
}

std::int64_t WoodenFirmware::currentsTaken() const {
  const std::scoped_lock lock(mutex_);
  return taken_;
}

std::int64_t WoodenFirmware::pushes() const {
  const std::scoped_lock lock(mutex_);
  return pushes_;
}

std::vector<std::int64_t> WoodenFirmware::reactions_ns() const {
  const std::scoped_lock lock(mutex_);
  return reactions_ns_;
}

double WoodenFirmware::joules() const {
  const std::scoped_lock lock(mutex_);
  return joules_;
}

}  // namespace underact::test
