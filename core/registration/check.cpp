#include "core/registration/check.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/translate.h"
#include "core/base/units.h"

namespace underact::registration {
namespace {

constexpr double kNearLine_m = 10e-3;   // 1 mm of error rotates the arm by 6 degrees
constexpr double kNearMarks_m = 20e-3;  // 1 mm of error rotates the line between them by 3 degrees
constexpr double kMuch_m = 3e-3;        // more than a calibrated arm whose tip rests on its reference point
constexpr double kMuchBetter = 0.25;    // relative residual of the right order
constexpr double kAlike_m = 1.5e-3;     // difference of the residuals of two equally good orders
constexpr double kRestless_m = 0.5e-3;  // of a tip that was held

Sentence millimetres(double length_m) {
  return phrase(TRANSLATE_NOOP("problem", "%1 mm"), {shownNumber(length_m * kMillimetrePerMetre, 1)});
}

/// "2", "2 and 3", "1, 2 and 3": counted from 1.
Sentence listOf(const std::vector<std::size_t>& marks) {
  Sentence text;
  for (std::size_t at = 0; at < marks.size(); ++at) {
    const std::string mark = std::to_string(marks[at] + 1);
    if (at > 0 && at + 1 == marks.size()) return phrase(TRANSLATE_NOOP("problem", "%1 and %2"), {text, mark});
    text = at > 0 ? text + ", " + mark : mark;
  }
  return text;
}

std::vector<Touch> reordered(const std::vector<Touch>& touches, const std::vector<std::size_t>& order) {
  std::vector<Touch> touched = touches;
  for (std::size_t at = 0; at < touches.size(); ++at) touched[at].p_DM = touches[order[at]].p_DM;
  return touched;
}

/// The differences of the distances between reference points and between touched points, m: small only for a fitting
/// order, also a mirrored one; thousands of times faster than a fit.
class Distances {
 public:
  explicit Distances(const std::vector<Touch>& touches) : count_(touches.size()) {
    for (const Touch& one : touches) {
      for (const Touch& other : touches) {
        marks_m_.push_back((one.p_DM - other.p_DM).norm());
        touched_m_.push_back((one.p_WM - other.p_WM).norm());
      }
    }
  }
  double worst_m(const std::vector<std::size_t>& order, double enough_m) const {
    double worst = 0.0;
    for (std::size_t one = 0; one < count_ && worst < enough_m; ++one) {
      for (std::size_t other = 0; other < one; ++other) {
        worst =
            std::max(worst, std::abs(touched_m_[one * count_ + other] - marks_m_[order[one] * count_ + order[other]]));
      }
    }
    return worst;
  }

 private:
  std::size_t count_;
  std::vector<double> marks_m_, touched_m_;
};

void warnOfLayout(const std::vector<Touch>& touches, std::vector<Warning>& warnings) {
  const Layout layout = layoutOf(referencePointsOf(touches));
  if (layout.off_line_m < kNearLine_m) {
    warnings.push_back(
        {Warning::Kind::NearLine,
         phrase(
             TRANSLATE_NOOP("problem",
                            "The reference points lie nearly on one line, at most %1 beside it: small errors turn the "
                            "arm about it. Choose a reference point farther from the line."),
             {millimetres(layout.off_line_m)}),
         {}});
  }
  if (layout.min_apart_m < kNearMarks_m) {
    const std::vector<std::size_t> both{layout.near_one, layout.near_other};
    warnings.push_back({Warning::Kind::NearMarks,
                        phrase(TRANSLATE_NOOP("problem",
                                              "The reference points %1 are only %2 apart: small errors there turn "
                                              "everything. Choose reference points that are farther apart."),
                               {listOf(both), millimetres(layout.min_apart_m)}),
                        both});
  }
}

void warnOfOrder(const std::vector<Touch>& touches, const Fit& fit, std::vector<Warning>& warnings) {
  const std::vector<std::size_t> order = likelyOrder(touches, fit);
  std::vector<std::size_t> others;
  for (std::size_t at = 0; at < order.size(); ++at) {
    if (order[at] != at) others.push_back(at);
  }
  if (!others.empty()) {
    warnings.push_back(
        {Warning::Kind::Order,
         others.size() == 2
             ? phrase(TRANSLATE_NOOP("problem",
                                     "The reference points %1 were probably swapped. Touch them again in "
                                     "the order of their numbers."),
                      {listOf(others)})
             : phrase(TRANSLATE_NOOP("problem",
                                     "The reference points were probably touched in another order: %1. "
                                     "Touch them again in the order of their numbers."),
                      {listOf(order)}),
         others});
  } else if (!isUpright(fit)) {
    warnings.push_back(
        {Warning::Kind::UpsideDown,
         phrase(TRANSLATE_NOOP(
             "problem",
             "According to these reference points the arm hangs upside down below the desk. If it does not, they were "
             "touched in mirrored order: touch them again in the order of their numbers.")),
         {}});
  }
}

}  // namespace

bool isUpright(const Fit& fit) {
  return fit.X_DW.linear()(1, 1) > 0.0;
}

std::size_t worstPoint(const std::vector<Touch>& touches, const Fit& fit) {
  std::size_t worst = 0;
  double min_m = kInfinity;
  for (std::size_t at = 0; at < touches.size(); ++at) {
    double left_m = -fit.off_D[at].norm();
    if (touches.size() > kFewestMarks) {
      std::vector<Touch> others = touches;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(at));
      const Result<Fit> without = fitTouches(others);
      left_m = without ? without.value().rms_m : kInfinity;
    }
    if (left_m >= min_m) continue;
    min_m = left_m;
    worst = at;
  }
  return worst;
}

