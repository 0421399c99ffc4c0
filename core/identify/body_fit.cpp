#include "core/identify/body_fit.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/decompositions.h"
#include "core/base/translate.h"
#include "core/identify/weak_form.h"

namespace underact::identify {
namespace {

constexpr int kMaxRounds = 60;
// Sticking makes kinks and local minima in the sum of squares: several starts, of which the best counts.
constexpr double kStarts[] = {1.0, 0.8, 1.2};
constexpr double kWorst = 0.1;      // the largest residual, relative to the motion's root mean square
constexpr double kSettled = 1e-10;  // relative decrease of the sum of squares at convergence
constexpr double kNothing = 1e-12;  // added to a matrix that may be singular: a velocity that friction stops at once
constexpr double kPoll_s = 0.01;    // from which the first velocity is guessed

using Shared = Eigen::Vector4d;  // mass, friction, damping, bias
using Own = Eigen::Vector2d;     // place and velocity at a window's beginning

Body bodyOf(const Shared& shared) {
  return {shared[0], shared[1], shared[2], shared[3]};
}

/// Steps for the derivatives: small against the uncertainties, large against rounding.
const Shared kNudge(1e-6, 1e-5, 1e-4, 1e-5);
constexpr double kNudge_m_per_s = 1e-5;

std::vector<double> travelOf(const Body& body, const Window& window, const Own& own) {
  const BodyStep step(body, window.period_s);
  std::vector<double> travel_m(window.travel_m.size());
  Motion motion{own[0], own[1]};
  for (std::size_t index = 0; index < travel_m.size(); ++index) {
    travel_m[index] = motion.x_m;
    motion = step(motion, window.force_N[index], window.friction_share[index]);
  }
  return travel_m;
}

double squaresOf(const Window& window, const std::vector<double>& travel_m) {
  double squares = 0.0;
  for (std::size_t index = 0; index < travel_m.size(); ++index)
    squares += std::pow(window.travel_m[index] - travel_m[index], 2);
  return squares;
}

/// The root mean square of the displacements about their means.
double movedOf(std::span<const Window> windows) {
  double squares = 0.0, samples = 0.0;
  for (const Window& window : windows) {
    double mean_m = 0.0;
    for (const double travel_m : window.travel_m) mean_m += travel_m / static_cast<double>(window.travel_m.size());
    for (const double travel_m : window.travel_m) squares += std::pow(travel_m - mean_m, 2);
    samples += static_cast<double>(window.travel_m.size());
  }
  return std::sqrt(squares / samples);
}

/// The normal equations of one window: of the shared unknowns, of its own, and mixed.
struct Normal {
  Eigen::Matrix4d shared = Eigen::Matrix4d::Zero();
  Eigen::Matrix2d own = Eigen::Matrix2d::Zero();
  Eigen::Matrix<double, 4, 2> across = Eigen::Matrix<double, 4, 2>::Zero();
  Shared shared_pull = Shared::Zero();
  Own own_pull = Own::Zero();
};

Normal normalOf(const Shared& shared, const Window& window, const Own& own) {
  const std::vector<double> travel_m = travelOf(bodyOf(shared), window, own);
  std::vector<std::vector<double>> nudged;
  for (Eigen::Index which = 0; which < 4; ++which) {
    Shared other = shared;
    other[which] += kNudge[which];
    nudged.push_back(travelOf(bodyOf(other), window, own));
  }
  nudged.push_back(travelOf(bodyOf(shared), window, own + Own(0.0, kNudge_m_per_s)));
  Normal normal;
  for (std::size_t index = 0; index < travel_m.size(); ++index) {
    Shared slope;
    for (Eigen::Index which = 0; which < 4; ++which)
      slope[which] = (nudged[static_cast<std::size_t>(which)][index] - travel_m[index]) / kNudge[which];
    const Own own_slope(1.0, (nudged[4][index] - travel_m[index]) / kNudge_m_per_s);
    const double miss_m = window.travel_m[index] - travel_m[index];
    normal.shared += slope * slope.transpose();
    normal.own += own_slope * own_slope.transpose();
    normal.across += slope * own_slope.transpose();
    normal.shared_pull += miss_m * slope;
    normal.own_pull += miss_m * own_slope;
  }
  normal.own(1, 1) += kNothing * static_cast<double>(travel_m.size());
  return normal;
}

Own guessOf(const Window& window) {
  const auto look =
      std::min(window.travel_m.size() - 1, static_cast<std::size_t>(std::lround(kPoll_s / window.period_s)));
  const double travel_m = window.travel_m[look] - window.travel_m[0];
  return {window.travel_m[0], travel_m / (window.period_s * static_cast<double>(look))};
}

class Fit {
 public:
  Fit(std::span<const Window> windows, const Body& guess, const std::function<bool()>& stop)
      : windows_(windows), stop_(&stop) {
    shared_ << guess.mass_kg, guess.friction_N, guess.damping_N_s_per_m, guess.bias_N;
    for (const Window& window : windows) own_.push_back(guessOf(window));
    squares_ = squaresOf(shared_, own_);
  }
  void run() {
    double caution = 1e-3;
    for (rounds_ = 1; rounds_ <= kMaxRounds; ++rounds_) {
      normals_.clear();
      for (std::size_t index = 0; index < windows_.size(); ++index) {
        if (isStopped()) return;
        normals_.push_back(normalOf(shared_, windows_[index], own_[index]));
      }
      bool better = false;
      double gain = 0.0;
      for (; !better && caution < 1e12; caution *= better ? 0.1 : 10.0) {
        if (isStopped()) return;
        gain = tryStep(caution);
        better = gain >= 0.0;
      }
      caution = std::max(caution, 1e-12);
      if (!better || gain <= kSettled * squares_) return;  // no further improvement: a kink of friction, or the minimum
    }
  }
  double squares() const { return squares_; }
  bool wasStopped() const { return was_stopped_; }
  BodyFit result() const;

