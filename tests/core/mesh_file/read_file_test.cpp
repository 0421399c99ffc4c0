#include "core/mesh_file/read_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <sstream>

#include "core/mesh_file/limits.h"
#include "core/mesh_file/load.h"
#include "core/mesh_file/report.h"
#include "tests/core/mesh_file/some_meshes.h"

namespace underact::mesh_file {
namespace {

RawMesh readOrFail(const test::ScratchFolder& folder, const std::string& name, const std::string& content) {
  Result<RawMesh> raw = readFile(folder.write(name, content));
  EXPECT_TRUE(raw) << name << ": " << (raw ? "" : raw.problems()[0].sentence);
  return raw ? std::move(raw).value() : RawMesh{};
}

std::string problemOf(const test::ScratchFolder& folder, const std::string& name, const std::string& content) {
  const Result<RawMesh> raw = readFile(folder.write(name, content));
  EXPECT_FALSE(raw) << name;
  return raw ? "" : raw.problems()[0].sentence;
}

/// Face by face, the same points in the same order, whatever they are numbered.
void expectSame(const mesh::Triangles& read, const mesh::Triangles& meant, const std::string& what) {
  ASSERT_EQ(read.faces.size(), meant.faces.size()) << what;
  for (std::size_t face = 0; face < meant.faces.size(); ++face) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto at = [&](const mesh::Triangles& mesh) {
        return mesh.p_MV[static_cast<std::size_t>(mesh.faces[face][k])];
      };
      ASSERT_EQ(at(read), at(meant)) << what << " face " << face;
    }
  }
}

TEST(ReadFile, EveryFormatComesBackToTheBit) {
  const test::ScratchFolder folder;
  const mesh::Triangles meant = test::ball(0.1F, 2);  // 0.1 and its like are no short decimals
  for (const auto& [name, content] : std::vector<std::pair<std::string, std::string>>{
           {"b.stl", test::stlBinary(meant)},
           {"solid.stl", test::stlBinary(meant, "solid by a careless writer")},
           {"t.stl", test::stlText(meant)},
           {"m.obj", test::obj(meant)},
           {"m.off", test::off(meant)},
           {"t.ply", test::plyText(meant)},
           {"l.ply", test::plyBinary(meant)},
           {"b.ply", test::plyBinary(meant, true)},
           {"no extension", test::plyBinary(meant)},
           {"wrong.obj", test::stlBinary(meant)}}) {
    const RawMesh raw = readOrFail(folder, name, content);
    expectSame(raw.triangles, meant, name);
    EXPECT_EQ(raw.polygons, static_cast<std::int64_t>(meant.faces.size())) << name;
    EXPECT_LT(raw.peak_bytes, static_cast<std::int64_t>(maxMemory(content.size()))) << name;
  }
}

TEST(ReadFile, LinesMayEndAsTheyDoAnywhere) {
  const test::ScratchFolder folder;
  const mesh::Triangles meant = test::cube(3.0F);
  for (const char* end : {"\r\n", "\r", "\n\n"}) {
    const auto with = [end](std::string text) {
      for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += std::string(end).size()) {
        text.replace(at, 1, end);
      }
      return text;
    };
    expectSame(readOrFail(folder, "m.stl", with(test::stlText(meant))).triangles, meant, "STL");
    expectSame(readOrFail(folder, "m.obj", with(test::obj(meant))).triangles, meant, "OBJ");
    expectSame(readOrFail(folder, "m.off", with(test::off(meant))).triangles, meant, "OFF");
  }
  std::string header = test::plyBinary(meant);
  for (std::size_t at = 0; (at = header.find('\n', at)) != std::string::npos && at < 200; at += 2) {
    header.replace(at, 1, "\r\n");
    if (header.compare(at + 2, 10, "end_header") == 0) {
      header.replace(at + 12, 1, "\r\n");
      break;
    }
  }
  expectSame(readOrFail(folder, "m.ply", header).triangles, meant, "PLY");
}

