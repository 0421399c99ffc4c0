#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <memory>

#include "tests/bench/mesh/party.h"

// Usage: underact-mesh-bench-cgal CASE ANSWERS. CGAL is GPL: this program is for benchmarks and is not installed.
namespace underact::bench {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

std::unique_ptr<Mesh> meshOf(const mesh::Triangles& triangles) {
  auto made = std::make_unique<Mesh>();
  std::vector<Mesh::Vertex_index> corners;
  for (const Eigen::Vector3f& p_MV : triangles.p_MV) {
    corners.push_back(made->add_vertex(
        {static_cast<double>(p_MV.x()), static_cast<double>(p_MV.y()), static_cast<double>(p_MV.z())}));
  }
  const auto at = [&](std::int32_t number) { return corners[static_cast<std::size_t>(number)]; };
  for (const mesh::Face& face : triangles.faces) made->add_face(at(face[0]), at(face[1]), at(face[2]));
  return made;
}

struct AskTree {
  const Tree* tree;
  bool from_last;
  bool knows = false;
  Tree::Point_and_primitive_id last = {};

  double operator()(const Vec3& q_M) {
    const Kernel::Point_3 q(q_M.x(), q_M.y(), q_M.z());
    last = from_last && knows ? tree->closest_point_and_primitive(q, last) : tree->closest_point_and_primitive(q);
    knows = true;
    return CGAL::squared_distance(q, last.first);
  }
};

}  // namespace
}  // namespace underact::bench

int main(int count, char** words) {
  using namespace underact::bench;
  if (count != 3) return 2;
  const Case one = read(words[1]);
  std::unique_ptr<Mesh> mesh;
  Tree tree;
  Line line = built("CGAL", [&] {
    mesh = meshOf(one.triangles);
    tree.insert(faces(*mesh).first, faces(*mesh).second, *mesh);
    tree.build();
    tree.accelerate_distance_queries();
  });
  Teller teller(one, words[2]);
  line.note = "its own hints";
  teller.tell(line, AskTree{&tree, false});
  line.by = "CGAL, hinted";
  line.note = "the last answer is the hint";
  teller.tell(line, AskTree{&tree, true});
  return 0;
}
