#include "core/mesh/proxy.h"
#include "tests/support/gap_meshes.h"
#include "tests/support/property.h"
#include "tests/support/stroke.h"

namespace underact::mesh {
namespace {

TEST(Gap, NoStrokeOverNarrowGapsLeaks) {
  constexpr double kNear_mm = 1e-3;
  const std::vector<test::GapMesh> meshes = test::gapMeshes();
  std::vector<std::shared_ptr<const Surface>> surfaces;
  for (const test::GapMesh& one : meshes) surfaces.push_back(makeSurface(one.triangles).value());
  std::vector<int> leaks(meshes.size(), 0);
  int held = 0;
  const int count = test::dearSweep(600, 100'000);
  for (int draw = 0; draw < count; ++draw) {
    test::Random random(test::Seed{20260000 + static_cast<std::uint64_t>(draw)});
    const std::size_t which = static_cast<std::size_t>(draw) % meshes.size();
    test::Stroke stroke(meshes[which].triangles, *surfaces[which], kNear_mm);
    leaks[which] += stroke.strike(meshes[which].aims, random) ? 0 : 1;
    held += stroke.held();
  }
  EXPECT_GT(held, 20 * count);
  for (std::size_t k = 0; k < meshes.size(); ++k) EXPECT_EQ(leaks[k], 0) << "of strokes over the " << meshes[k].name;
}

TEST(Gap, AcrossASlotInOneTickTheOppositeWallHoldsAndInTheSlotTheTipIsFree) {
  const std::shared_ptr<const Surface> block = makeSurface(test::slotBlock(0.2)).value();
  ProxyState state;
  const auto go = [&](double x, double z) { return followProxy(*block, FreeSide::Outside, {x, 3.0, z}, state); };
  EXPECT_EQ(go(-0.3, 21.0).face, -1);
  EXPECT_EQ(go(-0.2, 19.0).p_M.z(), 20.0);
  const Hit held = go(0.3, 17.0);  // past the slot
  ASSERT_GE(held.face, 0);
  EXPECT_NEAR((held.p_M - Vec3(0.1, 3.0, 17.0)).norm(), 0.0, 1e-6);
  EXPECT_EQ(go(0.05, 17.0).face, -1);
  EXPECT_GE(go(0.15, 17.0).face, 0);
  EXPECT_EQ(go(0.0, 17.0).face, -1);
  EXPECT_NEAR(go(-0.5, 16.0).p_M.x(), -0.1, 1e-6);
}

}  // namespace
}  // namespace underact::mesh
