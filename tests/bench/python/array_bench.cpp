// underact-array-bench [POSES]: what an array of random poses of the Omni costs in C++, by the functions that the
// Python package calls. Prints nanoseconds a pose, the least of several rounds: fk, jacobian, ik.
// tests/bench/python/beside_others.py runs it.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <span>
#include <vector>

#include "core/arm/model.h"
#include "core/kinematics/forward.h"
#include "core/kinematics/inverse.h"
#include "core/kinematics/solved_arm.h"
#include "core/kinematics/units.h"

namespace {

using namespace underact;

/// Nanoseconds of one of count, in the fastest of seven rounds of work(i).
template <class Work>
double minOf(std::size_t count, const Work& work) {
  double min = 1e300;
  for (int round = 0; round < 7; ++round) {
    const auto begin = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < count; ++i) work(i);
    const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - begin;
    min = std::min(min, took.count() / static_cast<double>(count));
  }
  return min;
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t count = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 100'000;
  const Result<kinematics::SolvedArm> arm = kinematics::chooseArm("omni-thesis");
  if (!arm) return 1;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> angle(-2.5, 2.5);
  std::vector<chain::JointValues> q(count);
  for (chain::JointValues& one : q) std::generate_n(one.begin(), 6, [&] { return angle(random); });
  std::vector<Eigen::Matrix4d> X(count);
  std::vector<Eigen::Matrix<double, 6, 6>> J(count);
  const double fk_ns = minOf(count, [&](std::size_t i) { X[i] = kinematics::poseOf(arm.value(), q[i]); });
  const double jacobian_ns = minOf(count, [&](std::size_t i) { J[i] = kinematics::jacobianOf(arm.value(), q[i]); });
  std::vector<Pose> poses(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (!kinematics::readPose(X[i], poses[i]).empty()) return 1;
  }
  std::vector<std::array<double, 6>> solutions(8 * count);
  std::size_t found = 0, within = 0;
  const kinematics::InverseOptions options{"auto", 1, 0, {}};
  const Result<kinematics::Method> method = kinematics::methodFor(arm.value(), "auto");
  if (!method) return 1;
  const double ik_ns = minOf(count, [&](std::size_t i) {
    if (!kinematics::readPose(X[i], poses[i]).empty()) return;
    for (const kinematics::Found& one : kinematics::solve(arm.value(), poses[i], method.value(), options).found) {
      kinematics::writeJoints(arm.value().chain(), one.q, solutions[8 * i + found++ % 8]);
      within += arm::isWithinLimits(arm.value().model, std::span(one.q).first(6)) ? 1 : 0;
    }
  });
  std::printf("fk %.1f\njacobian %.1f\nik %.1f\n", fk_ns, jacobian_ns, ik_ns);
  return found > 0 && within <= found ? 0 : 1;
}