 private:
  double squaresOf(const Shared& shared, const std::vector<Own>& own) const {
    double squares = 0.0;
    for (std::size_t index = 0; index < windows_.size(); ++index)
      squares += identify::squaresOf(windows_[index], travelOf(bodyOf(shared), windows_[index], own[index]));
    return squares;
  }
  double tryStep(double caution);
  bool isStopped() {
    was_stopped_ = *stop_ && (*stop_)();
    return was_stopped_;
  }

  std::span<const Window> windows_;
  const std::function<bool()>* stop_;
  bool was_stopped_ = false;
  Shared shared_;
  std::vector<Own> own_;
  std::vector<Normal> normals_;
  double squares_ = 0.0;
  int rounds_ = 0;
};

/// Takes the step if it lowers the sum of squares, and gives by how much; below 0: not taken.
double Fit::tryStep(double caution) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  Shared pull = Shared::Zero();
  std::vector<Eigen::Matrix2d> inverse;
  for (const Normal& normal : normals_) {
    Eigen::Matrix2d own = normal.own;
    own.diagonal() *= 1.0 + caution;
    inverse.push_back(own.inverse());
    matrix += normal.shared;
    matrix.diagonal() += caution * normal.shared.diagonal();
    matrix -= normal.across * inverse.back() * normal.across.transpose();
    pull += normal.shared_pull - normal.across * inverse.back() * normal.own_pull;
  }
  const Shared change = solveSymmetric(matrix, pull);
  if (!change.allFinite()) return -1.0;
  Shared shared = shared_ + change;
  shared[0] = std::max(shared[0], 0.3 * shared_[0]);  // never to 0 in one leap
  shared[0] = std::max(shared[0], kMinMass_kg);
  shared[1] = std::max(shared[1], 0.0);
  std::vector<Own> own = own_;
  for (std::size_t index = 0; index < own.size(); ++index) {
    const Normal& normal = normals_[index];
    own[index] += inverse[index] * (normal.own_pull - normal.across.transpose() * (shared - shared_));
  }
  const double squares = squaresOf(shared, own);
  if (!(squares <= squares_)) return -1.0;
  const double gain = squares_ - squares;
  shared_ = shared, own_ = std::move(own), squares_ = squares;
  return gain;
}

/// The normal equations of the shared unknowns, those of each window eliminated.
struct Reduced {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  Shared pull = Shared::Zero();
  void add(const Reduced& other) {
    matrix += other.matrix;
    pull += other.pull;
  }
};

Reduced reducedOf(const Normal& normal) {
  const Eigen::Matrix2d inverse = normal.own.inverse();
  return {normal.shared - normal.across * inverse * normal.across.transpose(),
          normal.shared_pull - normal.across * inverse * normal.own_pull};
}

/// The variances of the shared unknowns by the jackknife: the fit without each swing in turn, to first order. What the
/// residuals of a swing have in common, as the place between two encoder steps where the tip came to rest, counts once,
/// and a swing that pulls the fit to itself does not hide that it does. Not finite: a swing without which there is no
/// fit.
Shared jackknifeOf(const Reduced& all, const std::vector<Reduced>& swings) {
  Shared squares = Shared::Zero();
  for (const Reduced& one : swings) squares += solveSymmetric(all.matrix - one.matrix, one.pull).cwiseAbs2();
  const double count = static_cast<double>(swings.size());
  return (count - 1.0) / count * squares;
}

BodyFit Fit::result() const {
  BodyFit fit;
  fit.body = bodyOf(shared_);
  fit.rounds = rounds_;
  Reduced all;
  std::vector<Reduced> swings;
  double samples = 0.0;
  for (std::size_t index = 0; index < windows_.size(); ++index) {
    fit.travel_m.push_back(travelOf(fit.body, windows_[index], own_[index]));
    samples += static_cast<double>(fit.travel_m.back().size());
    const Reduced one = reducedOf(normalOf(shared_, windows_[index], own_[index]));
    all.add(one);
    if (index == 0 || windows_[index].swing != windows_[index - 1].swing) swings.emplace_back();
    swings.back().add(one);
  }
  const double count = static_cast<double>(windows_.size()), free = std::max(1.0, samples - 4.0 - 2.0 * count);
  fit.residual_m = std::sqrt(squares_ / samples);
  const Eigen::Matrix4d inverse = solveSymmetric(all.matrix, Eigen::Matrix4d::Identity());
  const Shared by_residual = squares_ / free * inverse.diagonal(), by_swings = jackknifeOf(all, swings);
  Shared deviation;
  for (Eigen::Index which = 0; which < 4; ++which) {
    const double swing = std::isfinite(by_swings[which]) ? by_swings[which] : 0.0;
    deviation[which] = std::sqrt(std::max({0.0, by_residual[which], swing}));
  }
  fit.uncertainty = bodyOf(deviation);
  return fit;
}

}  // namespace

Result<BodyFit> fitBody(std::span<const Window> windows, const std::function<bool()>& stop) {
  const std::vector<Block> blocks = blocksOf(windows);
  const std::optional<Body> guess = firstGuess(blocks);
  if (!guess)
    return Problems{{phrase(TRANSLATE_NOOP("problem",
                                           "The tip hardly moved, so nothing can be measured. Check that the hand has "
                                           "let go, that nothing is in the way, and that the arm has mass."))}};
  std::optional<Fit> best;
  for (const double share : kStarts) {
    Body start = *guess;
    start.friction_N *= share;
    Fit fit(windows, start, stop);
    fit.run();
    if (fit.wasStopped()) return Problems{{phrase(TRANSLATE_NOOP("problem", "The fit was cancelled."))}};
    if (!best || fit.squares() < best->squares()) best = std::move(fit);
  }
  BodyFit fit = best->result();
  if (!(fit.residual_m < kWorst * movedOf(windows)))
    return Problems{
        {phrase(TRANSLATE_NOOP("problem",
                               "No mass with friction and damping moves as the tip did. Check that the hand "
                               "has let go, and measure again."))}};
  return fit;
}

}  // namespace underact::identify
