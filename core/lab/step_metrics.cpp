#include "core/lab/step_metrics.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/base/types.h"
#include "core/base/units.h"
#include "core/lab/unit_step.h"

namespace underact::lab {
namespace {

constexpr double kGone = 1e-14;     // relative to the final value; a mode below it is ignored
constexpr double kTold = 1e-9;      // relative to the level sought; a mode below it adds no peak or crossing
constexpr double kLargest = 1e18;   // of a mode's share; with equal poles it would be infinite, and they cancel
constexpr double kPerTurn = 32.0;   // samples in a period of the fastest mode left
constexpr int kBlock = 64;          // steps from one exact state to the next
constexpr int kMaxBlocks = 10'000;  // 640,000 samples
constexpr int kSwings = 200;        // of the slowest undamped mode, if several beat against each other

/// A mode of the response: at most share e^(-decay t) of the final value.
struct Mode {
  double share;
  double decay_per_s;
  double speed_rad_per_s;
};

std::vector<Mode> modesOf(const TransferFunction& transfer) {
  const double final_value = gainAtRest(transfer);
  std::vector<double> slope;
  for (std::size_t index = 0; index + 1 < transfer.den.size(); ++index)
    slope.push_back(transfer.den[index] * static_cast<double>(transfer.den.size() - 1 - index));
  const bool swings = behaviourOf(transfer) == Behaviour::Swings;
  std::vector<Mode> modes;
  for (const Complex& pole : poles(transfer)) {
    const double share = std::abs(valueAt(transfer.num, pole) / (pole * valueAt(slope, pole) * final_value));
    const bool on_axis = swings && std::abs(pole.real()) <= 1e-9 * std::abs(pole);
    modes.push_back({share < kLargest ? share : kLargest, on_axis ? 0.0 : -pole.real(), std::abs(pole)});
  }
  return modes;
}

/// An interval in which the response is monotonic. z: its value, relative to the final one, less 1.
struct Piece {
  double from_s, to_s, z_from, z_to;
};

/// Searches a response interval by interval.
class Search {
 public:
  explicit Search(const TransferFunction& transfer)
      : step_(transfer), modes_(modesOf(transfer)), final_(gainAtRest(transfer)) {}

  /// A bound of the relative distance from the final value at t and later.
  double maxFrom(double t_s) const {
    double sum = 0.0;
    for (const Mode& mode : modes_) sum += mode.share * std::exp(-mode.decay_per_s * t_s);
    return sum;
  }
  /// The bound for all times: that of the undamped modes.
  double maxForEver() const {
    double sum = 0.0;
    for (const Mode& mode : modes_) sum += mode.decay_per_s > 0.0 ? 0.0 : mode.share;
    return sum;
  }
  double z(double t_s) const { return zOf(step_.stagesAt(t_s)); }
  /// The time in an interval at which z passes level.
  double passing(const Piece& piece, double level) const {
    const bool above = piece.z_from > level;
    return boundary(piece.from_s, piece.to_s, [&](double t_s) { return (z(t_s) > level) == above; });
  }
  /// The intervals of one block of samples from from_s on. matters: whether an extremum that reaches no farther than z
  /// has to be found; others are left inside their interval. Most are too small, and each takes some fifty exact
  /// values.
  std::vector<Piece> block(double from_s, double step_s, const std::function<bool(double z)>& matters) const {
    std::vector<Piece> pieces;
    const UnitStep::Matrix after = step_.stagesAfter(step_s);
    UnitStep::Vector stages = step_.stagesAt(from_s);
    for (int step = 0; step < kBlock; ++step) {
      const double t_s = from_s + step * step_s, next_s = from_s + (step + 1) * step_s;
      const UnitStep::Vector next = after.lazyProduct(stages);
      const double rate = rateOf(stages), next_rate = rateOf(next), here = zOf(stages), there = zOf(next);
      double turn_s = t_s;
      if (rate * next_rate < 0.0) {
        // The rate falls to 0 at most linearly, so the interval adds at most twice this.
        const double beyond = std::abs(rate) * step_s * rate / (rate - next_rate);
        const double farthest = rate > 0.0 ? std::max(here, there) + beyond : std::min(here, there) - std::abs(beyond);
        if (matters(farthest))
          turn_s = boundary(t_s, next_s, [&](double at_s) {
            return rateOf(step_.stagesAfter(at_s - t_s).lazyProduct(stages)) * rate > 0.0;
          });
      }
      const double z_turn = turn_s > t_s ? z(turn_s) : here;
      if (turn_s > t_s) pieces.push_back({t_s, turn_s, here, z_turn});
      pieces.push_back({turn_s, next_s, z_turn, there});
      stages = next;
    }
    return pieces;
  }
  /// A step short enough for the fastest mode that still exceeds least, relative to the final value; 0: none does.
  double stepAt(double t_s, double min) const {
    double fastest = 0.0;
    for (const Mode& mode : modes_) {
      if (mode.share * std::exp(-mode.decay_per_s * t_s) > min) fastest = std::max(fastest, mode.speed_rad_per_s);
    }
    return fastest > 0.0 ? 2.0 * kPi / (kPerTurn * fastest) : 0.0;
  }
  /// The time from which only undamped modes are left and have completed their pattern; infinite where there are none.
  double seenAll() const {
    double alone_s = 0.0, slowest = kInfinity;
    int undamped = 0;
    for (const Mode& mode : modes_) {
      if (mode.decay_per_s > 0.0) {
        if (mode.share > kGone) alone_s = std::max(alone_s, std::log(mode.share / kGone) / mode.decay_per_s);
        continue;
      }
      ++undamped;
      slowest = std::min(slowest, mode.speed_rad_per_s);
    }
    if (undamped == 0) return kInfinity;
    return alone_s + (undamped == 2 ? 1.01 : kSwings) * 2.0 * kPi / slowest;
  }

