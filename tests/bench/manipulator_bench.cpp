#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

#include "core/chain/kinematics.h"
#include "core/manipulator/follow.h"
#include "tests/support/arm_tables.h"

// us for one tick of a virtual manipulator, warm from the last, along a smooth hand at 1 kHz (0.2 m/s, and turning),
// with its watch; and how far the target is from the converged one. The rows with "steps" trade the one for the other.
// Each tick is timed alone, the clock's own time taken off; every round does the same work, so a tick's time is the
// least of all rounds: other programs only ever add to it.
namespace underact {
namespace {

using manipulator::Manipulator;
using manipulator::Orientation;
using Clock = std::chrono::steady_clock;

constexpr int kTicks = 4096;
constexpr int kRounds = 9;
constexpr int kEnough = 20;  // steps a tick

Mat3 about(const Vec3& axis, double angle_rad) {
  return Eigen::AngleAxisd(angle_rad, axis.normalized()).toRotationMatrix();
}

Pose poseOf(const Mat3& R, const Vec3& p) {
  Pose X = Pose::Identity();
  X.linear() = R;
  X.translation() = p;
  return X;
}

struct Path {
  std::string name;
  Manipulator manipulator;
  std::vector<Pose> stylus;
  std::vector<Vec3> converged;  // the target of each tick
};

std::vector<Vec3> targets(const Manipulator& m, const std::vector<Pose>& stylus) {
  int steps = 0;
  manipulator::State state = settledState(m, stylus.front(), steps);
  std::vector<Vec3> all;
  for (const Pose& X_WT : stylus) all.push_back(follow(m, X_WT, 0.0, state).p_WP);
  return all;
}

std::shared_ptr<const Path> makePath(std::string name, const chain::Chain& chain, Orientation orientation,
                                     const Pose& X, manipulator::Method method) {
  manipulator::Wanted wanted;
  wanted.chain = chain;
  wanted.orientation = orientation;
  wanted.ko_N_m_per_rad = 0.25;
  wanted.method = method;
  Path path{std::move(name), makeManipulator(wanted, {}).value(), {}, {}};
  for (int i = 0; i < kTicks; ++i) {
    const double s = 2.0 * kPi * i / 1024.0;  // a round a second
    const Vec3 way_W(0.015 * std::cos(s), 0.020 * std::sin(s), 0.010 * std::sin(2.0 * s));
    path.stylus.push_back(poseOf(about({1, 2, -1}, 0.2 * std::sin(s)) * X.linear(), X.translation() + way_W));
  }
  // The closed form where there is one, else until nothing moves.
  wanted.method.reset();
  wanted.tolerance = 1e-14;
  wanted.max_steps = 100;
  path.converged = targets(makeManipulator(wanted, {}).value(), path.stylus);
  return std::make_shared<const Path>(std::move(path));
}

double usSince(Clock::time_point start) {
  return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
}

double shareOf(std::vector<double>& all, double share) {
  const auto at = all.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(all.size() - 1));
  std::nth_element(all.begin(), at, all.end());
  return *at;
}

double clockItself_us() {
  std::vector<double> all;
  for (int i = 0; i < 10'000; ++i) {
    const Clock::time_point start = Clock::now();
    all.push_back(usSince(start));
  }
  return shareOf(all, 0.5);
}

void measureSolver(benchmark::State& state, const std::shared_ptr<const Path>& path, int max_steps, bool second_order) {
  Manipulator m = path->manipulator;
  m.options.max_steps = max_steps;
  m.options.second_order = second_order;
  const double clock_us = clockItself_us();
  double error_m = 0.0, steps = 0.0;
  std::vector<double> us(kTicks, kInfinity);
  for (auto _ : state) {
    for (int round = 0; round < kRounds; ++round) {
      int cold = 0;
      manipulator::State memory = settledState(path->manipulator, path->stylus.front(), cold);
      error_m = steps = 0.0;
      for (std::size_t i = 0; i < us.size(); ++i) {
        const Clock::time_point start = Clock::now();
        const manipulator::Followed followed = follow(m, path->stylus[i], 1e-3, memory);
        us[i] = std::min(us[i], usSince(start) - clock_us);
        error_m = std::max(error_m, (followed.p_WP - path->converged[i]).norm());
        steps += followed.steps;
      }
    }
    state.SetIterationTime(1e-6 * shareOf(us, 0.5));
  }
  const double median_us = shareOf(us, 0.5), p99_us = shareOf(us, 0.99);
  state.counters["median_us"] = median_us;
  state.counters["p99_us"] = p99_us;
  state.counters["error_mm"] = kMillimetrePerMetre * error_m;
  state.counters["steps"] = steps / kTicks;
}

void add(const std::shared_ptr<const Path>& path, const std::string& how, int max_steps, bool second_order) {
  benchmark::RegisterBenchmark(("manipulator/" + path->name + how).c_str(), measureSolver, path, max_steps,
                               second_order)
      ->UseManualTime()
      ->Iterations(1);
}

chain::Chain chainOf(std::vector<chain::Joint> joints, const Vec3& p_WV) {
  Mat3 out;  // z of the tip outward, along x
  out << 0, 0, 1, 0, -1, 0, 1, 0, 0;
  return chain::makeChain(std::move(joints), poseOf(out, p_WV), {}).value();
}

chain::Joint turning(const Vec3& axis_W, double x_m = 0.0) {
  return {chain::JointType::Revolute, axis_W, {x_m, 0, 0}};
}
chain::Joint sliding(const Vec3& axis_W) {
  return {chain::JointType::Prismatic, axis_W};
}

std::vector<std::shared_ptr<const Path>> closedPaths() {
  const Vec3 x_W = Vec3::UnitX(), y_W = Vec3::UnitY(), z_W = Vec3::UnitZ();
  const Pose X = chainOf({turning(z_W)}, {0.06, 0.01, 0.02}).X_WT_home;
  const auto of = [&](const char* name, std::vector<chain::Joint> joints) {
    return makePath(name, chainOf(std::move(joints), {0.05, 0, 0}), Orientation::Axis, X,
                    manipulator::Method::ClosedForm);
  };
  return {of("closed/circle", {turning(z_W)}), of("closed/sphere", {turning(z_W), turning(-y_W)}),
          of("closed/cylinder", {turning(z_W), sliding(z_W)}), of("closed/line", {sliding(x_W)}),
          of("closed/plane", {sliding(x_W), sliding(y_W)})};
}

std::vector<std::shared_ptr<const Path>> paths() {
  const Vec3 y_W = Vec3::UnitY(), z_W = Vec3::UnitZ();
  const chain::Chain puma = chain::test::puma().chain(), omni = chain::test::omni().chain();
  chain::Chain five = puma;
  five.joints.resize(5);
  const Pose bent = chain::forward(puma, std::vector<double>{0.4, -0.7, 0.3, 0.5, 0.9, 0.2});
  const Pose beyond = poseOf(about({3, 1, -1}, 0.8), chain::test::omni().X_WB.translation() + Vec3(0.1, 0.2, 0.25));
  const Mat3 leaned = about({3, 5, -4}, 0.4) * chainOf({turning(z_W)}, {0.05, 0, 0}).X_WT_home.linear();
  const auto of = [](const char* name, const chain::Chain& chain, Orientation orientation, const Pose& X) {
    return makePath(name, chain, orientation, X, manipulator::Method::Iterative);
  };
  return {of("1_circle_angle", chainOf({turning(z_W)}, {0.05, 0, 0}), Orientation::Angle,
             poseOf(leaned, {0.06, 0.01, 0.02})),
          of("2_sphere", chainOf({turning(z_W), turning(-y_W)}, {0.05, 0, 0}), Orientation::None,
             poseOf(leaned, {0.06, 0.01, 0.02})),
          of("2_sphere_axis", chainOf({turning(z_W), turning(-y_W)}, {0.05, 0, 0}), Orientation::Axis,
             poseOf(leaned, {0.06, 0.01, 0.02})),
          of("3_planar", chainOf({turning(z_W), turning(z_W, 0.06), turning(z_W, 0.11)}, {0.15, 0, 0}),
             Orientation::Axis, poseOf(leaned, {0.08, 0.05, 0.02})),
          of("4_scara", chainOf({turning(z_W), turning(z_W, 0.06), sliding(z_W), turning(z_W, 0.11)}, {0.13, 0, 0}),
             Orientation::Full, poseOf(leaned, {0.08, 0.05, 0.02})),
          of("5_puma", five, Orientation::Full, bent),
          of("6_puma", puma, Orientation::Full, bent),
          of("6_stretched", omni, Orientation::Full, beyond)};
}

const bool kSolversRegistered = [] {
  const std::vector<std::shared_ptr<const Path>> iterative = paths();
  for (const auto& path : closedPaths()) add(path, "", kEnough, true);
  for (const auto& path : iterative) add(path, "", kEnough, true);
  for (const auto& path : iterative) {
    for (const bool second_order : {true, false}) {
      for (int steps = 1; steps <= kEnough; ++steps) {
        add(path, (second_order ? "/newton/steps:" : "/gauss/steps:") + std::to_string(steps), steps, second_order);
      }
    }
  }
  return true;
}();

}  // namespace
}  // namespace underact
