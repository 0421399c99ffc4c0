#include <cmath>
#include <memory>

#include "scenes/meshes/make/meshes.h"
#include "scenes/meshes/make/patches.h"

namespace underact::mesh_maker {
namespace {

constexpr int kX = 0, kY = 1, kZ = 2;
constexpr double kFootHole_mm = 7.0, kWallHole_mm = 4.5;  // radii
constexpr Parts kAllX{0, 5}, kAllY{0, 5}, kThickX{0, 1}, kThickZ{0, 1};
constexpr Parts kRibX{1, 2}, kRibY{2, 3}, kRibZ{1, 2};
constexpr Parts kFootHoleX{3, 4}, kHoleY{1, 4}, kWallHoleZ{2, 3};

// Where parts begin, from the middle of the whole: whole numbers, so that floats hold them.
const std::vector<double> kBreaksX{-45, -37, -1, 9, 33, 45};  // wall, rib, between, hole, end
const std::vector<double> kBreaksY{-30, -12, -4, 4, 12, 30};  // the rib in the midst, the holes about it
const std::vector<double> kBreaksZ{-25, -17, 11, 25};         // foot, rib, hole

Rulers rulersOf(double cell_mm) {
  const auto counts = [&](const std::vector<double>& breaks) {
    std::vector<int> all;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) all.push_back(cuts(breaks[i + 1] - breaks[i], cell_mm));
    return all;
  };
  std::vector<int> x = counts(kBreaksX), z = counts(kBreaksZ);
  // The rib's three edges, of 36, 28 and 46 mm, are cut alike: then its side is rows of triangles.
  x[1] = z[1] = cuts(36.0, cell_mm);
  return {{Ruler(kBreaksX, x), Ruler(kBreaksY, counts(kBreaksY)), Ruler(kBreaksZ, z)}};
}

/// A foot or a wall seen from one of its sides: its parts about the hole and the rib, and the ring about the hole.
void addFoot(const Rulers& rulers, double cell_mm, std::vector<Patch>& all) {
  const int along = cuts(5.0, cell_mm);  // 12 - 7 mm: the narrowest place of the ring
  const double top = kBreaksZ[1], bottom = kBreaksZ[0];
  const auto top_part = [&](Parts x, Parts y) { all.push_back(rulers.flat(kX, kY, top, x, y)); };
  const auto bottom_part = [&](Parts x, Parts y) { all.push_back(rulers.flat(kY, kX, bottom, y, x)); };
  top_part(kRibX, {0, 2});
  top_part(kRibX, {3, 5});
  top_part({2, 3}, kAllY);
  bottom_part({0, 3}, kAllY);
  for (const auto& part :
       {std::function<void(Parts, Parts)>(top_part), std::function<void(Parts, Parts)>(bottom_part)}) {
    part(kFootHoleX, {0, 1});
    part(kFootHoleX, {4, 5});
    part({4, 5}, kAllY);
  }
  all.push_back(rulers.ring(kX, kY, top, kFootHoleX, kHoleY, kFootHole_mm, along));
  all.push_back(rulers.ring(kY, kX, bottom, kHoleY, kFootHoleX, kFootHole_mm, along));
  all.push_back(rulers.holeWall(kX, kY, kThickZ, kFootHoleX, kHoleY, kFootHole_mm));
  all.push_back(rulers.flat(kY, kZ, kBreaksX[5], kAllY, kThickZ));
}

void addWall(const Rulers& rulers, double cell_mm, std::vector<Patch>& all) {
  const int along = cuts(5.0, cell_mm);  // 7 - 4.5 mm at the narrowest, 9.4 mm at the corners
  const double inner = kBreaksX[1], outer = kBreaksX[0];
  all.push_back(rulers.flat(kY, kZ, inner, {0, 2}, kRibZ));
  all.push_back(rulers.flat(kY, kZ, inner, {3, 5}, kRibZ));
  all.push_back(rulers.flat(kZ, kY, outer, {0, 2}, kAllY));
  for (const Parts y : {Parts{0, 1}, Parts{4, 5}}) {
    all.push_back(rulers.flat(kY, kZ, inner, y, kWallHoleZ));
    all.push_back(rulers.flat(kZ, kY, outer, kWallHoleZ, y));
  }
  all.push_back(rulers.ring(kY, kZ, inner, kHoleY, kWallHoleZ, kWallHole_mm, along));
  all.push_back(rulers.ring(kZ, kY, outer, kWallHoleZ, kHoleY, kWallHole_mm, along));
  all.push_back(rulers.holeWall(kY, kZ, kThickX, kHoleY, kWallHoleZ, kWallHole_mm));
  all.push_back(rulers.flat(kX, kY, kBreaksZ[3], kThickX, kAllY));
}

void addEnds(const Rulers& rulers, std::vector<Patch>& all) {
  for (const bool far : {false, true}) {
    const auto end = [&](Parts x, Parts z) {
      all.push_back(far ? rulers.flat(kZ, kX, kBreaksY[5], z, x) : rulers.flat(kX, kZ, kBreaksY[0], x, z));
    };
    end(kAllX, kThickZ);
    end(kThickX, {1, 3});
  }
}

void addRib(const Rulers& rulers, std::vector<Patch>& all) {
  for (const bool far : {false, true}) {
    Patch side = far ? rulers.flat(kZ, kX, kBreaksY[3], kRibZ, kRibX) : rulers.flat(kX, kZ, kBreaksY[2], kRibX, kRibZ);
    side.half = true;
    all.push_back(side);
  }
  const Patch x = rulers.flat(kX, kY, 0.0, kRibX, kRibY), z = rulers.flat(kZ, kY, 0.0, kRibZ, kRibY);
  all.push_back({x.along, x.across, false,
                 [x, z](int i, int j) { return Vec3(x.at(x.across - j, i)[kX], x.at(0, i)[kY], z.at(j, i)[kZ]); }});
}

}  // namespace

Triangles bracket(int faces) {
  // Patches look at their rulers, which therefore live until the triangles are made.
  std::vector<std::unique_ptr<Rulers>> kept;
  return ofFaces(faces, 19500.0, [&](double cell_mm) {
    kept.push_back(std::make_unique<Rulers>(rulersOf(cell_mm)));
    std::vector<Patch> all;
    addFoot(*kept.back(), cell_mm, all);
    addWall(*kept.back(), cell_mm, all);
    addEnds(*kept.back(), all);
    addRib(*kept.back(), all);
    return all;
  });
}

}  // namespace underact::mesh_maker
