#include "core/mesh_file/repair.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <numeric>
#include <set>
#include <thread>

#include "tests/core/mesh_file/some_meshes.h"
#include "tests/support/property.h"

namespace underact::mesh_file {
namespace {

using mesh::Triangles;

/// What holds of every repaired mesh, whatever it was.
void expectSound(const Repaired& repaired) {
  const Triangles& triangles = repaired.triangles;
  const Facts& facts = repaired.facts;
  EXPECT_EQ(facts.faces, static_cast<std::int64_t>(triangles.faces.size()));
  EXPECT_EQ(facts.corners, static_cast<std::int64_t>(triangles.p_MV.size()));
  std::set<std::array<std::int32_t, 3>> seen;
  std::vector<bool> used(triangles.p_MV.size(), false);
  for (const mesh::Face& face : triangles.faces) {
    mesh::Face sorted = face;
    std::sort(sorted.begin(), sorted.end());
    ASSERT_TRUE(sorted[0] >= 0 && sorted[0] < sorted[1] && sorted[1] < sorted[2]);
    ASSERT_LT(static_cast<std::size_t>(sorted[2]), triangles.p_MV.size());
    ASSERT_TRUE(seen.insert(sorted).second);
    for (const std::int32_t corner : face) used[static_cast<std::size_t>(corner)] = true;
  }
  EXPECT_EQ(std::count(used.begin(), used.end(), false), 0);
  for (const Eigen::Vector3f& p_MV : triangles.p_MV) ASSERT_TRUE(p_MV.allFinite());
  EXPECT_TRUE(std::isfinite(facts.area) && std::isfinite(facts.volume) && std::isfinite(facts.longest_border));
  EXPECT_EQ(facts.file_faces + facts.added_at_seams,
            facts.faces + facts.not_finite + facts.out_of_range + facts.without_extent + facts.duplicates);
  EXPECT_EQ(facts.borders > 0, facts.border_edges > 0);
}

Repaired repaired(const Triangles& triangles) {
  std::optional<Repaired> done = repair(triangles);
  EXPECT_TRUE(done);
  expectSound(*done);
  return std::move(*done);
}

TEST(Repair, ASoundMeshStaysAsItIs) {
  const Repaired done = repaired(test::cube(10.0F));
  EXPECT_TRUE(isClosed(done.facts));
  EXPECT_EQ(done.facts.faces, 12);
  EXPECT_EQ(done.facts.corners, 8);
  EXPECT_EQ(done.facts.parts, 1);
  EXPECT_EQ(done.facts.turned, 0);
  EXPECT_EQ(done.facts.welded, 0);
  EXPECT_NEAR(done.facts.volume, 1000.0, 1e-9);
  EXPECT_NEAR(done.facts.area, 600.0, 1e-9);
  EXPECT_NEAR(done.facts.thinnest, 2.0 * 1000.0 / 600.0, 1e-12);
  EXPECT_EQ(largestExtent(done.facts), 10.0);
  EXPECT_EQ(done.facts.crossings, 0);
  EXPECT_EQ(done.facts.crossings_checked, 1);
}

TEST(Repair, ASoupIsWelded) {
  const Repaired done = repaired(test::soup(test::ball(20.0F, 3)));
  EXPECT_EQ(done.facts.corners, 258);  // 4 * 4^3 + 2
  EXPECT_EQ(done.facts.welded, 3 * 512 - 258);
  EXPECT_TRUE(isClosed(done.facts));
}

TEST(Repair, CornersWithinTheToleranceAreWeldedAndNoOthers) {
  // The diagonal of a cube of edge 10 is 17.32, so the tolerance is 1.732e-5: moved by 1e-5 each way, or by 4e-5.
  Triangles loose = test::soup(test::cube(10.0F));
  test::Random random(test::Seed{7});
  for (Eigen::Vector3f& p_MV : loose.p_MV) p_MV += 0.4e-5F * random.direction().cast<float>();
  const Repaired welded = repaired(loose);
  EXPECT_NEAR(welded.facts.weld_tolerance, 1.732e-5, 1e-8);
  EXPECT_EQ(welded.facts.corners, 8);
  EXPECT_TRUE(isClosed(welded.facts));
  loose = test::soup(test::cube(10.0F));
  for (std::size_t face = 0; face < 6; ++face) loose.p_MV[3 * face].x() += 4e-5F;
  EXPECT_GT(repaired(loose).facts.corners, 8);
}

TEST(Repair, WeldingFindsWhatComparingEachWithEachFinds) {
  test::Random random(test::Seed{20071203});
  for (int draw = 0; draw < test::sweep(40, 1000); ++draw) {
    Triangles cloud;
    const int groups = 30;
    for (int k = 0; k < groups; ++k) {
      const Vec3 place = random.inBox(1.0);
      for (int copy = 0; copy < 4; ++copy) {
        cloud.p_MV.emplace_back((place + random.between(0.0, 1e-6) * random.direction()).cast<float>());
      }
    }
    for (std::int32_t k = 0; k + 2 < 4 * groups; ++k) cloud.faces.push_back({k, k + 1, k + 2});
    const Repaired done = repaired(cloud);
    // No two corners of a repaired mesh are within the tolerance.
    for (std::size_t a = 0; a < done.triangles.p_MV.size(); ++a) {
      for (std::size_t b = a + 1; b < done.triangles.p_MV.size(); ++b) {
        const Vec3 apart = done.triangles.p_MV[a].cast<double>() - done.triangles.p_MV[b].cast<double>();
        ASSERT_GT(apart.norm(), done.facts.weld_tolerance);
      }
    }
  }
}

TEST(Repair, FacesWithoutExtentAndDuplicatesGo) {
  Triangles triangles = test::cube(1.0F);
  triangles.faces.push_back({0, 0, 1});
  triangles.faces.push_back(triangles.faces[3]);
  triangles.faces.push_back({triangles.faces[5][1], triangles.faces[5][0], triangles.faces[5][2]});  // the other way
  const Repaired done = repaired(triangles);
  EXPECT_EQ(done.facts.without_extent, 1);
  EXPECT_EQ(done.facts.duplicates, 2);
  EXPECT_TRUE(isClosed(done.facts));
}

TEST(Repair, AFaceOnALineStaysWhereItClosesASeam) {
  // A cube one of whose edges has a corner in its middle on one side alone: a face on a line is between.
  Triangles triangles = test::cube(2.0F);
  triangles.p_MV.emplace_back(1.0F, 0.0F, 0.0F);  // between corners 0 and 1
  for (mesh::Face& face : triangles.faces) {
    const bool has_edge = std::ranges::count(face, 0) > 0 && std::ranges::count(face, 1) > 0;
    const bool is_bottom = triangles.p_MV[static_cast<std::size_t>(face[0])].z() == 0.0F &&
                           triangles.p_MV[static_cast<std::size_t>(face[1])].z() == 0.0F &&
                           triangles.p_MV[static_cast<std::size_t>(face[2])].z() == 0.0F;
    if (!has_edge || !is_bottom) continue;
    mesh::Face other = face;
    std::ranges::replace(face, 1, 8);
    std::ranges::replace(other, 0, 8);
    triangles.faces.push_back(other);
    break;
  }
  const Repaired divided = repaired(triangles);  // without it, the face on the other side is divided
  EXPECT_TRUE(isClosed(divided.facts));
  EXPECT_EQ(divided.facts.added_at_seams, 1);
  EXPECT_EQ(divided.facts.faces, 14);
  EXPECT_EQ(divided.facts.flat_faces, 0);
  triangles.faces.push_back({0, 1, 8});
  const Repaired done = repaired(triangles);
  EXPECT_EQ(done.facts.flat_faces, 1);
  EXPECT_TRUE(isClosed(done.facts));
}

TEST(Repair, FacesAreTurnedSoThatTheOutsideIsOut) {
  const Repaired over = repaired(test::turnedOver(test::ball(5.0F, 2)));
  EXPECT_EQ(over.facts.turned, 128);
  EXPECT_GT(test::volumeOf(over.triangles), 0.0);
  EXPECT_NEAR(test::volumeOf(over.triangles), over.facts.volume, 1e-9);
  test::Random random(test::Seed{20070601});
  for (int draw = 0; draw < test::sweep(50, 2000); ++draw) {
    Triangles mixed = test::soup(test::ball(5.0F, 2));
    std::int64_t turned = 0;
    for (mesh::Face& face : mixed.faces) {
      if (random.below(2) == 0) continue;
      std::swap(face[1], face[2]);
      ++turned;
    }
    const Repaired done = repaired(mixed);
    ASSERT_TRUE(isClosed(done.facts));
    ASSERT_EQ(done.facts.turned, turned);
    ASSERT_NEAR(test::volumeOf(done.triangles), test::volumeOf(test::ball(5.0F, 2)), 1e-4);  // floats, welded
  }
}

TEST(Repair, AnOpenSurfaceStandsAsMostOfItDoes) {
  Triangles open = test::sheet(4);
  std::swap(open.faces[0][1], open.faces[0][2]);
  std::swap(open.faces[9][1], open.faces[9][2]);
  const Repaired done = repaired(open);
  EXPECT_EQ(done.facts.turned, 2);
  for (const mesh::Face& face : done.triangles.faces) {
    const auto at = [&](std::size_t k) -> Eigen::Vector3f {
      return done.triangles.p_MV[static_cast<std::size_t>(face[k])];
    };
    EXPECT_GT((at(1) - at(0)).cross(at(2) - at(0)).z(), 0.0F);
  }
}

TEST(Repair, AHollowKeepsItsWallAndASecondBallItsOutside) {
  const Triangles hollow = test::joined(test::ball(10.0F, 2), test::turnedOver(test::ball(5.0F, 2)));
  const Repaired done = repaired(hollow);
  EXPECT_EQ(done.facts.turned, 0);
  EXPECT_EQ(done.facts.closed_parts, 2);
  EXPECT_EQ(done.facts.nested_parts, 1);
  EXPECT_EQ(done.facts.hollows, 1);
  const Repaired body = repaired(test::joined(test::ball(10.0F, 2), test::ball(5.0F, 2)));
  EXPECT_EQ(body.facts.nested_parts, 1);
  EXPECT_EQ(body.facts.hollows, 0);
  EXPECT_NEAR(test::volumeOf(done.triangles), test::volumeOf(hollow), 1e-9);
  Triangles apart = test::turnedOver(test::ball(5.0F, 2));
  for (Eigen::Vector3f& p_MV : apart.p_MV) p_MV.x() += 20.0F;
  const Repaired two = repaired(test::joined(test::ball(10.0F, 2), apart));
  EXPECT_EQ(two.facts.turned, 128);
  EXPECT_EQ(two.facts.nested_parts, 0);
}

TEST(Repair, HolesAreCountedAndMeasured) {
  Triangles open = test::cube(10.0F);
  open.faces.erase(open.faces.begin(), open.faces.begin() + 2);  // the bottom
  open.faces.erase(open.faces.begin());                          // half of the top: another hole, corners apart
  const Repaired done = repaired(open);
  EXPECT_EQ(done.facts.borders, 2);
  EXPECT_EQ(done.facts.border_edges, 7);
  EXPECT_NEAR(done.facts.longest_border, 40.0, 1e-12);
  EXPECT_FALSE(isClosed(done.facts));
  EXPECT_EQ(repaired(test::sheet(3)).facts.borders, 1);
  EXPECT_NEAR(repaired(test::sheet(3)).facts.longest_border, 12.0, 1e-12);
}

TEST(Repair, EdgesWithMoreThanTwoFacesAreCounted) {
  Triangles fin = test::cube(1.0F);
  fin.p_MV.emplace_back(-1.0F, -1.0F, 0.5F);
  fin.faces.push_back({0, 4, 8});
  const Repaired done = repaired(fin);
  EXPECT_EQ(done.facts.crowded_edges, 1);
  EXPECT_EQ(done.facts.border_edges, 2);
  EXPECT_FALSE(isClosed(done.facts));
}

TEST(Repair, AStripThatIsTwistedOnceHasNoOutside) {
  Triangles strip;
  const int n = 20;
  for (int k = 0; k < n; ++k) {
    const double a = 2.0 * 3.14159265358979 * k / n, half = 0.5 * a;
    for (const double side : {-0.3, 0.3}) {
      const double r = 1.0 + side * std::cos(half);
      strip.p_MV.emplace_back(Vec3(r * std::cos(a), r * std::sin(a), side * std::sin(half)).cast<float>());
    }
  }
  for (int k = 0; k < n; ++k) {
    const bool last = k == n - 1;
    const int a = 2 * k, b = 2 * k + 1, c = last ? 1 : 2 * k + 2, d = last ? 0 : 2 * k + 3;
    strip.faces.push_back({a, b, d});
    strip.faces.push_back({a, d, c});
  }
  const Repaired done = repaired(strip);
  EXPECT_GT(done.facts.clashing_edges, 0);
  EXPECT_EQ(done.facts.borders, 1);
}

TEST(Repair, CrossingsAreFound) {
  Triangles shifted = test::ball(5.0F, 2);
  for (Eigen::Vector3f& p_MV : shifted.p_MV) p_MV.x() += 7.0F;
  const Repaired done = repaired(test::joined(test::ball(5.0F, 2), shifted));
  EXPECT_GT(done.facts.crossings, 10);
  EXPECT_EQ(repaired(test::joined(test::ball(5.0F, 2), test::ball(2.0F, 2))).facts.crossings, 0);
  // Two squares in one plane, one over the other, and beside each other.
  Triangles over = test::sheet(2), beside = test::sheet(2);
  for (Eigen::Vector3f& p_MV : over.p_MV) p_MV += Eigen::Vector3f(0.3F, 0.4F, 0.0F);
  for (Eigen::Vector3f& p_MV : beside.p_MV) p_MV += Eigen::Vector3f(2.5F, 0.0F, 0.0F);
  EXPECT_GT(repaired(test::joined(test::sheet(2), over)).facts.crossings, 0);
  EXPECT_EQ(repaired(test::joined(test::sheet(2), beside)).facts.crossings, 0);
}

TEST(Repair, CrossingsAreThoseThatSamplesFind) {  // oracle: points along each edge change sides of the other within it
  test::Random random(test::Seed{20070601});
  int crossing = 0;
  for (int draw = 0; draw < test::sweep(2000, 100'000); ++draw) {
    Triangles two;
    for (int k = 0; k < 6; ++k) two.p_MV.emplace_back(random.inBox(1.0).cast<float>());
    two.faces = {{0, 1, 2}, {3, 4, 5}};
    const auto at = [&](int k) -> Vec3 { return two.p_MV[static_cast<std::size_t>(k)].cast<double>(); };
    bool meets = false, is_close = false;
    for (int t = 0; t < 6; t += 3) {
      const Vec3 a = at(t), u = at(t + 1) - a, v = at(t + 2) - a, n = u.cross(v);
      for (int k = 0; k < 3; ++k) {
        const Vec3 p = at(3 - t + k), q = at(3 - t + (k + 1) % 3);
        const double s = n.dot(a - p) / n.dot(q - p);
        Eigen::Matrix<double, 3, 2> plane;
        plane << u, v;
        const Vec3 hit = p + s * (q - p) - a;
        const Eigen::Vector2d w = plane.colPivHouseholderQr().solve(hit);
        const double inside = std::min({w[0], w[1], 1.0 - w[0] - w[1], s, 1.0 - s});
        meets = meets || inside > 0.0;
        is_close = is_close || std::abs(inside) < 1e-9;
      }
    }
    if (is_close) continue;
    crossing += meets ? 1 : 0;
    ASSERT_EQ(repaired(two).facts.crossings, meets ? 1 : 0) << draw;
  }
  EXPECT_GT(crossing, 100);
}

TEST(Repair, AdversarialMeshesComeThrough) {
  const float nan = std::nanf(""), inf = INFINITY;
  Triangles none, corners_alone, one, nans, indexes;
  corners_alone.p_MV = {{0, 0, 0}, {1, 1, 1}};
  one.p_MV = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  one.faces = {{0, 1, 2}};
  nans = test::cube(1.0F);
  nans.p_MV[3] = {nan, inf, -inf};
  indexes = test::cube(1.0F);
  indexes.faces[0] = {INT32_MAX, INT32_MIN, -1};
  EXPECT_EQ(repaired(none).facts.faces, 0);
  EXPECT_EQ(repaired(corners_alone).facts.corners, 0);
  EXPECT_EQ(repaired(one).facts.borders, 1);
  EXPECT_GT(repaired(nans).facts.not_finite, 0);
  EXPECT_EQ(repaired(indexes).facts.out_of_range, 1);
  Triangles same = test::cube(1.0F);
  for (Eigen::Vector3f& p_MV : same.p_MV) p_MV = {1e14F, 1e14F, 1e14F};
  EXPECT_EQ(repaired(same).facts.faces, 0);
  Triangles far = test::cube(1.0F);
  for (Eigen::Vector3f& p_MV : far.p_MV) p_MV += Eigen::Vector3f::Constant(1e6F);
  EXPECT_TRUE(isClosed(repaired(far).facts));
  EXPECT_NEAR(repaired(far).facts.volume, 1.0, 1e-9);  // of differences of floats, which are whole here
  Triangles tiny = test::cube(1e-40F);                 // below the normal floats
  repaired(tiny);
}

TEST(Repair, FansNeedlesAndSliversComeThroughInTime) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  Triangles fan, needles;
  const int n = 10'000;
  fan.p_MV.emplace_back(0.0F, 0.0F, 1.0F);
  for (int k = 0; k < n; ++k) {
    const double a = 2.0 * 3.14159265358979 * k / n;
    fan.p_MV.emplace_back(Vec3(std::cos(a), std::sin(a), 0.0).cast<float>());
    fan.faces.push_back({0, k + 1, (k + 1) % n + 1});
  }
  const Repaired cone = repaired(fan);
  EXPECT_EQ(cone.facts.faces, n);
  EXPECT_EQ(cone.facts.borders, 1);
  test::Random random(test::Seed{1});
  for (int k = 0; k < 20'000; ++k) {  // each across all the others
    const Vec3 p = random.inBox(1.0);
    const auto first = static_cast<std::int32_t>(needles.p_MV.size());
    needles.p_MV.emplace_back((p - 100.0 * Vec3::UnitX()).cast<float>());
    needles.p_MV.emplace_back((p + 100.0 * Vec3::UnitX()).cast<float>());
    needles.p_MV.emplace_back((p + 1e-3 * random.direction()).cast<float>());
    needles.faces.push_back({first, first + 1, first + 2});
  }
  EXPECT_EQ(repaired(needles).facts.parts, 20'000);
  Triangles book;  // 10,000 leaves at one edge
  book.p_MV = {{0, 0, 0}, {0, 0, 1}};
  for (int k = 0; k < n; ++k) {
    book.p_MV.push_back(fan.p_MV[static_cast<std::size_t>(k) + 1]);
    book.faces.push_back({0, 1, k + 2});
  }
  EXPECT_EQ(repaired(book).facts.crowded_edges, 1);
  EXPECT_LT(std::chrono::duration<double>(Clock::now() - start).count(), 60.0);  // 2 s in truth, 20 with sanitizers
}

TEST(Repair, TheSameMeshGivesTheSameBits) {
  const Triangles triangles = test::soup(test::joined(test::ball(3.0F, 3), test::sheet(10)));
  const Repaired a = repaired(triangles), b = repaired(triangles);
  EXPECT_EQ(a.triangles.faces, b.triangles.faces);
  EXPECT_EQ(std::memcmp(&a.facts, &b.facts, sizeof a.facts), 0);
}

TEST(Repair, EndsSoonWhereItIsCancelled) {
  const Triangles triangles = test::soup(test::ball(3.0F, 7));  // 131,072 faces
  for (const int after_ms : {1, 10, 20, 40, 80}) {
    std::atomic<bool> cancelled = false;
    std::chrono::steady_clock::time_point since;
    std::thread canceller([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(after_ms));
      since = std::chrono::steady_clock::now();
      cancelled = true;
    });
    TaskMonitor monitor;
    monitor.cancelled = &cancelled;
    const bool is_cancelled = !repair(triangles, monitor);
    const auto end = std::chrono::steady_clock::now();
    canceller.join();
    const double late_s = std::chrono::duration<double>(end - since).count();
    EXPECT_TRUE(!is_cancelled || late_s < 0.4) << late_s << " s after " << after_ms << " ms";
  }
}

}  // namespace
}  // namespace underact::mesh_file
