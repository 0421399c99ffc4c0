// underact-mesh-union-bench [POINTS | --write FOLDER]: the two ways to make a wall of a mesh that intersects itself.
// Either the surface of its union is made when it is loaded; or each tick asks for the winding number of the mesh as it
// is, by a ray, by the faces between the last tip and this one, by a tree of dipoles (Barill and others 2018, Fast
// winding numbers for soups and clouds), or by all solid angles. Times per tick of inside or outside alone, and for the
// union of the proxy too. Then the proxy on bodies of boxes that intersect, beside surfaces of the same bodies made by
// hand. Times are this machine's.
#include "core/mesh_union/union.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/mesh/crossing.h"
#include "core/mesh/proxy.h"
#include "tests/bench/mesh/party.h"
#include "tests/support/crossed_bodies.h"
#include "tests/support/mesh_oracle.h"
#include "tests/support/mesh_points.h"

namespace underact::bench {
namespace {

using mesh::Surface;
using mesh::Triangles;

constexpr double kWeld = 5e-5;  // a millionth of the diagonal of these bodies, as the reader takes it

/// Sums of dipoles, of the first order, over a tree of faces; near ones by their solid angles.
class DipoleTree {
 public:
  explicit DipoleTree(const Triangles& triangles) : triangles_(triangles) {
    for (std::size_t face = 0; face < triangles.faces.size(); ++face) order_.push_back(face);
    grow(0, order_.size());
  }
  double winding(const Vec3& q) const { return windingAt(0, q) / (4.0 * 3.14159265358979323846); }

 private:
  static constexpr double kFar = 2.0;  // radii, as in the paper
  struct Node {
    Vec3 centre, area;
    double radius;
    std::size_t begin, end, second;  // second: child; 0: none. The first one follows.
  };
  Vec3 corner(std::size_t face, std::size_t k) const { return cornerAt(triangles_, triangles_.faces[face][k]); }
  Vec3 middle(std::size_t face) const { return (corner(face, 0) + corner(face, 1) + corner(face, 2)) / 3.0; }

  void grow(std::size_t begin, std::size_t end) {
    Node node{Vec3::Zero(), Vec3::Zero(), 0.0, begin, end, 0};
    Vec3 low = Vec3::Constant(kInfinity), high = -low;
    double sum = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t face = order_[i];
      const Vec3 area = 0.5 * (corner(face, 1) - corner(face, 0)).cross(corner(face, 2) - corner(face, 0));
      node.area += area;
      node.centre += area.norm() * middle(face);
      sum += area.norm();
      low = low.cwiseMin(middle(face));
      high = high.cwiseMax(middle(face));
    }
    node.centre /= sum;
    for (std::size_t i = begin; i < end; ++i) {
      for (std::size_t k = 0; k < 3; ++k)
        node.radius = std::max(node.radius, (corner(order_[i], k) - node.centre).norm());
    }
    const std::size_t place = nodes_.size();
    nodes_.push_back(node);
    if (end - begin <= 8) return;
    Eigen::Index axis = 0;
    (high - low).maxCoeff(&axis);
    const std::size_t half = (begin + end) / 2;
    const auto at = [this](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(half), at(end),
                     [&](std::size_t a, std::size_t b) { return middle(a)[axis] < middle(b)[axis]; });
    grow(begin, half);
    nodes_[place].second = nodes_.size();
    grow(half, end);
  }

  double windingAt(std::size_t place, const Vec3& q) const {
    const Node& node = nodes_[place];
    const Vec3 to = node.centre - q;
    const double far = to.norm();
    if (far > kFar * node.radius) return node.area.dot(to) / (far * far * far);
    if (node.second != 0) return windingAt(place + 1, q) + windingAt(node.second, q);
    double sum = 0.0;
    for (std::size_t i = node.begin; i < node.end; ++i) sum += solidAngle(order_[i], q);
    return sum;
  }