TEST(ReadFile, ASolidMayBeCalledAnything) {
  const test::ScratchFolder folder;
  std::string content = test::stlText(test::cube(1.0F));
  content.replace(0, 13, "solid router facet outer loop vertex 1 2 3");
  expectSame(readOrFail(folder, "m.stl", content).triangles, test::cube(1.0F), "named");
}

TEST(ReadFile, TheWordsThatEndMayBeTwo) {  // "end solid", as some programs write
  const test::ScratchFolder folder;
  std::string content = test::stlText(test::cube(1.0F));
  for (std::size_t at = 0; (at = content.find("end", at)) != std::string::npos; at += 4) content.insert(at + 3, " ");
  expectSame(readOrFail(folder, "m.stl", content).triangles, test::cube(1.0F), "two words");
}

TEST(ReadFile, SkipsSectionsThatItDoesNotRead) {
  const test::ScratchFolder folder;
  mesh::Triangles meant;
  meant.p_MV = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  meant.faces = {{0, 1, 2}};
  expectSame(
      readOrFail(folder, "colours.off",
                 "COFF # with colours\n3 1 0 # counts\n0 0 0 255 0 0 255\n1 0 0 0 0 0 1\n\n0 1 0 # last\n3 0 1 2 "
                 "255 0 0\n")
          .triangles,
      meant, "OFF");
  expectSame(readOrFail(folder, "plain.off", "OFF 3 1 3\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 9 9 9").triangles, meant, "OFF");
  expectSame(
      readOrFail(folder, "lists.ply",
                 "ply\nformat ascii 1.0\nobj_info x\nelement camera 1\nproperty float a\nelement vertex "
                 "3\nproperty uchar red\nproperty double z\nproperty double x\nproperty double y\nelement face "
                 "1\nproperty list uchar float texcoord\nproperty list uint8 uint vertex_index\nproperty int "
                 "flags\nelement edge 1\nproperty int v\nend_header\n7\n1 0 0 0\n1 0 1 0\n1 0 0 1\n2 .5 .5 3 0 1 "
                 "2 8\n3\n")
          .triangles,
      meant, "PLY");
  expectSame(readOrFail(folder, "rich.obj",
                        "mtllib /etc/passwd\nvn 0 0 1\nv 0 0 0 1.0\nv 1 0 0 \\\n 0.5 0.5 0.5\nvt 0 0\nv 0 1 0\nusemtl "
                        "x\ns off\nf -3/1/1 -2/1/1 \\\n -1/1/1 # end\nl 1 2\n")
                 .triangles,
             meant, "OBJ");
}

TEST(ReadFile, PolygonsAreCutWithinThemselves) {
  const test::ScratchFolder folder;
  // A quad whose fourth corner is bent in, a star of ten corners, a U of eight: areas by hand.
  const RawMesh arrow = readOrFail(folder, "q.obj", "v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\nf 1 2 3 4\nf 2 3 4 1\n");
  EXPECT_EQ(arrow.triangles.faces.size(), 4U);
  EXPECT_NEAR(test::areaOf(arrow.triangles), 2 * 4.0, 1e-12);
  const RawMesh u = readOrFail(
      folder, "u.off", "OFF\n8 1 0\n0 0 0\n3 0 0\n3 3 0\n2 3 0\n2 1 0\n1 1 0\n1 3 0\n0 3 0\n8 0 1 2 3 4 5 6 7\n");
  EXPECT_EQ(u.triangles.faces.size(), 6U);
  EXPECT_NEAR(test::areaOf(u.triangles), 9.0 - 2.0, 1e-12);
  std::string star = "";
  for (int k = 0; k < 10; ++k) {
    const double r = k % 2 == 0 ? 2.0 : 0.5, a = 0.628318530717958648 * k;
    star += "v " + std::to_string(r * std::cos(a)) + " " + std::to_string(r * std::sin(a)) + " 0\n";
  }
  const RawMesh cut = readOrFail(folder, "s.obj", star + "f 1 2 3 4 5 6 7 8 9 10\n");
  EXPECT_NEAR(test::areaOf(cut.triangles), 10 * 0.5 * 2.0 * 0.5 * std::sin(0.628318530717958648), 1e-5);  // 6 decimals
}

