#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "core/base/trig.h"
#include "core/base/types.h"
#include "scenes/meshes/make/meshes.h"

namespace underact::mesh_maker {
namespace {

constexpr double kGolden = 1.618033988749895;
constexpr double kGoldenAngle_rad = 2.399963229728653;

const std::array<Vec3, 12> kCorners{Vec3(-1, kGolden, 0),  Vec3(1, kGolden, 0),   Vec3(-1, -kGolden, 0),
                                    Vec3(1, -kGolden, 0),  Vec3(0, -1, kGolden),  Vec3(0, 1, kGolden),
                                    Vec3(0, -1, -kGolden), Vec3(0, 1, -kGolden),  Vec3(kGolden, 0, -1),
                                    Vec3(kGolden, 0, 1),   Vec3(-kGolden, 0, -1), Vec3(-kGolden, 0, 1)};
constexpr std::array<mesh::Face, 20> kSides{
    mesh::Face{0, 11, 5}, {0, 5, 1},  {0, 1, 7}, {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4}, {11, 10, 2},
    {10, 7, 6},           {7, 1, 8},  {3, 9, 4}, {3, 4, 2},  {3, 2, 6},   {3, 6, 8}, {3, 8, 9},  {4, 9, 5},
    {2, 4, 11},           {6, 2, 10}, {8, 6, 7}, {9, 8, 1}};

/// Directions of the crests: evenly over the ball, by a spiral of golden angles.
std::array<Vec3, kBumps> crests() {
  std::array<Vec3, kBumps> all;
  for (int i = 0; i < kBumps; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / kBumps, off_axis = std::sqrt(1.0 - z * z);
    const SinCos turn = sinCos(kGoldenAngle_rad * i);
    all[static_cast<std::size_t>(i)] = {off_axis * turn.cos, off_axis * turn.sin, z};
  }
  return all;
}

Eigen::Vector3f bumped(const std::array<Vec3, kBumps>& crests_M, const Vec3& towards_M) {
  const Vec3 unit_M = towards_M.normalized();
  double squared = 4.0;
  for (const Vec3& crest_M : crests_M) squared = std::min(squared, (crest_M - unit_M).squaredNorm());
  // (1 - x^2)^2 ends with no slope at its foot, x = 1.
  const double foot = std::max(0.0, 1.0 - squared * (kBall_mm * kBall_mm) / (kBumpRadius_mm * kBumpRadius_mm));
  return ((kBall_mm + kBumpHeight_mm * foot * foot) * unit_M).cast<float>();
}

/// The corners of an icosahedron's sides cut in n, each made once where sides meet.
class Ball {
 public:
  explicit Ball(int n) : n_(n) {
    for (std::size_t i = 0; i < kCorners.size(); ++i) add(kCorners[i]);
  }

  /// Of side ABC: a parts of A, b of B, c of C; a + b + c = n.
  int corner(const mesh::Face& side, int a, int b, int c, std::vector<int>& inside) {
    if (a == n_) return side[0];
    if (b == n_) return side[1];
    if (c == n_) return side[2];
    const Vec3 towards_M = a * at(side[0]) + b * at(side[1]) + c * at(side[2]);
    if (c == 0) return onEdge(side[0], side[1], b, towards_M);
    if (a == 0) return onEdge(side[1], side[2], c, towards_M);
    if (b == 0) return onEdge(side[2], side[0], a, towards_M);
    int& made = inside[static_cast<std::size_t>(b * n_ + c)];
    if (made < 0) made = add(towards_M);
    return made;
  }

  Triangles triangles;

 private:
  static const Vec3& at(int corner) { return kCorners[static_cast<std::size_t>(corner)]; }

  int add(const Vec3& towards_M) {
    triangles.p_MV.push_back(bumped(crests_, towards_M));
    return static_cast<int>(triangles.p_MV.size()) - 1;
  }

  int onEdge(int from, int to, int parts, const Vec3& towards_M) {
    if (from > to) return onEdge(to, from, n_ - parts, towards_M);
    std::vector<int>& made = edges_[{from, to}];
    made.resize(static_cast<std::size_t>(n_), -1);
    int& corner = made[static_cast<std::size_t>(parts)];
    if (corner < 0) corner = add(towards_M);
    return corner;
  }

  int n_;
  std::array<Vec3, kBumps> crests_ = crests();
  std::map<std::pair<int, int>, std::vector<int>> edges_;
};

}  // namespace

Triangles bumpySphere(int faces) {
  const int n = std::max(1, static_cast<int>(std::lround(std::sqrt(faces / 20.0))));
  Ball ball(n);
  for (const mesh::Face& side : kSides) {
    std::vector<int> inside(static_cast<std::size_t>(n * n), -1);
    const auto corner = [&](int b, int c) { return ball.corner(side, n - b - c, b, c, inside); };
    for (int b = 0; b < n; ++b) {
      for (int c = 0; b + c < n; ++c) {
        ball.triangles.faces.push_back({corner(b, c), corner(b + 1, c), corner(b, c + 1)});
        if (b + c + 1 == n) continue;
        ball.triangles.faces.push_back({corner(b + 1, c), corner(b + 1, c + 1), corner(b, c + 1)});
      }
    }
  }
  return ball.triangles;
}

}  // namespace underact::mesh_maker