  double solidAngle(std::size_t face, const Vec3& q) const {
    const Vec3 a = corner(face, 0) - q, b = corner(face, 1) - q, c = corner(face, 2) - q;
    const double x = a.norm(), y = b.norm(), z = c.norm();
    return 2.0 * std::atan2(a.dot(b.cross(c)), x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y);
  }

  const Triangles& triangles_;
  std::vector<std::size_t> order_;
  std::vector<Node> nodes_;
};

/// The winding number at a tip from that at the last one: how often it was left is how often it was entered.
class Warm {
 public:
  explicit Warm(const Surface& surface) : surface_(surface) {}
  double operator()(const Vec3& q) {
    if (!knows_last_) {
      winding_ = netCrossings(surface_, q, q + Vec3(577.3, 211.3, 788.7));
    } else {
      winding_ -= netCrossings(surface_, last_, q);
    }
    last_ = q;
    knows_last_ = true;
    return winding_;
  }

 private:
  const Surface& surface_;
  bool knows_last_ = false;
  Vec3 last_ = Vec3::Zero();
  int winding_ = 0;
};

class Proxy {
 public:
  explicit Proxy(const Surface& surface) : surface_(surface) {}
  double operator()(const Vec3& q) {
    return mesh::followProxy(surface_, mesh::FreeSide::Outside, q, state_).face >= 0 ? 1.0 : 0.0;
  }

 private:
  const Surface& surface_;
  mesh::ProxyState state_;
};

/// What a way says beside the winding number in long doubles, at points off the faces.
struct Truth {
  std::vector<int> inside;  // -1: too near to a face to say
};

Truth truthOf(const Triangles& given, const std::vector<Vec3>& points) {
  const test::MeshOracle oracle(given);
  Truth truth;
  for (const Vec3& q : points)
    truth.inside.push_back(oracle.distance(q) < 20.0 * kWeld ? -1 : test::windingOf(given, q) > 0.5L ? 1 : 0);
  return truth;
}

template <class Ask>
void tell(const char* name, double load_ms, const std::vector<Vec3>& path, const Truth& truth, const Ask& ask) {
  std::vector<double> answers;
  const Times times = timesOf(path, ask, answers);
  if constexpr (std::is_same_v<Ask,
                               Proxy>) {  // one that follows holds on behind thin parts: each point as the first one
    for (std::size_t i = 0; i < path.size(); ++i) answers[i] = Ask(ask)(path[i]);
  }
  int wrong = 0, asked = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (truth.inside[i] < 0) continue;
    ++asked;
    wrong += (answers[i] > 0.5) != (truth.inside[i] == 1) ? 1 : 0;
  }
  std::printf("  %-34s %9.3f %9.3f %9.2f   %d of %d\n", name, times.p50_us, times.p99_us, load_ms, wrong, asked);
}

std::shared_ptr<const Surface> surfaceOf(const Triangles& triangles) {
  return mesh::makeSurface(triangles).value();
}

void compareVariants(const Triangles& given, int points) {
  Triangles united = given;
  const Clock::time_point begin = Clock::now();
  const mesh_union::Union made = mesh_union::unite(united, 0.25 * kWeld, 2.0 * kWeld, {});
  const double union_ms = since_us(begin) / 1e3;
  const std::shared_ptr<const Surface> felt = mesh::asUnited(*surfaceOf(united)), as_it_is = surfaceOf(given);
  std::printf("%zu faces, %lld pairs intersect, %zu faces felt\n", given.faces.size(),
              static_cast<long long>(made.crossings), united.faces.size());
  std::printf("  %-34s %9s %9s %9s   wrong\n", "", "p50, us", "p99, us", "load, ms");
  const std::vector<Vec3> path = test::handPath(united, 1.0, points, test::Seed{20070702});
  const Truth truth = truthOf(given, path);
  tell("union at load, with the proxy", union_ms, path, truth, Proxy(*felt));
  tell("winding number by a ray", 0.0, path, truth,
       [&](const Vec3& q) { return netCrossings(*as_it_is, q, q + Vec3(577.3, 211.3, 788.7)); });
  tell("winding number, warm", 0.0, path, truth, Warm(*as_it_is));
  const Clock::time_point grown = Clock::now();
  const DipoleTree tree(given);
  const double tree_ms = since_us(grown) / 1e3;
  tell("winding number by dipoles", tree_ms, path, truth, [&](const Vec3& q) { return tree.winding(q); });
}