TEST(ReadFile, LeavesOutAndCountsWhatIsNoFace) {
  const test::ScratchFolder folder;
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nv 1e999 0 0\nv 1.#QNAN 0 0\nv 1e-999 0 1\n";
  const RawMesh raw = readOrFail(
      folder, "m.obj", corners + "f 1 2 3\nf 1 2 4\nf 1 5 2\nf 3 6 2 1\nf 1 2 9\nf 0 1 2\nf 1 1 2\nf 1 2\nf 1 2 7\n");
  EXPECT_EQ(raw.triangles.faces.size(), 2U);
  EXPECT_EQ(raw.polygons, 9);
  EXPECT_EQ(raw.dropped.not_finite, 3);
  EXPECT_EQ(raw.dropped.out_of_range, 2);
  EXPECT_EQ(raw.dropped.without_extent, 2);
  for (const Eigen::Vector3f& p_MV : raw.triangles.p_MV) EXPECT_TRUE(p_MV.allFinite());

  const float nan = std::nanf(""), inf = INFINITY;
  mesh::Triangles soup_of = test::soup(test::cube(1.0F));
  soup_of.p_MV[4].x() = nan;
  soup_of.p_MV[10].z() = -inf;
  soup_of.p_MV[15] = soup_of.p_MV[16];
  for (const std::string& content : {test::stlBinary(soup_of), test::stlText(soup_of)}) {
    const RawMesh stl = readOrFail(folder, "m.stl", content);
    EXPECT_EQ(stl.triangles.faces.size(), 9U);
    EXPECT_EQ(stl.dropped.not_finite, 2);
    EXPECT_EQ(stl.dropped.without_extent, 1);
  }
  const RawMesh ply = readOrFail(folder, "m.ply", test::plyBinary(soup_of));
  EXPECT_EQ(ply.dropped.not_finite, 2);
  EXPECT_EQ(readOrFail(folder, "t.ply", test::plyText(soup_of)).dropped.not_finite, 2);
  EXPECT_EQ(readOrFail(folder, "m.off", test::off(soup_of)).dropped.not_finite, 2);
}

TEST(ReadFile, FacesThatOpenMeshRefusesAreNotLost) {
  // Three faces at one edge, and one of them again the other way round.
  const test::ScratchFolder folder;
  const RawMesh raw = readOrFail(
      folder, "m.off", "OFF\n5 4 0\n0 0 0\n1 0 0\n0 1 0\n0 -1 0\n0 0 1\n3 0 1 2\n3 0 1 3\n3 0 1 4\n3 1 0 4\n");
  EXPECT_EQ(raw.triangles.faces.size(), 4U);
}

TEST(ReadFile, NormalsOfAnStlAgainstItsCornersAreCounted) {
  const test::ScratchFolder folder;
  std::string content = test::stlBinary(test::cube(1.0F));
  for (std::size_t face = 0; face < 5; ++face) {
    for (std::size_t axis = 0; axis < 3; ++axis) content[84 + 50 * face + 4 * axis + 3] ^= static_cast<char>(0x80);
  }
  const RawMesh raw = readOrFail(folder, "m.stl", content);
  EXPECT_EQ(raw.normals, 12);
  EXPECT_EQ(raw.normals_against, 5);
}