 private:
  double zOf(const UnitStep::Vector& stages) const { return step_.deviation(stages) / final_; }
  double rateOf(const UnitStep::Vector& stages) const { return step_.rate(stages) / final_; }
  /// The time at which `holds`, true at low, becomes false: to the last bit, by bisection.
  static double boundary(double low_s, double high_s, const std::function<bool(double)>& holds) {
    for (;;) {
      const double middle_s = 0.5 * (low_s + high_s);
      if (!(middle_s > low_s && middle_s < high_s)) return middle_s;
      (holds(middle_s) ? low_s : high_s) = middle_s;
    }
  }

  UnitStep step_;
  std::vector<Mode> modes_;
  double final_;
};

/// Finds rise and peak, forwards from the step.
void findRiseAndPeak(const Search& search, StepMetrics& metrics) {
  const double z_first = search.z(0.0), seen_s = search.seenAll();
  std::optional<double> low_s, high_s;
  if (z_first >= kRiseFrom - 1.0) low_s = 0.0;
  if (z_first >= kRiseTo - 1.0) high_s = 0.0;
  double max = kGone, t_s = 0.0;
  if (z_first > max) {
    max = z_first;
    metrics.peak_time_s = 0.0;
  }
  for (int block = 0; block < kMaxBlocks; ++block) {
    const double step_s = search.stepAt(t_s, std::max(kGone, high_s ? kTold * max : 0.0));
    if (step_s == 0.0 || t_s > seen_s || (high_s && search.maxFrom(t_s) <= max)) break;
    const double wanted = std::min(max, !low_s ? kRiseFrom - 1.0 : !high_s ? kRiseTo - 1.0 : max);
    for (const Piece& piece : search.block(t_s, step_s, [wanted](double z) { return z > wanted; })) {
      if (!low_s && piece.z_to >= kRiseFrom - 1.0) low_s = search.passing(piece, kRiseFrom - 1.0);
      if (!high_s && piece.z_to >= kRiseTo - 1.0) high_s = search.passing(piece, kRiseTo - 1.0);
      if (piece.z_to > max + 1e-12 * std::abs(max)) {
        max = piece.z_to;
        metrics.peak_time_s = piece.to_s;
      }
    }
    t_s += kBlock * step_s;
  }
  if (low_s && high_s) metrics.rise_10_90_s = *high_s - *low_s;
  metrics.overshoot_fraction = metrics.peak_time_s ? max : 0.0;
}

/// Finds settling, backwards from the time at which it is certain.
void findSettling(const Search& search, StepMetrics& metrics) {
  double within_s = 0.0;
  if (search.maxFrom(0.0) >= kSettlingBand) {
    double low_s = 0.0, high_s = search.stepAt(0.0, kGone);
    while (search.maxFrom(high_s) >= kSettlingBand) {
      if (search.maxForEver() >= kSettlingBand || !std::isfinite(high_s)) return;  // never
      low_s = high_s;
      high_s *= 2.0;
    }
    while (high_s - low_s > 1e-6 * high_s) {
      const double middle_s = 0.5 * (low_s + high_s);
      (search.maxFrom(middle_s) >= kSettlingBand ? low_s : high_s) = middle_s;
    }
    within_s = high_s;
  }
  for (int block = 0; block < kMaxBlocks && within_s > 0.0; ++block) {
    double begin_s = std::max(0.0, within_s - kBlock * search.stepAt(within_s, kTold * kSettlingBand));
    // A faster mode may be left at the beginning of the block: then a shorter block.
    while (within_s - begin_s > 1.0001 * kBlock * search.stepAt(begin_s, kTold * kSettlingBand))
      begin_s = 0.5 * (begin_s + within_s);
    const std::vector<Piece> pieces =
        search.block(begin_s, (within_s - begin_s) / kBlock, [](double z) { return std::abs(z) > kSettlingBand; });
    for (auto piece = pieces.rbegin(); piece != pieces.rend(); ++piece) {
      if (std::abs(piece->z_from) < kSettlingBand) continue;
      metrics.settling_2pct_s = search.passing(*piece, std::copysign(kSettlingBand, piece->z_from));
      return;
    }
    within_s = begin_s;
  }
  metrics.settling_2pct_s = within_s;  // from the beginning, or as far back as was searched
}

}  // namespace

StepMetrics metricsOf(const TransferFunction& transfer) {
  const Behaviour behaviour = behaviourOf(transfer);
  StepMetrics metrics;
  if (behaviour == Behaviour::Grows || behaviour == Behaviour::Drifts) return metrics;
  metrics.final_value = gainAtRest(transfer);
  if (*metrics.final_value == 0.0) return metrics;
  const Search search(transfer);
  findRiseAndPeak(search, metrics);
  findSettling(search, metrics);
  return metrics;
}

double plotDuration_s(const TransferFunction& transfer) {
  const StepMetrics metrics = metricsOf(transfer);
  if (metrics.settling_2pct_s.value_or(0.0) > 0.0) return 1.5 * *metrics.settling_2pct_s;
  double slowest = kInfinity, growth = 0.0;
  for (const Complex& pole : poles(transfer)) {
    if (std::abs(pole) > 0.0) slowest = std::min(slowest, std::abs(pole));
    growth = std::max(growth, pole.real());
  }
  if (behaviourOf(transfer) == Behaviour::Grows && growth > 0.0) return std::min(5.0 / growth, 12.0 * kPi / slowest);
  return slowest < kInfinity ? 12.0 * kPi / slowest : 10.0;
}

}  // namespace underact::lab
