#include "core/mesh/crossing.h"
#include "core/mesh/proxy.h"
#include "tests/support/gap_meshes.h"
#include "tests/support/property.h"

namespace underact::mesh {
namespace {

/// A tip that goes over a mesh with gaps, and what its proxy does.
class Stroke {
 public:
  Stroke(const test::GapMesh& gaps, const Surface& surface) : gaps_(gaps), surface_(surface) {}

  /// From q_M on, in steps of step_mm. False: the tip is free more than a micrometre inside.
  bool goTo(const Vec3& q_M, double step_mm) {
    const Vec3 from_M = q_M_;
    const int ticks = static_cast<int>(std::ceil((q_M - from_M).norm() / step_mm));
    for (int tick = 1; tick <= ticks; ++tick) {
      if (!goOn(from_M + (q_M - from_M) * (static_cast<double>(tick) / ticks))) return false;
    }
    return true;
  }
  /// False: not outside, where a stroke begins.
  bool begin(const Vec3& q_M) {
    state_ = {};
    q_M_ = q_M;
    clear_mm_ = 0.0;
    if (distance(q_M) < 1e-3 || test::windingNumber(gaps_.triangles, q_M) > 0.5) return false;
    return goOn(q_M);
  }
  const Vec3& q_M() const { return q_M_; }
  int held() const { return held_; }

 private:
  bool goOn(const Vec3& q_M) {
    const Hit hit = followProxy(surface_, FreeSide::Outside, q_M, state_);
    clear_mm_ -= (q_M - q_M_).norm();
    q_M_ = q_M;
    if (hit.face >= 0) {
      clear_mm_ = 0.0;
      ++held_;
      return true;
    }
    if (clear_mm_ > 0.0) return true;  // no face is so near
    clear_mm_ = distance(q_M);
    return clear_mm_ < 1e-3 || test::windingNumber(gaps_.triangles, q_M) < 0.5;
  }
  double distance(const Vec3& q_M) const {
    SearchState search;
    return std::sqrt(nearestPoint(surface_, Search::Global, q_M, search).squared);
  }
  const test::GapMesh& gaps_;
  const Surface& surface_;
  ProxyState state_;
  Vec3 q_M_ = Vec3::Zero();
  double clear_mm_ = 0.0;  // how far the tip may go until a face can be reached
  int held_ = 0;           // ticks
};

TEST(Gap, NoStrokeOverNarrowGapsLeaks) {
  const std::vector<test::GapMesh> meshes = test::gapMeshes();
  std::vector<std::shared_ptr<const Surface>> surfaces;
  for (const test::GapMesh& one : meshes) surfaces.push_back(makeSurface(one.triangles).value());
  std::vector<int> leaks(meshes.size(), 0), strokes(meshes.size(), 0);
  int held = 0;
  const int count = test::dearSweep(1000, 100'000);
  for (int draw = 0; draw < count; ++draw) {
    test::Random random(test::Seed{20260000 + static_cast<std::uint64_t>(draw)});
    const std::size_t which = static_cast<std::size_t>(draw) % meshes.size();
    const std::vector<Vec3>& aims = meshes[which].aims;
    const auto aim = [&]() -> Vec3 {
      return aims[random.below(aims.size())] + random.between(0.0, 3.0) * random.direction();
    };
    Stroke stroke(meshes[which], *surfaces[which]);
    Vec3 through_M = aim();
    while (!stroke.begin(through_M + random.between(0.5, 8.0) * random.direction())) through_M = aim();
    const double step_mm = std::exp(random.between(std::log(0.01), std::log(1.5)));  // m/s, a millisecond long
    bool leaks_here = false;
    for (int turn = 0; turn < 4 && !leaks_here; ++turn) {
      leaks_here = !stroke.goTo(through_M, step_mm);
      through_M += random.between(0.5, 6.0) * random.direction();
    }
    ++strokes[which];
    leaks[which] += leaks_here ? 1 : 0;
    held += stroke.held();
  }
  EXPECT_GT(held, 20 * count);
  for (std::size_t k = 0; k < meshes.size(); ++k)
    EXPECT_EQ(leaks[k], 0) << "of " << strokes[k] << " strokes over the " << meshes[k].name;
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
