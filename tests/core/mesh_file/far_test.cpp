#include <gtest/gtest.h>

#include <charconv>
#include <cstring>

#include "core/mesh/search.h"
#include "core/mesh/surface_bytes.h"
#include "core/mesh_file/load.h"
#include "core/mesh_file/report.h"
#include "tests/core/mesh_file/some_meshes.h"

namespace underact::mesh_file {
namespace {

using Points = std::vector<Vec3>;

/// A cube of edge 10 whose corner is there, in digits that no float holds.
constexpr double kAt = 900'000.0123;

std::string digits(double value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

std::string far(const std::string& corner_begins, const std::string& head, const std::string& face_begins, int first) {
  const mesh::Triangles cube = test::cube(10.0F);
  std::string text = head;
  for (const Eigen::Vector3f& p : cube.p_MV) {
    text += corner_begins;
    for (const float x : p) text += digits(kAt + static_cast<double>(x)) + ' ';
    text += '\n';
  }
  for (const auto& [a, b, c] : cube.faces) {
    text += face_begins + std::to_string(a + first) + ' ' + std::to_string(b + first) + ' ' + std::to_string(c + first);
    text += '\n';
  }
  return text;
}

std::string farPly(const std::string& format) {
  return "ply\nformat " + format +
         " 1.0\nelement vertex 8\nproperty double x\nproperty double y\nproperty double z\nelement face 12\n"
         "property list uchar int vertex_indices\nend_header\n";
}

std::string farPlyBinary() {
  const mesh::Triangles cube = test::cube(10.0F);
  std::string bytes = farPly("binary_little_endian");
  for (const Eigen::Vector3f& p : cube.p_MV) {
    for (const float x : p) {
      const double value = kAt + static_cast<double>(x);
      bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
  }
  for (const mesh::Face& face : cube.faces) {
    bytes += '\3';
    bytes.append(reinterpret_cast<const char*>(face.data()), sizeof face);
  }
  return bytes;
}

std::string farStl() {
  const mesh::Triangles cube = test::cube(10.0F);
  std::string text = "solid far\n";
  for (const mesh::Face& face : cube.faces) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const std::int32_t corner : face) {
      text += "vertex ";
      for (const float x : cube.p_MV[static_cast<std::size_t>(corner)])
        text += digits(kAt + static_cast<double>(x)) + ' ';
      text += '\n';
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid\n";
}

TEST(FarMesh, KeepsItsShapeFarFromItsOrigin) {
  const test::ScratchFolder folder;
  const std::vector<std::pair<const char*, std::string>> files{{"far.obj", far("v ", "", "f ", 1)},
                                                               {"far.off", far("", "OFF\n8 12 0\n", "3 ", 0)},
                                                               {"far.ply", far("", farPly("ascii"), "3 ", 0)},
                                                               {"farb.ply", farPlyBinary()},
                                                               {"far.stl", farStl()}};
  for (const auto& [name, content] : files) {
    const Cache cache(folder.path() + "/cache");
    for (const bool again : {false, true}) {
      const Result<Loaded> loaded = loadMesh(folder.write(name, content), {}, cache);
      ASSERT_TRUE(loaded) << name;
      EXPECT_EQ(loaded.value().from_cache, again) << name;
      const mesh::Surface& surface = *loaded.value().surface;
      mesh::SearchState state;
      const Vec3 q_M = Vec3(3.0, 4.0, 12.0) + Vec3::Constant(kAt);
      const mesh::Hit hit = nearestPoint(surface, mesh::Search::Global, q_M - surface.origin_M, state);
      EXPECT_NEAR((hit.p_M + surface.origin_M - Vec3::Constant(kAt) - Vec3(3.0, 4.0, 10.0)).norm(), 0.0, 1e-5) << name;
      EXPECT_NEAR(loaded.value().facts.low[0], kAt, 1e-5) << name;
      EXPECT_NEAR(largestExtent(loaded.value().facts), 10.0, 1e-5) << name;
      EXPECT_EQ(precisionReport(loaded.value().facts, 1.0), "") << name;
    }
  }
}

TEST(FarMesh, ThatIsNotFarStaysWhereItIsToTheBit) {
  const test::ScratchFolder folder;
  mesh::Triangles cube = test::cube(10.0F, {200.0F, -310.0F, 0.1F});
  const Result<Loaded> loaded =
      loadMesh(folder.write("a.stl", test::stlBinary(test::soup(cube))), {}, Cache("/dev/null"));
  EXPECT_EQ(loaded.value().surface->origin_M, Vec3(Vec3::Zero()));
  EXPECT_EQ(loaded.value().surface->low_M, (Eigen::Vector3f(200.0F, -310.0F, 0.1F)));
}

TEST(FarMesh, InFloatsIsAsTheFileHasIt) {
  const test::ScratchFolder folder;
  const mesh::Triangles cube = test::cube(10.0F, Eigen::Vector3f::Constant(900'000.0625F));
  for (const bool is_ply : {false, true}) {
    const std::string path = is_ply ? folder.write("a.ply", test::plyBinary(cube, true))
                                    : folder.write("a.stl", test::stlBinary(test::soup(cube)));
    const Result<Loaded> loaded = loadMesh(path, {}, Cache("/dev/null"));
    const mesh::Surface& surface = *loaded.value().surface;
    EXPECT_EQ(Vec3(surface.origin_M + surface.low_M.cast<double>()), Vec3(Vec3::Constant(900'000.0625)));
    EXPECT_EQ(loaded.value().facts.high[2], 900'010.0625);
    EXPECT_EQ(loaded.value().facts.single_step, 0.0625);
    EXPECT_TRUE(precisionReport(loaded.value().facts, 1.0).starts_with("The mesh is so far from its origin"));
    EXPECT_EQ(precisionReport(loaded.value().facts, 1e-3), "") << "steps of 0.06 um";
  }
}

}  // namespace
}  // namespace underact::mesh_file