TEST(ReadFile, DamageIsSaidInASentence) {
  const test::ScratchFolder folder;
  const mesh::Triangles good = test::cube(1.0F);
  const std::string stl = test::stlBinary(good), ply = test::plyBinary(good);
  const auto head = [](std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
  };
  for (const auto& [name, content, expected] : std::vector<std::array<std::string, 3>>{
           {"empty.stl", "", "The file is empty."},
           {"cut.stl", stl.substr(0, 500),
            "The file is truncated or damaged: it declares 12 faces, but is too short for that."},
           {"head.stl", stl.substr(0, 83),
            "The file is truncated or damaged: it declares a binary STL mesh, but is too short for that."},
           {"none.stl", stl.substr(0, 80) + std::string(4, '\0'), "The file contains no faces."},
           {"word.stl", head(test::stlText(good), "endloop", "endlopp"),
            "The file is damaged: line 7 does not end the three vertices of a face (endloop)."},
           {"number.stl", head(test::stlText(good), "vertex 0", "vertex O"),
            "The file is damaged: line 4 is not a vertex of a face (vertex x y z)."},
           {"line.obj", "v 0 0 0\nv 1 0\n", "The file is damaged: line 2 is not a vertex (v x y z)."},
           {"face.obj", "v 0 0 0\nf 1 x 2\n", "The file is damaged: line 2 is not a face."},
           {"many.off", head(test::off(good), "8 12 0", "8000000000 12 0"),
            "The file is truncated or damaged: it declares 8000000000 vertices and 12 faces, but is too short for "
            "that."},
           {"more.off", head(test::off(good), "8 12 0", "8 20 0"),
            "The file is damaged: it ends at line 24, and vertices or faces are missing."},
           {"binary.off", "OFF BINARY\n",
            "This is a binary OFF file, which cannot be read. Save it as text, or as STL or PLY."},
           {"four.off", "4OFF\n1 1 0\n", "The mesh in the OFF file is not three-dimensional."},
           {"points.off", "OFF\n1 0 0\n0 0 0\n", "The OFF file contains points but no faces. A surface needs faces."},
           {"tail.ply", ply.substr(0, ply.size() - 40), "The file is damaged: face 9 of 12 cannot be read."},
           {"cut.ply", ply.substr(0, ply.size() - 150),
            "The file is truncated or damaged: it declares 8 vertices and 12 faces, but is too short for that."},
           {"list.ply", head(ply, std::string("\3\0", 2), std::string("\xFF\0", 2)),
            "The file is damaged: face 1 of 12 cannot be read."},
           {"text.ply", head(test::plyText(good), "\n0 0 0\n", "\n0 0 zero\n"),
            "The file is damaged: vertex 1 of 8 cannot be read."},
           {"points.ply", head(test::plyText(good), "element face 12", "element face 0"),
            "The PLY file contains points but no faces. A surface needs faces: create them in the program that made "
            "the points."},
           {"whole.ply", head(test::plyText(good), "property float y", "property int y"),
            "The PLY file contains y of its vertices as integers. Save it with float or double coordinates."},
           {"twice.ply", head(test::plyText(good), "comment by hand", "element vertex 3"),
            "The PLY header is damaged: it declares vertices or faces twice."},
           {"odd.ply", head(test::plyText(good), "property float x", "property half x"),
            "The PLY header is damaged: line 5 is not valid."},
           {"words.stl", "no mesh", "This is not a mesh that can be read. Use an STL, OBJ, PLY or OFF file."},
           {"photo.png", "\x89PNG\r\n\x1A\n",
            "This is a picture (PNG). Underact opens scenes, sessions, arm files, meshes, points of curves, lessons, "
            "lists "
            "of figures and notebooks."},
           {"not.ply", "hello", "This is not a PLY file: it does not begin with \"ply\"."}}) {
    EXPECT_EQ(problemOf(folder, name, content), expected) << name;
  }
}

TEST(ReadFile, AFileOfAnotherKindIsCalledWhatItIs) {
  const test::ScratchFolder folder;
  std::istringstream rows(
      "gzip|\x1F\x8B\b\nZIP|PK\3\4\nxz|\xFD\x37zXZ\nZstandard|\x28\xB5\x2F\xFD\n7z|7z\xBC\xAF\x27\x1C\nbzip2|"
      "BZh91AY\nPDF|%PDF-1.7\n"
      "STEP|ISO-10303-21;\nJPEG|\xFF\xD8\xFF\xE0\nUTF-16|\xFF\xFEs\nGit LFS|version "
      "https://git-lfs.github.com/spec/v1\n"
      "web page|\xEF\xBB\xBF <!DOCTYPE HTML>\nweb page|<HTML lang\nIGES|" +
      std::string(72, ' ') + "S      1\n");
  for (std::string kind, bytes; std::getline(rows, kind, '|') && std::getline(rows, bytes);)
    EXPECT_NE(problemOf(folder, "m.stl", bytes + "\n").find(kind), std::string::npos) << kind;
}

