#include <gtest/gtest.h>

#include "core/mesh_file/repair.h"
#include "core/mesh_file/unite.h"
#include "tests/support/crossed_bodies.h"
#include "tests/support/gap_meshes.h"
#include "tests/support/property.h"
#include "tests/support/stroke.h"

namespace underact::mesh_file {
namespace {

/// Blocks with narrow slots, and beams through their walls.
TEST(Gap, NoStrokeOverGapsInTheSurfaceOfAUnionLeaks) {
  constexpr double kNear_mm = 5e-3;  // the union is within a few merging distances of its bodies: 1e-6 of 80 mm each
  int held = 0;
  for (const double width_mm : {0.02, 0.1, 0.4}) {
    const mesh::Triangles bodies =
        test::together({test::slotBlock(width_mm), test::boxOf({-30, -3, -2}, {30, 4, 5}), test::wedgeOf({9, 30, 24})});
    Repaired repaired = repair(bodies).value();
    ASSERT_TRUE(uniteRepaired(repaired, {}));
    ASSERT_EQ(repaired.facts.inside, Inside::United);
    const auto surface = mesh::asUnited(*mesh::makeSurface(repaired.triangles).value());
    std::vector<Vec3> aims;
    for (double y = -20.0; y < 25.0; y += 1.0) aims.insert(aims.end(), {Vec3(0, y, 20), Vec3(0, y, 5), Vec3(0, y, 0)});
    for (int draw = 0; draw < test::dearSweep(150, 10'000); ++draw) {
      test::Random random(test::Seed{20260000 + static_cast<std::uint64_t>(draw)});
      test::Stroke stroke(bodies, *surface, kNear_mm);
      EXPECT_TRUE(stroke.strike(aims, random)) << "slot of " << width_mm << " mm, draw " << draw;
      held += stroke.held();
    }
  }
  EXPECT_GT(held, 1000);
}

}  // namespace
}  // namespace underact::mesh_file
