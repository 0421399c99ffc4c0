#include "core/scene/mesh_names.h"

#include <gtest/gtest.h>

#include "core/scene/load_meshes.h"

namespace underact::scene {
namespace {

Description sceneAt(const std::string& scene_file, const std::string& mesh_file) {
  Description scene;
  scene.file = scene_file;
  scene.constraints.emplace_back();
  Mesh mesh;
  mesh.file = mesh_file;
  scene.constraints.back().shape = mesh;
  return scene;
}

std::string nameIn(const Description& scene) {
  return std::get<Mesh>(scene.constraints.front().shape).file;
}

struct Case {
  const char *from, *mesh, *to, *named;
};

}  // namespace

TEST(MeshNames, FromAnotherFolderTheSameFileIsFound) {
  for (const Case& one :
       {Case{"/a/b/s.json", "m.stl", "/a/b/t.json", "m.stl"}, Case{"/a/b/s.json", "m.stl", "/a/c/t.json", "../b/m.stl"},
        Case{"/a/b/s.json", "../m.stl", "/a/t.json", "m.stl"},
        Case{"/a/b/s.json", "/a/b/deep/m.stl", "/a/b/t.json", "deep/m.stl"},
        Case{"", "/a/b/m.stl", "/a/b/c/d/t.json", "../../m.stl"},
        // Three steps up say only where on this disk it is.
        Case{"/a/b/s.json", "m.stl", "/x/y/z/t.json", "/a/b/m.stl"}}) {
    const Description named = namedFrom(sceneAt(one.from, one.mesh), one.to);
    EXPECT_EQ(nameIn(named), one.named) << one.from << " " << one.mesh << " -> " << one.to;
    EXPECT_EQ(named.file, one.to);
  }
}

TEST(MeshNames, SecondTimeNothingChanges) {
  const Description once = namedFrom(sceneAt("/a/b/s.json", "m.stl"), "/a/c/t.json");
  EXPECT_EQ(nameIn(namedFrom(once, "/a/c/t.json")), nameIn(once));
}

}  // namespace underact::scene