TEST(ReadFile, AMarkOfUtf8ChangesNothing) {
  const test::ScratchFolder folder;
  const mesh::Triangles meant = test::cube(3.0F);
  for (const std::string& text :
       {test::stlText(meant), test::obj(meant), test::off(meant), test::plyText(meant), test::plyBinary(meant)})
    expectSame(readOrFail(folder, "m", "\xEF\xBB\xBF" + text).triangles, meant, text.substr(0, 5));
  for (const char* head : {"\xEF\xBB\xBFsolid", "\xFF\xFE", "PK\3\4"})  // of a binary STL says nothing
    expectSame(readOrFail(folder, "m.stl", test::stlBinary(meant, head)).triangles, meant, head);
}

TEST(ReadFile, ABinaryStlIsReadByItsLengthOrThatOfItsAttributes) {
  const test::ScratchFolder folder;
  const mesh::Triangles meant = test::cube(3.0F);
  const auto with = [&](std::uint32_t count, std::size_t even, std::size_t odd) {  // bytes behind every second face
    const std::string whole = test::stlBinary(meant);
    std::string content = whole.substr(0, 80) + test::bytesOf(count);
    for (std::size_t face = 0, bytes = even; face < 12; ++face, bytes = face % 2 == 0 ? even : odd)
      content += whole.substr(84 + 50 * face, 48) + static_cast<char>(bytes) + static_cast<char>(bytes >> 8U) +
                 std::string(bytes, 'x');
    return content;
  };
  const std::string left = "What belongs to no face was skipped: ", given = "The file declares ",
                    by = " faces, but has the length of 12: these were read.";
  for (const auto& [content, report] : {std::pair{with(0, 0, 0), given + "0" + by},
                                        {with(5, 0, 0), given + "5" + by},
                                        {with(~0U, 0, 0), given + "4294967295" + by},
                                        {with(12, 4, 4), left + "48 B."},
                                        {with(12, 50, 50), left + "600 B."},
                                        {with(12, 0, 300), left + "1800 B."},
                                        {with(12, 0, 0) + "\n", left + "1 B."}}) {
    expectSame(readOrFail(folder, "m.stl", content).triangles, meant, report);
    EXPECT_EQ(reportOf(loadMesh(folder.file("m.stl"), {}, Cache("/dev/null")).value().facts, 1.0)[0], report);
  }
  for (const std::string& content : {with(12, 4, 4) + "x", with(12, 4, 4).substr(0, 731)})
    EXPECT_EQ(problemOf(folder, "m.stl", content), "The file is damaged: its length does not fit its faces.");
}

TEST(ReadFile, RefusesAPathThatIsNoFile) {
  const test::ScratchFolder folder;
  EXPECT_EQ(readFile(folder.path()).problems()[0].sentence, "This is a folder, not a mesh file.");
  EXPECT_EQ(readFile(folder.path() + "/none.stl").problems()[0].sentence,
            "The file cannot be opened: No such file or directory.");
  EXPECT_EQ(readFile("/dev/null").problems()[0].sentence,
            "This is a pipe, a device or a socket, not a regular file, so a mesh is not read from it. Save its output "
            "to a file, and give that file.");
  const std::string path = folder.write("real.obj", test::obj(test::cube(1.0F)));
  std::filesystem::create_symlink(path, folder.path() + "/link.obj");
  EXPECT_TRUE(readFile(folder.path() + "/link.obj"));
  std::filesystem::resize_file(folder.write("huge.stl", ""), (std::uint64_t{4} << 30) + 1);  // sparse
  EXPECT_EQ(readFile(folder.path() + "/huge.stl").problems()[0].sentence,
            "The file is larger than 4 GiB. Make the mesh coarser, or save it in parts.");
}

}  // namespace
}  // namespace underact::mesh_file
