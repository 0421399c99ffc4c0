#include <memory>

#include "scenes/meshes/make/meshes.h"
#include "scenes/meshes/make/patches.h"

namespace underact::mesh_maker {
namespace {

/// A flat quadrangle, counterclockwise as seen from outside. Corners: whole numbers or halves, so that what two
/// quadrangles say of their common edge is the same number, correctly rounded.
Patch quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, int across, int along) {
  return {across, along, false, [=](int i, int j) -> Vec3 {
            const Vec3 low = (across - i) * a + i * b, high = (across - i) * d + i * c;
            return ((along - j) * low + j * high) / (static_cast<double>(across) * along);
          }};
}

/// A solid between y = -depth / 2 and depth / 2 whose section in x and z is columns: from left to right, low and high.
struct Column {
  double x, low, high;
};

std::vector<Patch> prism(const std::vector<Column>& columns, double depth, double cell_mm) {
  const double near = -0.5 * depth, far = 0.5 * depth;
  const int deep = cuts(depth, cell_mm), tall = cuts(columns.front().high - columns.front().low, cell_mm);
  std::vector<Patch> all;
  for (std::size_t i = 0; i + 1 < columns.size(); ++i) {
    const Column &l = columns[i], &r = columns[i + 1];
    const int wide = cuts(r.x - l.x, cell_mm);
    const Vec3 a(l.x, near, l.low), b(r.x, near, r.low), c(r.x, near, r.high), d(l.x, near, l.high);
    const Vec3 back = (far - near) * Vec3::UnitY();
    all.push_back(quad(a, b, c, d, wide, tall));
    all.push_back(quad(b + back, a + back, d + back, c + back, wide, tall));
    all.push_back(quad(d, c, c + back, d + back, wide, deep));
    all.push_back(quad(b, a, a + back, b + back, wide, deep));
    if (i == 0) all.push_back(quad(a + back, a, d, d + back, deep, tall));
    if (i + 2 == columns.size()) all.push_back(quad(b, b + back, c + back, c, deep, tall));
  }
  return all;
}

}  // namespace

Triangles plate(double thickness_mm, int faces) {
  const double half = 0.5 * thickness_mm;
  return ofFaces(faces, 2.0 * 80.0 * 60.0 + 280.0 * thickness_mm, [&](double cell_mm) {
    return prism({{-40, -half, half}, {40, -half, half}}, 60.0, cell_mm);
  });
}

Triangles cube(int faces) {
  return ofFaces(faces, 6.0 * 60.0 * 60.0, [](double cell_mm) {
    return prism({{-30, -30, 30}, {30, -30, 30}}, 60.0, cell_mm);
  });
}

Triangles wedge(int faces) {
  return ofFaces(faces, 21000.0, [](double cell_mm) {
    return prism({{-40, -20, 20}, {-20, -20, 20}, {0, -20, -10}, {20, -20, 20}, {40, -20, 20}}, 60.0, cell_mm);
  });
}

}  // namespace underact::mesh_maker
