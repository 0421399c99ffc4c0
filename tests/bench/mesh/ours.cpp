#include <memory>

#include "core/mesh/search.h"
#include "core/mesh/surface.h"
#include "tests/bench/mesh/party.h"

// Usage: underact-mesh-bench-ours CASE ANSWERS
int main(int count, char** words) {
  using namespace underact;
  if (count != 3) return 2;
  const bench::Case one = bench::read(words[1]);
  std::shared_ptr<const mesh::Surface> surface;
  bench::Line line = bench::built("", [&] { surface = mesh::makeSurface(one.triangles).value(); });
  line.own_MB = static_cast<double>(mesh::bytesOf(*surface)) / 1e6;
  const struct {
    const char* name;
    mesh::Search search;
  } variants[] = {{"underact hybrid", mesh::Search::Hybrid},
                  {"underact global", mesh::Search::Global},
                  {"underact local", mesh::Search::Local}};
  bench::Teller teller(one, words[2]);
  for (const auto& variant : variants) {
    line.by = variant.name;
    const auto ask = [&surface = *surface, search = variant.search, state = mesh::SearchState()](
                         const Vec3& q_M) mutable { return mesh::nearestPoint(surface, search, q_M, state).squared; };
    line.note = variant.search == mesh::Search::Local ? "the first minimum, which need not be the least" : "";
    teller.tell(line, ask);
  }
  return 0;
}
