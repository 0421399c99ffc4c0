#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/mesh/search.h"
#include "core/mesh/surface.h"
#include "scenes/meshes/make/meshes.h"
#include "tests/support/mesh_oracle.h"
#include "tests/support/mesh_points.h"
#include "tests/support/odd_meshes.h"
#include "tests/support/property.h"

// The nearest point of a mesh against the oracle that asks every face, over meshes of every kind.
namespace underact::mesh {
namespace {

using test::MeshOracle;
using test::OddMesh;
using test::Seed;

// Promised to users: 1e-12 of the largest coordinate, of the mesh as loaded or of the point asked about.
constexpr double kExact = 1e-12;

std::vector<OddMesh> everyMesh() {
  std::vector<OddMesh> all = test::oddMeshes();
  for (const int faces : {1000, 20000}) {
    const std::string size = " of " + std::to_string(faces);
    all.push_back({"knot" + size, mesh_maker::torusKnot(faces), true});
    all.push_back({"sphere" + size, mesh_maker::bumpySphere(faces), true});
    all.push_back({"bracket" + size, mesh_maker::bracket(faces), true});
  }
  return all;
}

/// A mesh, what the tick reads of it, and what is right.
struct Case {
  explicit Case(const OddMesh& of) : mesh(of), surface(makeSurface(of.triangles).value()), oracle(of.triangles) {
    mm = test::diagonalOf(of.triangles) / 100.0;
    if (!(mm > 0.0)) mm = 1.0;
  }
  double exact(const Vec3& q_M) const { return kExact * std::max(oracle.largest(), q_M.cwiseAbs().maxCoeff()); }

