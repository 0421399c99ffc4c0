// underact-mesh-walls FILE ...: of each mesh file whether it is a wall, and of walls by drawn points what is felt
// where: a leak is a point inside that is not pushed out, a phantom one outside that is, an inner wall a target with
// the inside on both its sides. Inside is where the winding number of the file's own faces is above 0, in long doubles.
// Prints a line for each file that is wrong, and sums; on stderr how far it is. Exit status 1: one is wrong.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

#include "core/mesh/proxy.h"
#include "core/mesh_file/input.h"
#include "core/mesh_file/load.h"
#include "core/mesh_file/read_file.h"
#include "core/mesh_file/repair.h"
#include "core/mesh_file/report.h"
#include "tests/support/crossed_bodies.h"
#include "tests/support/mesh_oracle.h"

namespace underact {
namespace {

constexpr int kPoints = 40;         // of a file: half near its faces, half anywhere about it
constexpr double kNearWeld = 20.0;  // nearer than so many weld distances to a face a point says nothing

struct Sums {
  int points = 0, leaks = 0, phantoms = 0, inner = 0;
  double deepest = 0.0;  // leak, of the diagonal
};

std::optional<mesh_file::Repaired> given(const std::string& path) {
  const Result<mesh_file::Input> input = mesh_file::Input::open(path);
  if (!input) return {};
  Result<mesh_file::RawMesh> raw = readFile(input.value(), {});
  if (!raw) return {};
  return mesh_file::repair(std::move(raw.value().triangles));
}

/// The faces as the file has them, so that those of a face that two bodies share cancel.
mesh::Triangles facesOf(const mesh_file::Repaired& repaired) {
  mesh::Triangles triangles = repaired.triangles;
  if (repaired.facts.crowded_edges > 0)
    triangles.faces.insert(triangles.faces.end(), repaired.twice.begin(), repaired.twice.end());
  return triangles;
}

void lookAt(const mesh::Triangles& faces, const mesh_file::Loaded& felt, const Vec3& q_M,
            const test::MeshOracle& oracle, double near, double diagonal, Sums& sums) {
  const double distance = oracle.distance(q_M);
  if (distance < near) return;
  ++sums.points;
  const bool is_in = test::windingOf(faces, q_M) > 0.5L;
  mesh::ProxyState state;
  const mesh::Hit hit = mesh::followProxy(*felt.surface, mesh::FreeSide::Outside, q_M, state);
  if (is_in && hit.face < 0) {
    std::printf("a leak at %.9g %.9g %.9g, %.3g from the faces\n", q_M.x(), q_M.y(), q_M.z(), distance);
    ++sums.leaks;
    sums.deepest = std::max(sums.deepest, distance / diagonal);
  }
  sums.phantoms += !is_in && hit.face >= 0 ? 1 : 0;
  mesh::SearchState search;
  const mesh::Hit nearest = nearestPoint(*felt.surface, mesh::Search::Global, q_M, search);
  // On a surface of the file, or of a gap that nobody feels, the outside is within two weld distances in front of it.
  const double weld = mesh_file::kWeldShare * diagonal;
  const Vec3 out = outwardAt(*felt.surface, nearest);
  bool has_outside = false;
  for (const double height : {0.5, 1.0, 2.0})
    has_outside = has_outside || test::windingOf(faces, nearest.p_M + height * weld * out) < 0.5L;
  if (!has_outside && oracle.distance(nearest.p_M + 2.0 * weld * out) >= 0.6 * weld) ++sums.inner;
}

Sums sumsOf(const mesh::Triangles& faces, const mesh_file::Loaded& felt) {
  Sums sums;
  const test::MeshOracle oracle(faces);
  test::Random random(test::Seed{20070601});
  const Vec3 low = felt.surface->low_M.cast<double>(), high = felt.surface->high_M.cast<double>();
  const double diagonal = (high - low).norm(), near = kNearWeld * mesh_file::kWeldShare * diagonal;
  for (int k = 0; k < kPoints; ++k) {
    Vec3 q_M = 0.5 * (low + high) + 0.55 * (high - low).cwiseProduct(random.inBox(1.0));
    if (k % 2 == 0) {
      const mesh::Face& face = faces.faces[random.below(faces.faces.size())];
      const double a = random.between(0.0, 0.5), b = random.between(0.0, 0.5);
      q_M = (1.0 - a - b) * cornerAt(faces, face[0]) + a * cornerAt(faces, face[1]) + b * cornerAt(faces, face[2]) +
            random.between(0.0, 0.01) * diagonal * random.direction();
    }
    lookAt(faces, felt, q_M, oracle, near, diagonal, sums);
  }
  return sums;
}

int lookAtAll(int count, char** paths) {
  std::map<std::string, int> refused;
  int unread = 0, walls = 0, united = 0, holed = 0, wrong = 0;
  double slowest_s = 0.0;
  Sums all;
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  for (int k = 0; k < count; ++k) {
    if (k % 100 == 0) std::fprintf(stderr, "%d of %d files\n", k, count);  // minutes: the oracles ask every face
    const auto begin = std::chrono::steady_clock::now();
    const Result<mesh_file::Loaded> felt = mesh_file::loadMesh(paths[k], {}, mesh_file::Cache("/dev/null"));
    slowest_s = std::max(slowest_s, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    const std::optional<mesh_file::Repaired> repaired = felt ? given(paths[k]) : std::nullopt;
    if (!repaired) {
      ++unread;
      continue;
    }
    const mesh_file::Facts& facts = felt.value().facts;
    if (!mesh_file::allowsWalls(facts)) {
      ++refused[mesh_file::noWallsReason(facts)];
      continue;
    }
    ++walls;
    united += facts.inside == mesh_file::Inside::United ? 1 : 0;
    holed += facts.closed_holes > 0 ? 1 : 0;
    const Sums sums = sumsOf(facesOf(*repaired), felt.value());
    all.points += sums.points;
    all.leaks += sums.leaks;
    all.phantoms += sums.phantoms;
    all.inner += sums.inner;
    all.deepest = std::max(all.deepest, sums.deepest);
    if (sums.leaks + sums.phantoms + sums.inner == 0) continue;
    ++wrong;
    std::printf("%s: %d leaks, %d phantoms, %d on inner walls of %d\n", paths[k], sums.leaks, sums.phantoms, sums.inner,
                sums.points);
  }
  std::printf("%d files, %d not read, %d walls (%d united, %d with holes closed), %d wrong\n", count, unread, walls,
              united, holed, wrong);
  for (const auto& [why, files] : refused) std::printf("%d no wall: %s\n", files, why.c_str());
  std::printf(
      "%d points, %d leaks (%.3g of the diagonal at most), %d phantoms, %d on inner walls; slowest to load %.2f s\n",
      all.points, all.leaks, all.deepest, all.phantoms, all.inner, slowest_s);
  return wrong > 0 ? 1 : 0;
}

}  // namespace
}  // namespace underact

int main(int count, char** words) {
  return underact::lookAtAll(count - 1, words + 1);
}