/// Boxes with whole coordinates, as one mesh that intersects itself; and the boundary of the unit cubes that they fill.
struct ByHand {
  Triangles crossed, made;
};

ByHand bodyByHand(const std::vector<std::pair<Eigen::Vector3i, Eigen::Vector3i>>& boxes) {
  std::vector<Triangles> parts;
  Eigen::Vector3i low = boxes[0].first, high = boxes[0].second;
  for (const auto& [from, to] : boxes) {
    parts.push_back(test::boxOf(from.cast<double>(), to.cast<double>()));
    low = low.cwiseMin(from);
    high = high.cwiseMax(to);
  }
  const auto isIn = [&](const Eigen::Vector3i& cube) {
    for (const auto& [from, to] : boxes) {
      if ((cube.array() >= from.array()).all() && (cube.array() < to.array()).all()) return true;
    }
    return false;
  };
  Triangles made;
  const Eigen::Vector3i size = high - low + Eigen::Vector3i::Ones();
  std::vector<std::int32_t> numbers(static_cast<std::size_t>(size.prod()), -1);
  const auto corner = [&](const Eigen::Vector3i& p) {
    const Eigen::Vector3i at = p - low;
    std::int32_t& number = numbers[static_cast<std::size_t>((at.z() * size.y() + at.y()) * size.x() + at.x())];
    if (number < 0) {
      number = static_cast<std::int32_t>(made.p_MV.size());
      made.p_MV.push_back(p.cast<float>());
    }
    return number;
  };
  Eigen::Vector3i cube;
  for (cube.z() = low.z(); cube.z() < high.z(); ++cube.z()) {
    for (cube.y() = low.y(); cube.y() < high.y(); ++cube.y()) {
      for (cube.x() = low.x(); cube.x() < high.x(); ++cube.x()) {
        if (!isIn(cube)) continue;
        for (int side = 0; side < 6; ++side) {
          const int axis = side / 2;
          Eigen::Vector3i out = Eigen::Vector3i::Zero(), u = out, v = out;
          out[axis] = side % 2 == 0 ? -1 : 1;
          if (isIn(cube + out)) continue;
          u[(axis + 1) % 3] = 1;
          v[(axis + 2) % 3] = 1;
          if (side % 2 == 0) std::swap(u, v);
          const Eigen::Vector3i p = cube + out.cwiseMax(0);
          const std::int32_t a = corner(p), b = corner(p + u), c = corner(p + u + v), d = corner(p + v);
          made.faces.insert(made.faces.end(), {{a, b, c}, {a, c, d}});
        }
      }
    }
  }
  return {test::together(parts), made};
}

void compareWithHandmade(const char* name, const ByHand& body, int points) {
  Triangles united = body.crossed;
  mesh_union::unite(united, 0.25 * kWeld, 2.0 * kWeld, {});
  const std::vector<Vec3> path = test::handPath(body.made, 1.0, points, test::Seed{20070702});
  std::vector<double> ours, theirs;
  const std::shared_ptr<const Surface> felt = mesh::asUnited(*surfaceOf(united)), made = surfaceOf(body.made);
  const Times of_made = timesOf(path, Proxy(*made), theirs), of_union = timesOf(path, Proxy(*felt), ours);
  const Truth truth = truthOf(body.crossed, path);
  int different = 0, right = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (ours[i] == theirs[i] || truth.inside[i] < 0) continue;
    ++different;
    right += ours[i] == truth.inside[i] ? 1 : 0;
  }
  std::printf("  %-22s %7zu %7zu   %6.3f %6.3f   %6.3f %6.3f   %5.2f   %d (%d)\n", name, united.faces.size(),
              body.made.faces.size(), of_union.p50_us, of_union.p99_us, of_made.p50_us, of_made.p99_us,
              of_union.p99_us / of_made.p99_us, different, right);
}

