#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/arm/sample.h"
#include "core/base/types.h"
#include "core/servo/snapshot.h"

namespace underact::identify {

/// The part of a tick that the measurement keeps.
struct MotionRow {
  std::int64_t time_ns = 0;  // of the sample
  arm::JointAngles q_rad{};
  Vec3 p_WT = Vec3::Zero();
  Vec3 p_WP = Vec3::Zero();   // the target
  Vec3 f_T_W = Vec3::Zero();  // sent: in effect until the next sample
  bool is_cut = false;        // the gate took something off
};

/// is_cut: where the gate took off more than 0 N.
MotionRow rowOf(const servo::TickRecord& record);

/// A stretch of a motion along one direction, its samples evenly spaced.
struct Window {
  double period_s = 0.0;
  std::size_t first_row = 0;
  std::size_t swing = 0;  // windows of one swing have the same number; a move of the target begins another
  double origin_m = 0.0;  // of way and target, along the direction from W's origin
  std::vector<double> travel_m;
  std::vector<double> target_m;
  std::vector<double> force_N;         // at index i: from sample i to i + 1
  std::vector<double> friction_share;  // of the friction along the direction seen: |v along| / |v|
  std::vector<bool> is_cut;
};

/// The rows in windows of `seconds`, projected on along_W (length 1), without those in which the tip hardly moves; no
/// window spans a gap between two samples or a move of the target. period_s: of the servo.
std::vector<Window> windowsOf(std::span<const MotionRow> rows, const Vec3& along_W, double period_s,
                              double seconds = 0.25);

// Windows in which the tip moves less are left out: ten encoder steps of the known arms.
inline constexpr double kMinTravel_m = 0.5e-3;

}  // namespace underact::identify
