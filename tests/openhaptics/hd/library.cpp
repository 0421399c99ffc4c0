#include "tests/openhaptics/hd/library.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace underact::test::hd {
namespace {

constexpr std::int64_t kMaxLatencies = 100'000;

std::int64_t now_ns() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

}  // namespace

Library& Library::the() {
  static Library* const the_one = new Library;  // its clock may outlive main()
  return *the_one;
}

Library::Entry Library::enter(const char* call) {
  const std::int64_t number = ++calls_[call];
  Entry entry;
  for (const Plan& plan : plans_[call]) {
    const bool hits = plan.extent == Extent::Once ? number == plan.at : number >= plan.at;
    if (!hits) continue;
    entry.delay_ms = std::max(entry.delay_ms, plan.delay_ms);
    if (plan.code == 0) continue;
    entry.fails = true;
    push(plan.code);
  }
  // hdGetError is how errors are seen: it makes none, or the stack would have no end.
  if (storm_ && std::string(call) != "hdGetError" && random_.between(0.0, 1.0) < 0.02) push(randomCode());
  return entry;
}

ErrorInfo Library::pop() {
  if (errors_.empty()) return {0, 0, kNoDevice};
  const std::uint32_t code = errors_.front();
  errors_.pop_front();
  return {code, -1, kTheDevice};
}

std::uint32_t Library::init() {
  if (!plugged_) {
    push(0x302);
    return kNoDevice;
  }
  if (is_open_) {
    push(0x301);
    return kNoDevice;
  }
  is_open_ = true;
  return kTheDevice;
}

void Library::disable() {
  is_open_ = force_is_on_ = false;
  motors_N_.setZero();
}

void Library::switchForce(bool on) {
  if (isGone()) return push(0x104);
  force_is_on_ = on;
  if (!on) motors_N_.setZero();
}

void Library::beginFrame() {
  if (isGone()) return push(0x302);
  if (in_frame_) push(0x400);
  in_frame_ = true;
  has_pending_ = blind_ = false;
  last_buttons_ = shown_buttons_;
  shown_buttons_ = buttons_;
  angles_ = arm_.deviceAngles();
  frame_began_ns_ = now_ns();
}

void Library::endFrame() {
  if (isGone()) return push(0x302);
  if (!in_frame_) return push(0x401);
  in_frame_ = false;
  if (!has_pending_) return;
  ++forces_;
  const double size_N = pending_N_.norm();
  const double limit_N = continuous_N_ > 0.0 && continuous_N_ < 0.88 ? continuous_N_ : 0.88;
  if (!(size_N <= limit_N * (1.0 + 1e-12))) ++bad_forces_;
  if (size_N != 0.0) ++pushing_forces_;
  if (blind_ && size_N != 0.0) ++blind_forces_;
  if (force_is_on_) motors_N_ = pending_N_;
  if (static_cast<std::int64_t>(latencies_ns_.size()) < kMaxLatencies)
    latencies_ns_.push_back(now_ns() - frame_began_ns_);
}

void Library::setForce(const double* force_N) {
  if (!in_frame_) return push(0x102);
  pending_N_ = Vec3(force_N[0], force_N[1], force_N[2]);
  has_pending_ = true;
}

