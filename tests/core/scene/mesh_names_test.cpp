#include "core/scene/mesh_names.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/scene/load_meshes.h"
#include "core/scene/mesh_notes.h"
#include "tests/support/scratch_folder.h"

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

TEST(MeshNames, OfAnotherSystemMeanTheOneFileThatDiffersInFormAlone) {
  const test::ScratchFolder folder;
  for (const char* below : {"meshes", "Two", "two", "meshes/dir.stl"})
    std::filesystem::create_directory(folder.file(below));
  for (const char* name : {"meshes/knee.stl", "meshes/Knie ü.stl", "meshes/A\u030A.stl", "meshes/й.stl", "Two/m.stl",
                           "two/M.stl", "a\\b.stl"})
    folder.write(name, "");
  const auto is = [&](const std::string& written, const std::string& meant, const std::string& nearest) {
    const Description scene = sceneAt(folder.file("s.json"), written);
    EXPECT_EQ(pathOf(written, scene), folder.file(meant.empty() ? written : meant));
    EXPECT_EQ(meshNotes(scene).size(), meant.empty() || meant == written ? 0U : 1U) << written;
    const std::string sentence = nearest.empty() ? "No." : "No. The nearest name is \"" + nearest + "\".";
    EXPECT_EQ(withNearest({{"No.", {}}}, written, scene)[0].sentence, sentence);
  };
  is("a\\b.stl", "a\\b.stl", "");
  for (const std::string& written : {std::string("meshes\\knee.stl"), std::string("./Meshes/../meshes/Knee.STL "),
                                     "file://" + folder.file("meshes/knee.stl")})
    is(written, "meshes/knee.stl", "");
  is("meshes/Knie u\u0308.stl", "meshes/Knie ü.stl", "");
  is("meshes/å.stl", "meshes/A\u030A.stl", "");
  is("meshes/и\u0306.stl", "meshes/й.stl", "");
  is("TWO/m.stl", "", "Two/m.stl");  // two fit
  is("meshes/Knie ö.stl", "", "meshes/Knie ü.stl");
  for (const char* written : {"C:\\a\\knee.stl", "~/knees.stl", "../x/knee.stl"}) is(written, "", "meshes/knee.stl");
  is("meshes/Dir.stl", "", "");
  is("." + std::string(9000, '/') + "x", "", "");
  for (const char* name : {"file:///home/a/k.stl", "..\\secret\\k.stl", "~/secret/k.stl"})
    EXPECT_EQ(nameIn(withoutFolders(sceneAt("/a/s.json", name))), "k.stl") << name;
}

TEST(MeshNames, SecondTimeNothingChanges) {
  const Description once = namedFrom(sceneAt("/a/b/s.json", "m.stl"), "/a/c/t.json");
  EXPECT_EQ(nameIn(namedFrom(once, "/a/c/t.json")), nameIn(once));
}

}  // namespace underact::scene