std::vector<std::size_t> likelyOrder(const std::vector<Touch>& touches, const Fit& fit) {
  std::vector<std::size_t> order(touches.size());
  std::iota(order.begin(), order.end(), 0U);
  const std::vector<std::size_t> as_they_stand = order;
  const bool is_wrong = fit.rms_m > kMuch_m || !isUpright(fit);
  if (!is_wrong) return as_they_stand;
  const Distances distances(touches);
  // The distance of two points with an error of at most r each has an error of at most 2 r, and no point is off by more
  // than sqrt(N) times the root mean square.
  double allowed_m = std::max(kMuchBetter * fit.rms_m, kAlike_m);
  if (!isUpright(fit)) allowed_m = std::max(allowed_m, fit.rms_m + kAlike_m);
  const double distance_m = 2.0 * allowed_m * std::sqrt(static_cast<double>(touches.size()));
  std::vector<std::size_t> best = as_they_stand;
  double best_m = allowed_m;
  while (std::next_permutation(order.begin(), order.end())) {
    if (distances.worst_m(order, distance_m) >= distance_m) continue;
    const Result<Fit> other = fitTouches(reordered(touches, order));
    if (!other || !isUpright(other.value()) || other.value().rms_m >= best_m) continue;
    best_m = other.value().rms_m;
    best = order;
  }
  return best;
}

std::vector<Warning> warningsOf(const std::vector<Touch>& touches, const Fit& fit) {
  std::vector<Warning> warnings;
  warnOfLayout(touches, warnings);
  warnOfOrder(touches, fit, warnings);
  const bool order_is_wrong = std::any_of(warnings.begin(), warnings.end(),
                                          [](const Warning& one) { return one.kind == Warning::Kind::Order; });
  if (fit.rms_m > kMuch_m && !order_is_wrong) {
    const std::size_t worst = worstPoint(touches, fit);
    warnings.push_back(
        {Warning::Kind::Residual,
         phrase(
             TRANSLATE_NOOP(
                 "problem",
                 "The touched points miss the reference points by %1, which is a lot. Reference point %2 fits worst: "
                 "touch it again, and check that the sheet was printed at 100 % and that the arm is calibrated."),
             {millimetres(fit.rms_m), std::to_string(worst + 1)}),
         {worst}});
  }
  for (std::size_t at = 0; at < touches.size(); ++at) {
    if (touches[at].spread_m <= kRestless_m) continue;
    warnings.push_back({Warning::Kind::Moved,
                        phrase(TRANSLATE_NOOP("problem",
                                              "At reference point %1 the tip moved by %2 while it was held. Touch it "
                                              "again, with your hand resting on the desk."),
                               {std::to_string(at + 1), millimetres(touches[at].spread_m)}),
                        {at}});
  }
  return warnings;
}

}  // namespace underact::registration