void compareBodies(int points) {
  test::Random random(test::Seed{20070601});
  for (const int parts : {6, 30}) compareVariants(test::drawnBody(random, parts), points);
  std::vector<Triangles> balls;
  for (int k = 0; k < 12; ++k)
    balls.push_back(test::moved(test::roundOf(12.0, 4), Mat3::Identity(), random.inBox(15.0)));
  compareVariants(test::together(balls), points);
  std::printf("\n  %-22s %7s %7s   %-13s   %-13s   %5s   different (of these right)\n", "the proxy, us (p50, p99)",
              "faces", "by hand", "united", "by hand", "p99");
  compareWithHandmade("two boxes", bodyByHand({{{-20, -20, -20}, {20, 20, 0}}, {{0, -20, -10}, {20, 20, 20}}}), points);
  compareWithHandmade(
      "three bars", bodyByHand({{{-20, -5, -5}, {20, 5, 5}}, {{-5, -20, -5}, {5, 20, 5}}, {{-5, -5, -20}, {5, 5, 20}}}),
      points);
  std::vector<std::pair<Eigen::Vector3i, Eigen::Vector3i>> boxes;
  for (int k = 0; k < 30; ++k) {
    Eigen::Vector3i from, to;
    for (int axis = 0; axis < 3; ++axis) {
      from[axis] = static_cast<int>(random.below(30)) - 20;
      to[axis] = from[axis] + 4 + static_cast<int>(random.below(12));
    }
    boxes.emplace_back(from, to);
  }
  compareWithHandmade("30 boxes", bodyByHand(boxes), points);
}

void writeOff(const Triangles& triangles, const std::string& path) {
  std::ofstream file(path);
  file << "OFF\n" << triangles.p_MV.size() << ' ' << triangles.faces.size() << " 0\n" << std::setprecision(9);
  for (const Eigen::Vector3f& p : triangles.p_MV) file << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  for (const auto& [a, b, c] : triangles.faces) file << "3 " << a << ' ' << b << ' ' << c << '\n';
}

void writeBody(const std::string& folder) {
  const auto turned = [](double angle_deg, const Vec3& size, const Vec3& at) {
    const Mat3 R = Eigen::AngleAxisd(angle_deg * 3.14159265358979323846 / 180.0, Vec3::UnitY()).toRotationMatrix();
    return test::moved(test::boxOf(-0.5 * size, 0.5 * size), R, at);
  };
  // A handle on a body: as an engine of physics would have it, of convex parts.
  Triangles body = test::together({turned(0, {24, 30, 40}, {-10, 0, 0}), turned(35, {26, 16, 9}, {8, 0, 16}),
                                   turned(90, {24, 16, 9}, {19, 0, 0}), turned(-35, {26, 16, 9}, {8, 0, -15}),
                                   test::moved(test::roundOf(13.0, 3), Mat3::Identity(), {-12, 0, 20})});
  writeOff(body, folder + "/given.off");
  mesh_union::unite(body, 0.25 * kWeld, 2.0 * kWeld, {});
  writeOff(body, folder + "/felt.off");
}

}  // namespace
}  // namespace underact::bench

int main(int count, char** words) {
  if (count == 3 && std::string(words[1]) == "--write") {
    underact::bench::writeBody(words[2]);
  } else {
    underact::bench::compareBodies(count > 1 ? std::max(100, std::atoi(words[1])) : 4000);
  }
  return 0;
}
