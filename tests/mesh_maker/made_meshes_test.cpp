#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "scenes/meshes/make/meshes.h"
#include "scenes/meshes/make/write.h"
#include "tests/support/mesh_facts.h"
#include "tests/support/property.h"

namespace underact::mesh_maker {
namespace {

constexpr double kPi = 3.141592653589793;
constexpr int kSizes[] = {1000, 20000, 300000};

double girthOf(const Triangles& triangles, int axis) {
  float low = INFINITY, high = -INFINITY;
  for (const Eigen::Vector3f& p_MV : triangles.p_MV) low = std::min(low, p_MV[axis]), high = std::max(high, p_MV[axis]);
  return static_cast<double>(high) - static_cast<double>(low);
}

/// The length of the knot's curve: a sum over small chords, whose error is 1 part in 1e8 here.
double knotLength() {
  const auto at = [](double t) {
    const double ring = kKnotRing_mm + kKnotWinding_mm * std::cos(3.0 * t);
    return Vec3(ring * std::cos(2.0 * t), ring * std::sin(2.0 * t), -kKnotWinding_mm * std::sin(3.0 * t));
  };
  double sum = 0.0;
  for (int i = 0; i < 100000; ++i) sum += (at(2e-5 * kPi * (i + 1)) - at(2e-5 * kPi * i)).norm();
  return sum;
}

/// Over a bump, by rings of chord d and area 2 pi d dd (Archimedes): of height^k.
double bumpIntegral(int k) {
  return std::pow(kBumpHeight_mm, k) * kPi * kBumpRadius_mm * kBumpRadius_mm / (2.0 * k + 1.0);
}

void expectWhole(const Triangles& triangles, int faces, int euler) {
  const test::MeshFacts facts = test::factsOf(triangles);
  EXPECT_TRUE(facts.is_closed);
  EXPECT_EQ(facts.euler, euler);
  EXPECT_GT(facts.flattest, 0.05);  // no face without area, and none that is nearly so
  EXPECT_NEAR(static_cast<double>(triangles.faces.size()), faces, 0.1 * faces);
}

TEST(TorusKnot, IsAClosedTubeOfItsLength) {
  const double whole = kPi * kKnotTube_mm * kKnotTube_mm * knotLength();  // Pappus
  for (const int faces : kSizes) {
    const Triangles knot = torusKnot(faces);
    expectWhole(knot, faces, 0);
    // A polygon with edges h in a circle loses h^2 / 6 r^2 of it; the curve's own chords less than half as much again.
    const double h2 = 2.0 * 2.0 * kPi * kKnotTube_mm * knotLength() / faces;
    const double lost = whole - test::factsOf(knot).volume;
    EXPECT_LT(std::abs(lost), whole * h2 / (4.0 * kKnotTube_mm * kKnotTube_mm));
  }
  double farthest = 0.0;  // from z
  for (const Eigen::Vector3f& p_MV : torusKnot(300000).p_MV) {
    farthest = std::max(farthest, static_cast<double>(p_MV.head<2>().norm()));
  }
  EXPECT_NEAR(farthest, 45.0, 0.01);  // three places of the tube reach it, and one of its corners is within 0.35 mm
}

TEST(BumpySphere, IsAClosedBallWithItsBumps) {
  // The integral of r^3 / 3 over all directions, r = R + bump; the bumps do not meet.
  const double R = kBall_mm;
  const double whole =
      4.0 / 3.0 * kPi * R * R * R + kBumps * (bumpIntegral(1) + bumpIntegral(2) / R + bumpIntegral(3) / (3.0 * R * R));
  for (const int faces : kSizes) {
    const Triangles ball = bumpySphere(faces);
    expectWhole(ball, faces, 2);
    // Even triangles of edge a, a^2 = 4 / sqrt(3) of their area, lie a^2 / 8 R under the ball in the mean: 11 / faces
    // of its volume; twice that for uneven ones and for the bumps.
    EXPECT_NEAR(test::factsOf(ball).volume, whole, whole * 25.0 / faces);
  }
  EXPECT_NEAR(girthOf(bumpySphere(20000), 2), 2.0 * (kBall_mm + kBumpHeight_mm), kBumpHeight_mm);
}

TEST(Bracket, HasTwoHolesAndItsVolume) {
  const double holes = 8.0 * kPi * (7.0 * 7.0 + 4.5 * 4.5);
  const double whole = 90.0 * 60.0 * 8.0 + 8.0 * 60.0 * 42.0 + 0.5 * 36.0 * 28.0 * 8.0 - holes;
  for (const int faces : kSizes) {
    const Triangles made = bracket(faces);
    expectWhole(made, faces, -2);
    // Flat but for the holes, whose polygons have steps of cell / 7 rad and less: they lose the step's square / 6.
    const double step2 = 2.0 * (2.0 * 19500.0 / faces) / 49.0;
    const double over = test::factsOf(made).volume - whole;
    EXPECT_GT(over, 0.0);
    EXPECT_LT(over, holes * step2 / 6.0);
  }
  const Triangles made = bracket(20000);
  EXPECT_EQ(girthOf(made, 0), 90.0);
  EXPECT_EQ(girthOf(made, 1), 60.0);
  EXPECT_EQ(girthOf(made, 2), 50.0);
}

TEST(Solids, AreClosedAndOfTheirVolume) {
  // Sums of 20000 products of floats: 1e-10 is far above their rounding.
  const Triangles a_plate = plate(1.0, 20000), a_cube = cube(20000), a_wedge = wedge(20000);
  for (const Triangles* one : {&a_plate, &a_cube, &a_wedge}) expectWhole(*one, 20000, 2);
  EXPECT_NEAR(test::factsOf(a_plate).volume, 80.0 * 60.0, 1e-6);
  EXPECT_NEAR(test::factsOf(a_cube).volume, 60.0 * 60.0 * 60.0, 1e-5);
  // The groove's points lie on its slope within a float's rounding of 20 mm: 1e-6 mm on some 4000 mm^2.
  EXPECT_NEAR(test::factsOf(a_wedge).volume, (80.0 * 40.0 - 0.5 * 40.0 * 30.0) * 60.0, 4e-3);
}

TEST(MadeMeshes, DoNotCrossThemselves) {
  const int faces = test::sweep(1000, 8000);
  for (const auto& make : {torusKnot, bumpySphere, bracket, cube, wedge}) EXPECT_EQ(test::crossings(make(faces)), 0);
}

TEST(MadeMeshes, ThatDoCrossThemselvesAreSeenToDoSo) {
  Triangles two = cube(300);
  const Triangles other = bumpySphere(300);  // its crests stand out of the cube's sides
  const auto first = static_cast<std::int32_t>(two.p_MV.size());
  two.p_MV.insert(two.p_MV.end(), other.p_MV.begin(), other.p_MV.end());
  for (const mesh::Face& face : other.faces) two.faces.push_back({face[0] + first, face[1] + first, face[2] + first});
  EXPECT_GT(test::crossings(two), 20);
}

TEST(MadeMeshes, GoUpToTheLargestOfTheBenchmarks) {
  expectWhole(torusKnot(1310720), 1310720, 0);
  expectWhole(bumpySphere(1310720), 1310720, 2);
  expectWhole(bracket(1310720), 1310720, -2);
}

std::string bytesOf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(MadeMeshes, HaveTheSameBytesInAnotherRun) {  // the files come from a run of underact-make-meshes
  const struct {
    const char* suffix;
    int faces;
  } sizes[] = {{"1k", 1000}, {"20k", 20000}, {"300k", 300000}};
  for (const auto& size : sizes) {
    const auto same = [&](const std::string& name, const std::string& bytes) {
      for (const char* folder : {UNDERACT_BINARY "/meshes/", UNDERACT_SOURCE "/scenes/meshes/"}) {
        EXPECT_TRUE(bytesOf(folder + name) == bytes) << folder << name;
      }
    };
    same(std::string("torus_knot_") + size.suffix + ".stl", asStl(torusKnot(size.faces)));
    same(std::string("bumpy_sphere_") + size.suffix + ".ply", asPly(bumpySphere(size.faces)));
    same(std::string("bracket_") + size.suffix + ".obj", asObj(bracket(size.faces)));
  }
}

// One triangle, byte for byte, as the formats say.
const Triangles kOne{{{1, 0, 0}, {0, 2, 0}, {0, 0, -0.5F}}, {{0, 1, 2}}};

TEST(Files, StlHoldsAHeaderACountAndFacesOf50Bytes) {
  const std::string stl = asStl(kOne);
  ASSERT_EQ(stl.size(), 84U + 50U);
  EXPECT_NE(stl.substr(0, 5), "solid");
  EXPECT_EQ(stl.substr(80, 4), std::string("\1\0\0\0", 4));
  EXPECT_EQ(stl.substr(96, 12), std::string("\0\0\x80\x3f\0\0\0\0\0\0\0\0", 12));  // (1, 0, 0), after the normal
  EXPECT_EQ(stl.substr(108, 12), std::string("\0\0\0\0\0\0\0\x40\0\0\0\0", 12));   // (0, 2, 0)
  EXPECT_EQ(stl.substr(120, 12), std::string("\0\0\0\0\0\0\0\0\0\0\0\xbf", 12));   // (0, 0, -0.5)
}

TEST(Files, PlyHoldsItsCountsThenItsNumbers) {
  const std::string ply = asPly(kOne);
  EXPECT_NE(ply.find("format binary_little_endian 1.0\n"), std::string::npos);
  EXPECT_NE(ply.find("element vertex 3\n"), std::string::npos);
  EXPECT_NE(ply.find("element face 1\n"), std::string::npos);
  const std::size_t body = ply.find("end_header\n") + 11;
  ASSERT_EQ(ply.size(), body + 3U * 12U + 13U);
  EXPECT_EQ(ply.substr(body, 4), std::string("\0\0\x80\x3f", 4));
  EXPECT_EQ(ply.substr(body + 36), std::string("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13));
}

TEST(Files, ObjHoldsLinesAndCountsFromOne) {
  EXPECT_EQ(asObj(kOne).substr(asObj(kOne).find('\n') + 1), "v 1 0 0\nv 0 2 0\nv 0 0 -0.5\nf 1 2 3\n");
}

}  // namespace
}  // namespace underact::mesh_maker