  OddMesh mesh;
  std::shared_ptr<const Surface> surface;
  MeshOracle oracle;
  double mm;  // a hundredth of its size
};

/// What draws cannot hit: corners, the middles of edges and faces, and points straight above them along an axis, whose
/// feet are on edges to the bit where a mesh lies along the axes.
std::vector<Vec3> specialPoints(const Case& one, std::size_t count) {
  std::vector<Vec3> all;
  const std::vector<Face>& faces = one.mesh.triangles.faces;
  for (std::size_t i = 0; i < faces.size(); i += 1 + faces.size() / (1 + count / 15)) {
    const auto at = [&](std::size_t k) -> Vec3 {
      return one.mesh.triangles.p_MV[static_cast<std::size_t>(faces[i][k])].cast<double>();
    };
    const Vec3 a = at(0), b = at(1), c = at(2);
    for (const Vec3& p_M :
         {a, Vec3(0.5 * (a + b)), Vec3(0.5 * (b + c)), Vec3(0.5 * (c + a)), Vec3((a + b + c) / 3.0)}) {
      all.push_back(p_M);
      for (const int axis : {static_cast<int>(i) % 3, 2}) all.emplace_back(p_M + one.mm * Vec3::Unit(axis));
    }
  }
  return all;
}

/// Points near the surface, about the mesh, and those above.
std::vector<Vec3> queries(const Case& one, int count, std::uint64_t seed) {
  std::vector<Vec3> all = test::pointsNear(one.mesh.triangles, 5.0 * one.mm, count - count / 4, Seed{seed});
  const std::vector<Vec3> about = test::pointsAbout(one.mesh.triangles, count / 4, Seed{seed + 1});
  all.insert(all.end(), about.begin(), about.end());
  const std::vector<Vec3> special = specialPoints(one, static_cast<std::size_t>(count / 4));
  all.insert(all.end(), special.begin(), special.end());
  return all;
}

/// The hit's own words agree: its point is the nearest of the face it names, and as far as it says.
void expectSound(const Case& one, const Vec3& q_M, const Hit& hit) {
  const double exact = one.exact(q_M);
  ASSERT_GE(hit.face, 0);
  ASSERT_LT(hit.face, static_cast<std::int32_t>(one.surface->triangles.faces.size()));
  ASSERT_NEAR((hit.p_M - q_M).norm(), std::sqrt(hit.squared), exact);
  const auto [a, b, c] = cornersOf(*one.surface, hit.face);
  const MeshOracle alone({{a.cast<float>(), b.cast<float>(), c.cast<float>()}, {{0, 1, 2}}});
  ASSERT_LE((alone.nearest(q_M).p_M - hit.p_M).norm(), exact);  // the one point of it that is nearest
}

void expectNearest(double min, double exact, const Hit& hit) {
  ASSERT_GE(std::sqrt(hit.squared), min - exact) << "nearer than any point of the mesh";
  if (hit.is_proved) {
    ASSERT_LE(std::sqrt(hit.squared), min + exact) << "said to be proved";
  }
}

/// How many of the hits along the queries are proved; each is looked at.
int sweep(const Case& one, const std::vector<Search>& searches, const std::vector<Vec3>& asked) {
  std::vector<SearchState> states(searches.size());
  int proved = 0;
  for (const Vec3& q_M : asked) {
    const double min = one.oracle.distance(q_M);
    for (std::size_t i = 0; i < searches.size(); ++i) {
      const Hit hit = nearestPoint(*one.surface, searches[i], q_M, states[i]);
      proved += hit.is_proved ? 1 : 0;
      expectNearest(min, one.exact(q_M), hit);
      expectSound(one, q_M, hit);
      if (testing::Test::HasFatalFailure()) {
        ADD_FAILURE() << one.mesh.name << ", search " << static_cast<int>(searches[i]) << ", q " << q_M.transpose();
        return proved;
      }
    }
  }
  return proved;
}

/// Where more faces are at one distance than a search may look at, or the mesh is a point: from anywhere that is far.
bool mayLackProof(const std::string& name) {
  return name == "one face fifty thousand times" || name == "ball" || name == "a face that is a point";
}

class EveryMesh : public testing::TestWithParam<OddMesh> {
 protected:
  EveryMesh() : one_(GetParam()) {}
  std::vector<Vec3> handPath(int milliseconds, std::uint64_t seed) const {
    return test::handPath(one_.mesh.triangles, one_.mm, milliseconds, Seed{seed});
  }
  /// How often it is asked. Where all faces are at one distance a search looks at all of them, which is dear: a sample
  /// is a tenth.
  int times(int sampled, int full) const {
    return test::dearSweep(one_.mesh.name == "one face fifty thousand times" ? sampled / 10 : sampled, full);
  }
  Case one_;
};

TEST_P(EveryMesh, IsSearchedExactlyAsAWhole) {
  const std::vector<Vec3> asked = queries(one_, times(2000, 100000), 20070614);
  const int proved = sweep(one_, {Search::Global, Search::Hybrid}, asked);
  EXPECT_TRUE(proved == 2 * static_cast<int>(asked.size()) || mayLackProof(one_.mesh.name)) << proved;
}

TEST_P(EveryMesh, IsSearchedExactlyAlongAHandsPath) {
  const std::vector<Vec3> path = handPath(times(2000, 100000), 20070615);
  const int proved = sweep(one_, {Search::Hybrid}, path);
  EXPECT_TRUE(proved == static_cast<int>(path.size()) || mayLackProof(one_.mesh.name)) << proved;
}

TEST_P(EveryMesh, IsTheSameByHybridAndByGlobalSearch) {
  SearchState hybrid_state, global_state;
  for (const Vec3& q_M : handPath(times(2000, 20000), 20070616)) {
    const Hit hybrid = nearestPoint(*one_.surface, Search::Hybrid, q_M, hybrid_state);
    const Hit global = nearestPoint(*one_.surface, Search::Global, q_M, global_state);
    if (!hybrid.is_proved || !global.is_proved) continue;
    ASSERT_NEAR(std::sqrt(hybrid.squared), std::sqrt(global.squared), one_.exact(q_M)) << q_M.transpose();
  }
}

TEST_P(EveryMesh, IsNotSaidToBeProvedByALocalSearchThatIsWrong) {
  const int count = times(2000, 20000);
  sweep(one_, {Search::Local}, handPath(count, 20070617));
  sweep(one_, {Search::Local}, queries(one_, count, 20070618));  // from anywhere to anywhere: mostly no proof
}

TEST_P(EveryMesh, GivesTheSameBitsAgain) {
  const auto again = makeSurface(one_.mesh.triangles).value();
  SearchState first, second;
  for (const Vec3& q_M : queries(one_, 200, 20070619)) {
    const Hit a = nearestPoint(*one_.surface, Search::Hybrid, q_M, first);
    const Hit b = nearestPoint(*again, Search::Hybrid, q_M, second);
    ASSERT_EQ(a.p_M, b.p_M);
    ASSERT_EQ(a.face, b.face);
    ASSERT_EQ(a.visits, b.visits);
  }
}

TEST_P(EveryMesh, HasANormalOfLengthOneOrNone) {
  SearchState state;
  for (const Vec3& q_M : queries(one_, 500, 20070620)) {
    const Vec3 outward_M = outwardAt(*one_.surface, nearestPoint(*one_.surface, Search::Global, q_M, state));
    ASSERT_TRUE(outward_M.isZero(0.0) || std::abs(outward_M.norm() - 1.0) < 1e-6) << outward_M.transpose();
  }
}

TEST_P(EveryMesh, TellsInsideFromOutsideWhereItPartsSpace) {
  EXPECT_TRUE(one_.surface->is_closed || !one_.mesh.parts_space);
  if (!one_.mesh.parts_space) return;
  SearchState state;
  int inside = 0, outside = 0;
  for (const Vec3& q_M : queries(one_, test::dearSweep(1000, 20000), 20070621)) {
    const Hit hit = nearestPoint(*one_.surface, Search::Global, q_M, state);
    // Corners' normals are floats, good to 1e-7: nearer to the surface than that of its size a side is none.
    if (!hit.is_proved || std::sqrt(hit.squared) < 1e-6 * one_.mm) continue;
    const bool is_inside = outwardAt(*one_.surface, hit).dot(q_M - hit.p_M) < 0.0;
    ASSERT_EQ(is_inside, one_.oracle.isInside(q_M)) << one_.mesh.name << " " << q_M.transpose();
    ++(is_inside ? inside : outside);
  }
  EXPECT_GT(inside, 0);
  EXPECT_GT(outside, 0);
}

INSTANTIATE_TEST_SUITE_P(Mesh, EveryMesh, testing::ValuesIn(everyMesh()), [](const auto& one) {
  std::string name = one.param.name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
});

TEST(NearestPoint, InTheMiddleOfABallEndsInTimeWithAPointOfIt) {
  const OddMesh ball{"ball", mesh_maker::bumpySphere(300000), true};
  Triangles round = ball.triangles;
  for (Eigen::Vector3f& p_MV : round.p_MV) p_MV = (40.0 * p_MV.cast<double>().normalized()).cast<float>();
  const Case one({"ball", round, true});
  for (const Search search : {Search::Global, Search::Hybrid, Search::Local}) {
    SearchState state;
    static_cast<void>(nearestPoint(*one.surface, search, {0, 0, 1}, state));
    const Hit hit = nearestPoint(*one.surface, search, Vec3::Zero(), state);
    EXPECT_LE(hit.visits, kMaxVisits);
    expectSound(one, Vec3::Zero(), hit);
    expectNearest(one.oracle.distance(Vec3::Zero()), one.exact(Vec3::Zero()), hit);
  }
}

TEST(NearestPoint, LocalMayStayOnAnotherSideAndThenSaysSo) {  // or the tests above could not fail for it
  const Case one({"plate", mesh_maker::plate(1.0, 20000), true});
  SearchState state;
  static_cast<void>(nearestPoint(*one.surface, Search::Local, {0, 0, 3}, state));
  const Hit hit = nearestPoint(*one.surface, Search::Local, {0, 0, -2}, state);
  EXPECT_FALSE(hit.is_proved && std::sqrt(hit.squared) > 1.5 + 1e-9);
  const Hit whole = nearestPoint(*one.surface, Search::Hybrid, {0, 0, -2}, state);
  EXPECT_TRUE(whole.is_proved);
  EXPECT_NEAR(std::sqrt(whole.squared), 1.5, 1e-12);
}

TEST(NearestPoint, OnTheSurfaceIsThePointItself) {
  const Case one({"bracket", mesh_maker::bracket(20000), true});
  SearchState state;
  for (const Vec3& q_M : test::pointsNear(one.mesh.triangles, 0.0, 2000, Seed{20070622})) {
    const Hit hit = nearestPoint(*one.surface, Search::Hybrid, q_M, state);
    ASSERT_TRUE(hit.is_proved);
    ASSERT_LE((hit.p_M - q_M).norm(), one.exact(q_M));
  }
}

}  // namespace
}  // namespace underact::mesh
