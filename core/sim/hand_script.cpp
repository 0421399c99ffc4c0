#include "core/sim/hand_script.h"

#include <algorithm>
#include <array>

#include "core/base/random.h"
#include "core/base/trig.h"
#include "core/base/units.h"

namespace underact::sim {
namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;

/// The share of the displacement and its rate, for a share s of the time. Source: Flash and Hogan 1985.
struct Profile {
  double share;
  double rate;
};
Profile minimumJerk(double s) noexcept UNDERACT_REAL_TIME {
  return {s * s * s * (10.0 + s * (6.0 * s - 15.0)), 30.0 * s * s * (1.0 - s) * (1.0 - s)};
}

/// R_WA rotated by a share of the shortest rotation to R_WB. Not Eigen's slerp: the last bit of libm's acos and sin
/// differs between machines. For half a turn there are two shortest rotations; the choice is fixed but arbitrary.
Mat3 turned(const Mat3& R_WA, const Mat3& R_WB, double share) noexcept UNDERACT_REAL_TIME {
  Eigen::Quaterniond q_AB(R_WA.transpose() * R_WB);
  if (q_AB.w() < 0.0) q_AB.coeffs() = -q_AB.coeffs();
  const double half_sin = q_AB.vec().norm();
  if (!(half_sin > 0.0)) return R_WA;
  const SinCos half = sinCos(share * atan2Of(half_sin, q_AB.w()));
  const Vec3 vec = q_AB.vec() * (half.sin / half_sin);
  return R_WA * Eigen::Quaterniond(half.cos, vec.x(), vec.y(), vec.z()).toRotationMatrix();
}

HandSetpoint standAt(const HandPoint& point) noexcept UNDERACT_REAL_TIME {
  return {point.p_WT, Vec3::Zero(), point.R_WT, point.turns};
}

HandSetpoint onPath(const std::vector<HandPoint>& path, double t_s) noexcept UNDERACT_REAL_TIME {
  if (path.empty()) return {};
  std::size_t next = 0;
  for (std::size_t count = path.size(); count > 0;) {  // the first point later than t_s, by bisection
    const std::size_t half = count / 2;
    if (path[next + half].t_s <= t_s) {
      next += half + 1;
      count -= half + 1;
    } else {
      count = half;
    }
  }
  if (next == 0) return standAt(path.front());
  if (next == path.size()) return standAt(path.back());
  const HandPoint& from = path[next - 1];
  const HandPoint& to = path[next];
  const double leg_s = to.t_s - from.t_s;
  const Profile profile = minimumJerk((t_s - from.t_s) / leg_s);
  const Vec3 leg_W = to.p_WT - from.p_WT;
  HandSetpoint setpoint{from.p_WT + profile.share * leg_W, (profile.rate / leg_s) * leg_W, from.R_WT,
                        from.turns && to.turns};
  if (setpoint.turns) setpoint.R_WT = turned(from.R_WT, to.R_WT, profile.share);
  return setpoint;
}

/// Three sinusoids for each axis, in the range of a hand's tremor (8 to 12 Hz). All their periods divide 2 s, so time
/// is taken modulo that, and a long run is as exact as a short one.
void addTremor(const HandScript& script, std::int64_t time_ns, HandSetpoint& setpoint) noexcept UNDERACT_REAL_TIME {
  constexpr std::array<double, 3> kFrequencies_Hz{8.0, 9.5, 11.0};
  const double t_s = static_cast<double>(time_ns % (2 * kSecond_ns)) / static_cast<double>(kSecond_ns);
  const double part_m = script.tremor_m / static_cast<double>(kFrequencies_Hz.size());
  std::uint64_t state = script.seed;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double frequency_Hz : kFrequencies_Hz) {
      const double omega_rad_per_s = 2.0 * kPi * frequency_Hz;
      const SinCos wave = sinCos(omega_rad_per_s * t_s + 2.0 * kPi * nextShare(state));
      setpoint.p_WT[axis] += part_m * wave.sin;
      setpoint.v_WT[axis] += part_m * omega_rad_per_s * wave.cos;
    }
  }
}

}  // namespace

HandSetpoint setpointAt(const HandScript& script, std::int64_t time_ns) noexcept {
  std::int64_t path_ns = time_ns;
  const auto repeat_ns = static_cast<std::int64_t>(script.repeat_s * static_cast<double>(kSecond_ns));
  if (repeat_ns > 0) path_ns %= repeat_ns;
  // Divided, not multiplied by 1e-9: so a point's own time, written in decimals, is exact.
  HandSetpoint setpoint = onPath(script.path, static_cast<double>(path_ns) / static_cast<double>(kSecond_ns));
  if (script.tremor_m != 0.0) addTremor(script, time_ns, setpoint);
  return setpoint;
}

}  // namespace underact::sim
