#include "core/mesh/surface_bytes.h"

#include <cstring>

#include "core/mesh/proxy.h"
#include "core/mesh/search.h"
#include "scenes/meshes/make/meshes.h"
#include "tests/support/mesh_points.h"
#include "tests/support/property.h"

namespace underact::mesh {
namespace {

TEST(SurfaceBytes, ComeBackToTheSameSurface) {
  const Triangles triangles = mesh_maker::bracket(3000);
  const std::shared_ptr<const Surface> surface = makeSurface(triangles).value();
  const std::vector<std::byte> bytes = surfaceBytes(*surface);
  const std::shared_ptr<const Surface> again = surfaceOfBytes(bytes);
  ASSERT_NE(again, nullptr);
  EXPECT_EQ(surfaceBytes(*again), bytes);
  EXPECT_EQ(again->is_closed, surface->is_closed);
  EXPECT_EQ(again->low_M, surface->low_M);
  SearchState one, other;
  for (const Vec3& q : test::pointsAbout(triangles, 300, test::Seed{3})) {
    const Hit a = nearestPoint(*surface, Search::Hybrid, q, one), b = nearestPoint(*again, Search::Hybrid, q, other);
    EXPECT_EQ(a.p_M, b.p_M);
    EXPECT_EQ(a.face, b.face);
  }
}

TEST(SurfaceBytes, EqualMeshesGiveEqualBytes) {
  const Triangles triangles = mesh_maker::torusKnot(120'000);  // enough for the parts to be split in threads
  EXPECT_EQ(surfaceBytes(*makeSurface(triangles).value()), surfaceBytes(*makeSurface(triangles).value()));
}

TEST(SurfaceBytes, AClosedSurfaceHasNoMoreCornersThanItsFacesAllow) {
  Surface forged = *makeSurface(mesh_maker::cube(200)).value();
  ASSERT_NE(surfaceOfBytes(surfaceBytes(forged)), nullptr);
  forged.triangles.p_MV.emplace_back(1.0F, 2.0F, 3.0F);  // of no face
  forged.normals_M.emplace_back(1.0F, 0.0F, 0.0F);
  EXPECT_EQ(surfaceOfBytes(surfaceBytes(forged)), nullptr);
  forged.triangles.p_MV.pop_back();
  forged.normals_M.pop_back();
  forged.neighbours[0][1] = -1;
  EXPECT_EQ(surfaceOfBytes(surfaceBytes(forged)), nullptr);
  forged.is_closed = false;
  EXPECT_NE(surfaceOfBytes(surfaceBytes(forged)), nullptr);
}

TEST(SurfaceBytes, ABoxWhereNoChildIsMustBeEmpty) {
  const std::shared_ptr<const Surface> surface = makeSurface(mesh_maker::cube(200)).value();
  int without = 0;
  for (std::size_t node = 0; node < surface->nodes.size(); ++node) {
    for (std::size_t slot = 0; slot < kChildren; ++slot) {
      if (surface->nodes[node].children[slot] != kNoChild) continue;
      Surface forged = *surface;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        forged.nodes[node].low_N[axis][slot] = -1e3F;  // a search would go there
        forged.nodes[node].high_N[axis][slot] = 1e3F;
      }
      ASSERT_EQ(surfaceOfBytes(surfaceBytes(forged)), nullptr);
      ++without;
    }
  }
  EXPECT_GT(without, 3);
}

TEST(SurfaceBytes, WhateverIsDamagedNothingComesBackThatASearchCouldBeLostIn) {
  const Triangles triangles = mesh_maker::cube(200);
  const std::vector<std::byte> whole = surfaceBytes(*makeSurface(triangles).value());
  test::Random random{test::Seed{11}};
  const std::vector<Vec3> points = test::pointsAbout(triangles, 5, test::Seed{4});
  int refused = 0, taken = 0;
  for (int run = 0; run < 3000; ++run) {
    std::vector<std::byte> bytes = whole;
    const int changes = 1 + run % 4;
    for (int change = 0; change < changes; ++change) {
      const std::size_t place = random.below(bytes.size());
      bytes[place] ^= static_cast<std::byte>(1 + random.below(255));
    }
    const std::shared_ptr<const Surface> surface = surfaceOfBytes(bytes);
    refused += surface == nullptr ? 1 : 0;
    if (surface == nullptr) continue;
    ++taken;
    SearchState state;
    ProxyState touching;
    for (const Vec3& q : points) {
      EXPECT_LE(nearestPoint(*surface, Search::Hybrid, q, state).visits, 2 * kMaxVisits);
      followProxy(*surface, FreeSide::Outside, q, touching);
    }
  }
  EXPECT_GT(refused, 100);  // indexes, counts
  EXPECT_GT(taken, 100);    // coordinates, which the cache's own checksum guards
  for (std::size_t size : {std::size_t{0}, std::size_t{7}, std::size_t{40}, whole.size() - 1, whole.size() + 1}) {
    std::vector<std::byte> cut = whole;
    cut.resize(size);
    EXPECT_EQ(surfaceOfBytes(cut), nullptr);
  }
}

TEST(MakeSurface, RefusesWhatTheTickCouldNotBear) {
  const auto sentence = [](Triangles triangles) { return makeSurface(std::move(triangles)).problems().at(0).sentence; };
  Triangles triangles = mesh_maker::cube(12);
  EXPECT_EQ(sentence({}), "The mesh has no triangles.");
  Triangles lost = triangles;
  lost.faces[3][1] = 1000;
  EXPECT_EQ(sentence(lost), "A triangle refers to a vertex that does not exist.");
  Triangles twice = triangles;
  twice.faces[3][1] = twice.faces[3][0];
  EXPECT_EQ(sentence(twice), "A triangle has the same vertex twice.");
  for (const float wrong : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 2e15F}) {
    Triangles nowhere = triangles;
    nowhere.p_MV[2].y() = wrong;
    EXPECT_EQ(sentence(nowhere), "A vertex of the mesh is not a finite point.");
  }
}

TEST(MakeSurface, EndsEarlyWhereItIsAskedTo) {
  const std::atomic<bool> cancelled{true};
  TaskMonitor monitor;
  monitor.cancelled = &cancelled;
  EXPECT_EQ(makeSurface(mesh_maker::cube(12), monitor).problems().at(0).sentence, "Cancelled.");
}

}  // namespace
}  // namespace underact::mesh
