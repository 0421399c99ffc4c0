#include "core/mesh_file/load.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <fstream>

#include "core/mesh/search.h"
#include "core/mesh/surface_bytes.h"
#include "core/mesh_file/read_file.h"
#include "core/mesh_file/report.h"
#include "tests/core/mesh_file/cancelled_after.h"
#include "tests/core/mesh_file/some_meshes.h"
#include "tests/support/random.h"

namespace underact::mesh_file {
namespace {

TEST(LoadMesh, TheSecondTimeItComesFromTheCacheAndIsTheSame) {
  const test::ScratchFolder folder;
  const Cache cache(folder.path() + "/cache");
  const std::string path = folder.write("m.stl", test::stlBinary(test::soup(test::turnedOver(test::ball(20.0F, 3)))));
  const Result<Loaded> first = loadMesh(path, {}, cache), second = loadMesh(path, {}, cache);
  ASSERT_TRUE(first);
  ASSERT_TRUE(second);
  EXPECT_FALSE(first.value().from_cache);
  EXPECT_TRUE(second.value().from_cache);
  EXPECT_EQ(mesh::surfaceBytes(*first.value().surface), mesh::surfaceBytes(*second.value().surface));
  EXPECT_EQ(std::memcmp(&first.value().facts, &second.value().facts, sizeof(Facts)), 0);
  EXPECT_EQ(first.value().facts.turned, 512);
  EXPECT_TRUE(first.value().surface->is_closed);
  EXPECT_EQ(second.value().format, Format::StlBinary);
  EXPECT_EQ(second.value().checksum, first.value().checksum);
  EXPECT_EQ(second.value().checksum.size(), 32U);
}

TEST(LoadMesh, TheSameBytesUnderAnotherNameAreTheSameAndOthersAreNot) {
  const test::ScratchFolder folder;
  const Cache cache(folder.path() + "/cache");
  ASSERT_TRUE(loadMesh(folder.write("a.obj", test::obj(test::cube(1.0F))), {}, cache));
  EXPECT_TRUE(loadMesh(folder.write("b.obj", test::obj(test::cube(1.0F))), {}, cache).value().from_cache);
  const Result<Loaded> other = loadMesh(folder.write("a.obj", test::obj(test::cube(2.0F))), {}, cache);
  EXPECT_FALSE(other.value().from_cache);
  EXPECT_EQ(largestExtent(other.value().facts), 2.0);
}

TEST(LoadMesh, ADamagedEntryIsBuiltAnew) {
  const test::ScratchFolder folder;
  const Cache cache(folder.path() + "/cache");
  const std::string path = folder.write("m.obj", test::obj(test::cube(1.0F)));
  ASSERT_TRUE(loadMesh(path, {}, cache));
  for (const auto& entry : std::filesystem::directory_iterator(cache.folder())) {
    std::fstream file(entry.path(), std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(400);
    file.put('!');
  }
  EXPECT_FALSE(loadMesh(path, {}, cache).value().from_cache);
  EXPECT_TRUE(loadMesh(path, {}, cache).value().from_cache);
}

TEST(LoadMesh, IsTheSurfaceThatTheFileHolds) {
  const test::ScratchFolder folder;
  const Cache none("/dev/null");
  const Result<Loaded> loaded = loadMesh(folder.write("m.ply", test::plyText(test::ball(10.0F, 4))), {}, none);
  ASSERT_TRUE(loaded);
  test::Random random(test::Seed{20070601});
  for (int draw = 0; draw < 200; ++draw) {
    const Vec3 q = 30.0 * random.direction();
    mesh::SearchState state;
    const mesh::Hit hit = mesh::nearestPoint(*loaded.value().surface, mesh::Search::Global, q, state);
    // Faces of 4 levels lie within 10 (1 - cos(45 deg / 16)) of the ball.
    EXPECT_NEAR(hit.p_M.norm(), 10.0, 0.06);
    EXPECT_NEAR(std::sqrt(hit.squared), 20.0, 0.06);
  }
}

TEST(LoadMesh, WithoutAFaceIsAProblemThatSaysWhy) {
  const test::ScratchFolder folder;
  const Result<Loaded> loaded = loadMesh(folder.write("m.obj", "v 0 0 0\nv 1 0 nan\nv 1 1 0\nf 1 2 3\nf 1 1 1\n"));
  ASSERT_FALSE(loaded);
  EXPECT_EQ(loaded.problems()[0].sentence,
            "The file contains nothing to feel. 1 face was left out: one of its vertices is not a finite point. 1 face "
            "was left out: it has no extent. No face is left, so there is nothing to feel.");
}

TEST(LoadMesh, ToldSharesGrowToTheWhole) {
  const test::ScratchFolder folder;
  double last = 0.0;
  std::vector<std::string> steps;
  TaskMonitor monitor;
  monitor.progress = [&](const char* step, double share) {
    EXPECT_GE(share, last) << step;
    last = share;
    if (steps.empty() || steps.back() != step) steps.emplace_back(step);
  };
  ASSERT_TRUE(
      loadMesh(folder.write("m.obj", test::obj(test::ball(1.0F, 6))), monitor, Cache(folder.path() + "/cache")));
  EXPECT_EQ(last, 1.0);
  EXPECT_EQ(steps.front(), "Reading the file");
  EXPECT_EQ(steps.back(), "Ready");
  EXPECT_GE(steps.size(), 5U);
}

/// Of a cache: what is not whole, so not renamed to its name yet.
bool hasHalves(const Cache& cache) {
  if (!std::filesystem::exists(cache.folder())) return false;
  const std::filesystem::directory_iterator files(cache.folder());
  return std::any_of(begin(files), end(files), [](const auto& file) { return file.path().extension() != ".mesh"; });
}

TEST(LoadMesh, EndsSoonWhenCancelledAndKeepsNothing) {
  const test::ScratchFolder folder;
  const std::string path = folder.write("m.ply", test::plyBinary(test::ball(1.0F, 7)));  // 131,072 faces
  double latest_s = 0.0;
  for (const int after_ms : {0, 20, 60, 100, 150, 200, 300, 400}) {
    const Cache cache(folder.path() + "/cache" + std::to_string(after_ms));
    test::CancelledAfter cancelled{std::chrono::milliseconds(after_ms)};
    const Result<Loaded> loaded = loadMesh(path, cancelled.monitor(), cache);
    const double seconds = cancelled.secondsSince();
    EXPECT_FALSE(hasHalves(cache)) << after_ms;
    if (loaded) continue;
    EXPECT_EQ(loaded.problems()[0].sentence, kCancelled);
    latest_s = std::max(latest_s, seconds);
  }
  RecordProperty("latest_ms", static_cast<int>(1000 * latest_s));
  EXPECT_LT(latest_s, 0.5);  // 0.2 on a machine of its own
}

TEST(LoadMesh, AFileThatIsWrittenMeanwhileIsNotKept) {
  const test::ScratchFolder folder;
  const Cache cache(folder.path() + "/cache");
  const std::string path = folder.write("m.obj", test::obj(test::ball(1.0F, 5)));
  TaskMonitor monitor;
  bool is_written = false;
  monitor.progress = [&](const char* step, double /*share*/) {
    if (is_written || std::string(step) != "Reading the mesh") return;
    is_written = true;
    std::ofstream(path, std::ios::app) << "v 0 0 0\n";
  };
  const Result<Loaded> loaded = loadMesh(path, monitor, cache);
  ASSERT_TRUE(is_written);
  ASSERT_FALSE(loaded);
  EXPECT_EQ(loaded.problems()[0].sentence, "The file changed while it was being read. Open it again.");
}

TEST(SurfaceBytes, RefusesDamagedBytesOrReadsThemWhole) {
  const test::ScratchFolder folder;
  const Result<Loaded> loaded = loadMesh(folder.write("m.obj", test::obj(test::cube(1.0F))), {}, Cache("/dev/null"));
  const std::vector<std::byte> bytes = mesh::surfaceBytes(*loaded.value().surface);
  ASSERT_NE(mesh::surfaceOfBytes(bytes), nullptr);
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    ASSERT_EQ(mesh::surfaceOfBytes(std::span(bytes).first(length)), nullptr);
  }
  test::Random random(test::Seed{3});
  for (int draw = 0; draw < 5000; ++draw) {
    std::vector<std::byte> damaged = bytes;
    damaged[random.below(damaged.size())] ^= static_cast<std::byte>(1U << random.below(8));
    const auto surface = mesh::surfaceOfBytes(damaged);
    mesh::SearchState state;
    if (surface != nullptr) mesh::nearestPoint(*surface, mesh::Search::Global, random.inBox(2.0), state);
  }
}

}  // namespace
}  // namespace underact::mesh_file
