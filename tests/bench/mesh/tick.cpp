// underact-mesh-tick-bench [POINTS]: the whole tick on a mesh, along a hand's path: kinematics, proxy or nearest point,
// friction, law, limits, gate. And by how much the force steps from tick to tick. Times are this machine's, now.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <vector>

#include "core/base/units.h"
#include "core/mesh/surface.h"
#include "scenes/meshes/make/meshes.h"
#include "tests/bench/mesh/party.h"
#include "tests/support/mesh_points.h"
#include "tests/support/tick_hand.h"

namespace underact::bench {
namespace {

using Angles = std::vector<arm::JointAngles>;

/// Ticks along a path, one a call; each gives the step of the force, N.
class Ticks {
 public:
  Ticks(const tick::Entry& entry, std::shared_ptr<const Angles> path)
      : hand_({entry}, tick::Combine::Sum), path_(std::move(path)) {}
  double operator()(const Vec3& /*point*/) {
    const Vec3 f_T_W = hand_.feed((*path_)[next_++]).held[0].f_T_W;
    const double step_N = (f_T_W - last_W_).norm();
    last_W_ = f_T_W;
    return step_N;
  }

 private:
  test::Hand hand_;
  std::shared_ptr<const Angles> path_;
  std::size_t next_ = 0;
  Vec3 last_W_ = Vec3::Zero();
};

struct CrossingDirection {
  const char* name;
  target::Side side;
  mesh::Search search;
  target::Friction friction;
  double smooth_deg;
};

constexpr target::Friction kRough{0.4, 0.3};
constexpr CrossingDirection kDirections[] = {
    {"wall", target::Side::Outside, mesh::Search::Hybrid, {}, 0.0},
    {"wall, friction", target::Side::Outside, mesh::Search::Hybrid, kRough, 0.0},
    {"wall, smoothed 20 deg", target::Side::Outside, mesh::Search::Hybrid, {}, 20.0},
    {"held, hybrid", target::Side::Both, mesh::Search::Hybrid, {}, 0.0},
    {"held, global", target::Side::Both, mesh::Search::Global, {}, 0.0},
    {"held, local", target::Side::Both, mesh::Search::Local, {}, 0.0},
    {"held, hybrid, friction", target::Side::Both, mesh::Search::Hybrid, kRough, 0.0}};

void timeTicks(int faces, int points) {
  const mesh::Triangles triangles = mesh_maker::bumpySphere(faces);
  target::MeshPlace place;
  place.surface = mesh::makeSurface(triangles).value();
  place.scale_m = kMetrePerMillimetre;
  const std::vector<Vec3> path_mm = test::handPath(triangles, 1.0, points, test::Seed{20070702});
  const auto angles = std::make_shared<Angles>();
  for (const Vec3& q_mm : path_mm)
    angles->push_back(arm::solvePosition(test::thesisGeometry(), kMetrePerMillimetre * q_mm).q_rad);
  const auto tell = [&](const char* name, const tick::Entry& entry) {
    std::vector<double> steps_N;
    const Times times = timesOf(path_mm, Ticks(entry, angles), steps_N);
    std::printf("%8d  %-24s %8.2f %8.2f %10.0f %8.0f\n", faces, name, times.p50_us, times.p99_us,
                1e3 * shareOf(steps_N, 0.99), 1e3 * shareOf(steps_N, 1.0));
  };
  const control::P law{Vec3::Constant(500.0)};
  for (const CrossingDirection& direction : kDirections) {
    tick::Entry entry{{}, law};
    place.search = direction.search;
    place.lean = mesh::forceShadingOf(kRadPerDegree * direction.smooth_deg);
    entry.constraint.goal = place;
    entry.constraint.side = direction.side;
    entry.constraint.friction = direction.friction;
    tell(direction.name, entry);
  }
  const double radius_m = kMetrePerMillimetre * mesh_maker::kBall_mm;
  tell("no mesh: a sphere, wall",
       test::hold(shape::makeSphere(Vec3::Zero(), radius_m, {}).value(), law, target::Side::Outside));
}

}  // namespace
}  // namespace underact::bench

int main(int count, char** words) {
  const int points = count > 1 ? std::max(100, std::atoi(words[1])) : 10000;
  std::printf("%8s  %-24s %17s %19s\n", "", "", "tick, us", "force step, mN");
  std::printf("%8s  %-24s %8s %8s %10s %8s\n", "faces", "bumpy ball", "p50", "p99", "p99", "most");
  for (const int faces : {20480, 327680, 1310720}) underact::bench::timeTicks(faces, points);
  return 0;
}
