#include "core/identify/swing.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace underact::identify {
namespace {

constexpr double kEven = 0.2;  // a share of the period by which samples may lie beside it
constexpr std::size_t kMinRows = 20;
constexpr double kStep_m = 0.055e-3;                       // of the encoders of the arms known, at the tip
constexpr double kTold_m = 8.0 * kStep_m;                  // a way that has a direction
constexpr double kShortest_s = 0.004, kLongest_s = 0.016;  // over which it is looked for, before and after

/// The share of the motion along along_W at a row, from as many rows about it as a direction needs; where the tip
/// hardly moves, 1. A motion across it of one encoder step counts as none.
double shareAt(std::span<const MotionRow> rows, const Vec3& along_W, double period_s, std::size_t row) {
  double along_m = 0.0, across_m = 0.0;
  for (double look_s = kShortest_s; look_s <= kLongest_s; look_s *= 2.0) {
    const auto look = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(look_s / period_s)));
    const std::size_t before = row < look ? 0 : row - look, after = std::min(rows.size() - 1, row + look);
    const Vec3 travel_W = rows[after].p_WT - rows[before].p_WT;
    along_m = std::abs(travel_W.dot(along_W));
    across_m = (travel_W - travel_W.dot(along_W) * along_W).norm();
    if (along_m + across_m > kTold_m) break;
  }
  if (!(along_m + across_m > kTold_m) || across_m <= kStep_m) return 1.0;
  return along_m / std::sqrt(along_m * along_m + across_m * across_m - kStep_m * kStep_m);
}

Window windowOf(std::span<const MotionRow> rows, const Vec3& along_W, double period_s, std::size_t first) {
  Window window;
  window.period_s = period_s;
  window.first_row = first;
  const Vec3 p_WOrigin = rows.front().p_WT;
  window.origin_m = p_WOrigin.dot(along_W);
  for (std::size_t index = 0; index < rows.size(); ++index) {
    const MotionRow& row = rows[index];
    window.friction_share.push_back(shareAt(rows, along_W, period_s, index));
    window.travel_m.push_back((row.p_WT - p_WOrigin).dot(along_W));
    window.target_m.push_back((row.p_WP - p_WOrigin).dot(along_W));
    window.force_N.push_back(row.f_T_W.dot(along_W));
    window.is_cut.push_back(row.is_cut);
  }
  return window;
}

}  // namespace

MotionRow rowOf(const servo::TickRecord& record) {
  return {record.time_ns, record.q_rad, record.p_WT, record.p_WP, record.f_sent_T_W, record.cut_N > 0.0};
}

std::vector<Window> windowsOf(std::span<const MotionRow> rows, const Vec3& along_W, double period_s, double seconds) {
  std::vector<Window> windows;
  const double length = std::round(seconds / period_s);
  const auto isNext = [&](std::size_t row) {
    const double step_s = kSecondPerNanosecond * static_cast<double>(rows[row].time_ns - rows[row - 1].time_ns);
    return std::abs(step_s - period_s) < kEven * period_s && rows[row].p_WP == rows[row - 1].p_WP;
  };
  std::size_t swing = 0;
  for (std::size_t from = 0, to = 1; from < rows.size(); from = to, ++to) {
    if (from > 0 && !isNext(from)) ++swing;
    while (to < rows.size() && static_cast<double>(to - from) < length && isNext(to)) ++to;
    if (to - from < kMinRows) continue;
    Window window = windowOf(rows.subspan(from, to - from), along_W, period_s, from);
    window.swing = swing;
    const auto [min, max] = std::minmax_element(window.travel_m.begin(), window.travel_m.end());
    if (*max - *min >= kMinTravel_m) windows.push_back(std::move(window));
  }
  return windows;
}

}  // namespace underact::identify
