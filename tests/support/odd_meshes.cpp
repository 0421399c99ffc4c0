#include "tests/support/odd_meshes.h"

#include <cmath>
#include <functional>

#include "scenes/meshes/make/meshes.h"
#include "tests/support/random.h"

namespace underact::test {
namespace {

using mesh::Triangles;

void add(Triangles& all, const Triangles& more) {
  const auto first = static_cast<std::int32_t>(all.p_MV.size());
  all.p_MV.insert(all.p_MV.end(), more.p_MV.begin(), more.p_MV.end());
  for (const mesh::Face& face : more.faces) all.faces.push_back({face[0] + first, face[1] + first, face[2] + first});
}

Triangles moved(Triangles triangles, const std::function<Vec3(const Vec3&)>& to) {
  for (Eigen::Vector3f& p_MV : triangles.p_MV) p_MV = to(p_MV.cast<double>()).cast<float>();
  return triangles;
}

Triangles one(const Vec3& a, const Vec3& b, const Vec3& c) {
  return {{a.cast<float>(), b.cast<float>(), c.cast<float>()}, {{0, 1, 2}}};
}

/// n x m squares of a sheet, at(i, j) their corners.
Triangles sheet(int n, int m, const std::function<Vec3(int, int)>& at) {
  Triangles made;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= m; ++j) made.p_MV.push_back(at(i, j).cast<float>());
  }
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < m; ++j) {
      const int a = i * (m + 1) + j, b = a + m + 1;
      made.faces.push_back({a, b, b + 1});
      made.faces.push_back({a, b + 1, a + 1});
    }
  }
  return made;
}

/// Flat triangles: two corners on the edge of a strip, the third a millionth of it away from the line between them.
Triangles slivers() {
  Triangles all;
  for (int i = 0; i < 200; ++i) {
    const double y = 0.2 * i;
    add(all, one({-40, y, 0}, {40, y, 0}, {0.37 * i - 37, y + 8e-5, 0}));
  }
  return all;
}

/// Off the axes, where no difference of coordinates is zero.
Vec3 slanted(const Vec3& p) {
  return Eigen::AngleAxisd(1.0, Vec3(0.6, 0.0, 0.8)) * p;
}

Triangles fan() {
  Triangles made;
  made.p_MV.emplace_back(0.0F, 0.0F, 5.0F);
  constexpr int kBlades = 10000;
  for (int i = 0; i < kBlades; ++i) {
    const double turn = 6.283185307179586 * i / kBlades;
    made.p_MV.push_back(Vec3(40 * std::cos(turn), 40 * std::sin(turn), 0).cast<float>());
    made.faces.push_back({0, i + 1, (i + 1) % kBlades + 1});
  }
  return made;
}

Triangles overlaps() {
  Random random(Seed{20070610});
  Triangles all;
  const auto flat = [&] { return Vec3(random.between(-40, 40), random.between(-40, 40), 0); };
  for (int i = 0; i < 300; ++i) add(all, one(flat(), flat(), flat()));
  return all;
}

Triangles tetrahedron(const Vec3& at, double size) {
  Triangles made{{}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  for (const Vec3& p : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
    made.p_MV.push_back((at + size * p).cast<float>());
  }
  return made;
}

Triangles scattered() {
  Triangles all;
  for (int i = 0; i < 125; ++i) add(all, tetrahedron(16.0 * Vec3(i % 5 - 2, i / 5 % 5 - 2, i / 25 - 2), 1.0 + 0.1 * i));
  return all;
}

/// Each face with corners of its own.
Triangles soup(const Triangles& triangles) {
  Triangles made;
  for (const mesh::Face& face : triangles.faces) {
    const auto first = static_cast<std::int32_t>(made.p_MV.size());
    for (const std::int32_t corner : face) made.p_MV.push_back(triangles.p_MV[static_cast<std::size_t>(corner)]);
    made.faces.push_back({first, first + 1, first + 2});
  }
  return made;
}

/// Five sheets at one edge, as the pages of a book.
Triangles pages() {
  Triangles made{{{0, -30, 0}, {0, 30, 0}}, {}};
  for (int page = 0; page < 5; ++page) {
    const double turn = 0.7 * page;
    made.p_MV.push_back(Vec3(40 * std::cos(turn), 0, 40 * std::sin(turn)).cast<float>());
    made.faces.push_back({0, 1, page + 2});
  }
  return made;
}

Triangles times(const Triangles& triangles, int count) {
  Triangles made = triangles;
  for (int i = 1; i < count; ++i) made.faces.insert(made.faces.end(), triangles.faces.begin(), triangles.faces.end());
  return made;
}

/// A sheet with rows of no width: faces that are lines, and some that are points.
Triangles creased() {
  return sheet(24, 24, [](int i, int j) { return Vec3(4.0 * (i / 2), 4.0 * (j / 3), i / 2 % 2); });
}

Triangles largeAndSmall() {
  Triangles all = one({-4000, -4000, -1}, {4000, -4000, -1}, {0, 6000, -1});
  add(all, moved(mesh_maker::bumpySphere(2000), [](const Vec3& p) -> Vec3 { return 0.1 * p; }));
  return all;
}

}  // namespace

std::vector<OddMesh> oddMeshes() {
  using mesh_maker::bumpySphere, mesh_maker::cube;
  const Triangles ball = moved(bumpySphere(20000), [](const Vec3& p) -> Vec3 { return 40.0 * p.normalized(); });
  return {
      {"one triangle", one({0, 0, 0}, {30, 0, 0}, {0, 40, 5}), false},
      {"a face that is a line", one({-10, 0, 0}, {0, 5, 0}, {10, 10, 0}), false},
      {"a face that is a point", one({1, 2, 3}, {1, 2, 3}, {1, 2, 3}), false},
      {"slivers", slivers(), false},
      {"slivers at a slant", moved(slivers(), slanted), false},
      {"needles", sheet(1, 200, [](int i, int j) { return Vec3(80.0 * i, 8e-5 * j, 4e-5 * (j % 2)); }), false},
      {"fan", fan(), false},
      {"every face three times", times(cube(300), 3), false},
      {"one face fifty thousand times", times(one({0, 0, 0}, {30, 0, 0}, {0, 40, 5}), 50000), false},
      {"overlaps in a plane", overlaps(), false},
      {"scattered pieces", scattered(), true},
      {"thin plate", mesh_maker::plate(1.0, 2000), true},
      {"wedge", mesh_maker::wedge(2000), true},
      {"cube of twelve", cube(12), true},
      {"soup", soup(cube(1000)), false},
      {"a million off", moved(bumpySphere(2000), [](const Vec3& p) -> Vec3 { return p + 1e6 * Vec3::Ones(); }), false},
      {"tiny", moved(bumpySphere(2000), [](const Vec3& p) -> Vec3 { return 1e-6 * p; }), true},
      {"pages", pages(), false},
      {"flat grid", sheet(64, 64, [](int i, int j) { return Vec3(i - 32, j - 32, 0); }), false},
      {"creased", creased(), false},
      {"ball", ball, true},
      {"large and small", largeAndSmall(), false},
  };
}

}  // namespace underact::test
