#include "core/identify/press.h"

#include <algorithm>
#include <cmath>

#include "core/base/translate.h"

namespace underact::identify {
namespace {

constexpr double kLookBack_s = 0.1;    // over which a direction is determined ...
constexpr double kMoved_m = 0.1e-3;    // ... two encoder steps
constexpr double kTouched_m = 0.1e-3;  // from which on it counts as pressed
constexpr std::size_t kMinRowsEachWay = 50;

/// Least squares of force over displacement.
class Line {
 public:
  void add(double x_m, double f_N) {
    ++count_;
    x_ += x_m, f_ += f_N, xx_ += x_m * x_m, xf_ += x_m * f_N, ff_ += f_N * f_N;
  }
  std::size_t count() const { return static_cast<std::size_t>(count_); }
  double slope() const { return (xf_ - x_ * f_ / count_) / (xx_ - x_ * x_ / count_); }
  double at(double x_m) const { return f_ / count_ + slope() * (x_m - x_ / count_); }
  double middle_m() const { return x_ / count_; }
  double squares() const { return std::max(0.0, ff_ - f_ * f_ / count_ - slope() * (xf_ - x_ * f_ / count_)); }
  double uncertainty() const { return std::sqrt(squares() / std::max(1.0, count_ - 2.0) / (xx_ - x_ * x_ / count_)); }

 private:
  double count_ = 0.0, x_ = 0.0, f_ = 0.0, xx_ = 0.0, xf_ = 0.0, ff_ = 0.0;
};

}  // namespace

Result<Press> pressOf(std::span<const MotionRow> rows, const Vec3& along_W, double period_s) {
  const auto look = static_cast<std::size_t>(std::lround(kLookBack_s / period_s));
  const auto wayAt = [&](std::size_t row) { return (rows[row].p_WT - rows[row].p_WP).dot(along_W); };
  Line down, up;
  Press press;
  for (std::size_t row = look; row + look < rows.size(); ++row) {
    const double x_m = wayAt(row), f_N = -rows[row].f_T_W.dot(along_W);
    if (!(x_m > kTouched_m)) continue;
    press.max_N = std::max(press.max_N, f_N);
    if (rows[row].is_cut) {
      press.clamped_at_m = std::min(press.clamped_at_m.value_or(x_m), x_m);
      continue;
    }
    press.linear_m = std::max(press.linear_m, x_m);
    const double moved_m = wayAt(row + look) - wayAt(row - look);
    if (std::abs(moved_m) > kMoved_m) (moved_m > 0.0 ? down : up).add(x_m, f_N);
  }
  if (down.count() < kMinRowsEachWay || up.count() < kMinRowsEachWay)
    return Problems{
        {phrase(TRANSLATE_NOOP("problem",
                               "The stylus was not pressed down and let back slowly. Press it down by about "
                               "3 mm in two seconds, and let it come back just as slowly."))}};
  press.down_N_per_m = down.slope();
  press.up_N_per_m = up.slope();
  const double middle_m = 0.5 * (down.middle_m() + up.middle_m());
  press.hysteresis_N = down.at(middle_m) - up.at(middle_m);
  press.residual_N = std::sqrt((down.squares() + up.squares()) / static_cast<double>(down.count() + up.count()));
  const double of_lines = 0.5 * std::hypot(down.uncertainty(), up.uncertainty());
  press.stiffness_N_per_m = {0.5 * (press.down_N_per_m + press.up_N_per_m),
                             std::max(of_lines, 0.5 * std::abs(press.down_N_per_m - press.up_N_per_m))};
  return press;
}

}  // namespace underact::identify