bool Library::get(std::uint32_t parameter, double* values) {
  const bool is_state = parameter < 0x2500;
  if (is_state && !in_frame_) return false;
  switch (parameter) {
    case 0x2000:
      values[0] = shown_buttons_;
      return true;
    case 0x2200:
      values[0] = last_buttons_;
      return true;
    case 0x2002:
      values[0] = docked_ ? 0.0 : 1.0;
      return true;
    case 0x2010:
      for (std::size_t i = 0; i < 6; ++i)
        values[i] = std::round(angles_[i] * arm_.plant.arm.counts_per_turn[i] / 6.283185307179586);
      return true;
    case 0x2050: {
      const std::array<double, 3> p_mm = Arm::position_mm(angles_);
      std::copy(p_mm.begin(), p_mm.end(), values);
      values[0] += shift_mm_;
      return true;
    }
    case 0x2051:
      for (int i = 0; i < 3; ++i) values[i] = 1e3 * arm_.state.v_WT[i];
      return true;
    case 0x2052: {
      // Ry(-q1) Rx(-q3) Ry(g1) Rx(-g2) Rz(-g3) of the facts, columns first.
      const auto turn = [](double angle, const Vec3& axis) { return Eigen::AngleAxisd(angle, axis); };
      const Mat3 R =
          (turn(-angles_[0], Vec3::UnitY()) * turn(-angles_[2], Vec3::UnitX()) * turn(angles_[3], Vec3::UnitY()) *
           turn(-angles_[4], Vec3::UnitX()) * turn(-angles_[5], Vec3::UnitZ()))
              .toRotationMatrix();
      const std::array<double, 3> p_mm = Arm::position_mm(angles_);
      for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) values[4 * column + row] = R(row, column);
      }
      std::copy(p_mm.begin(), p_mm.end(), values + 12);
      values[15] = 1.0;
      return true;
    }
    case 0x2100:
      std::copy_n(angles_.begin(), 3, values);
      return true;
    case 0x2150:
      std::copy_n(angles_.begin() + 3, 3, values);
      return true;
    case 0x2505:
      values[0] = 192.0;
      return true;
    case 0x2550:
    case 0x2551: {
      const std::array<double, 6> corners{-210.0, -110.0, -85.0, 210.0, 205.0, 130.0};
      std::copy(corners.begin(), corners.end(), values);
      return true;
    }
    case 0x2552:
      values[0] = 110.0;
      return true;
    case 0x2553:
      values[0] = 6.0;
      return true;
    case 0x2554:
      values[0] = 3.0;
      return true;
    case 0x2555:
      values[0] = style_;
      return true;
    case 0x2600:
    case 0x2601:
      values[0] = rate_hz_;
      return true;
    case 0x2602:
      values[0] = 0.5;
      return true;
    case 0x2603:
      values[0] = 3.3;
      return true;
    case 0x2604:
      values[0] = continuous_N_;
      return true;
    case 0x2605:
      std::fill_n(values, 6, 0.25);
      return true;
    case 0x2606:
      values[0] = 1000.0;
      return true;
    case 0x2607:
      values[0] = 0.4;
      return true;
    case 0x2608:
      values[0] = 40.0;
      return true;
    case 0x2609:
      values[0] = 0.003;
      return true;
    default:
      return false;
  }
}

const char* Library::text(std::uint32_t parameter) {
  switch (parameter) {
    case 0x2500:
      return "3.4";
    case 0x2501:
      return "Touch";
    case 0x2502:
      return "stand-in";
    case 0x2503:
      return "Underact's tests";
    case 0x2504:
      return "0042\n";
    default:
      push(0x100);
      return nullptr;
  }
}

void Library::updateCalibration(std::uint32_t style) {
  if (isGone()) return push(0x302);
  if (style == style_ && (calibration_ == 0x5001 || style == 1)) calibration_ = 0x5000;
}

double Library::randomNumber() {
  switch (random_.below(6)) {
    case 0:
      return std::nan("");
    case 1:
      return HUGE_VAL;
    case 2:
      return -HUGE_VAL;
    case 3:
      return random_.between(-1e300, 1e300);
    case 4:
      return 0.0;
    default:
      return random_.between(-10.0, 10.0);
  }
}

std::uint32_t Library::randomCode() {
  constexpr std::array<std::uint32_t, 24> kCodes{0x100, 0x101, 0x102, 0x103, 0x104, 0x200,  0x201,      0x202,
                                                 0x203, 0x204, 0x300, 0x301, 0x302, 0x303,  0x304,      0x400,
                                                 0x401, 0x402, 0x500, 0x501, 0x600, 0x7777, 0xFFFFFFFF, 0x200};
  return kCodes[random_.below(kCodes.size())];
}

}  // namespace underact::test::hd
