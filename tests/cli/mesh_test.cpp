#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "tests/cli/session.h"
#include "tests/core/mesh_file/some_meshes.h"
#include "tests/support/crossed_bodies.h"

namespace underact::test {
namespace {

using cli::Exit;

class MeshInfo : public testing::Test {
 protected:
  MeshInfo() {
    ::setenv("UNDERACT_MESH_READER", (std::string(UNDERACT_BINARY) + "/underact-mesh-reader").c_str(), 1);
    ::setenv("UNDERACT_CACHE_DIR", (folder_.path() + "/cache").c_str(), 1);
  }
  ~MeshInfo() override { ::setenv("UNDERACT_CACHE_DIR", (std::string(UNDERACT_BINARY) + "/mesh_cache").c_str(), 1); }
  ScratchFolder folder_;
};

TEST_F(MeshInfo, SaysWhatTheMeshIsAndHowItCanBeFelt) {
  const std::string path = folder_.write("cube.stl", stlBinary(turnedOver(cube(20.0F))));
  for (const bool from_cache : {false, true}) {
    const Outcome outcome = runCli({"mesh", "info", path, "--json"});
    ASSERT_EQ(outcome.exit, Exit::Success) << outcome.err;
    const json::Value object = lines(outcome.out).at(0);
    EXPECT_EQ(textAt(object, "format"), "binary STL");
    EXPECT_EQ(vectorAt(object, "size_mm"), Vec3(20, 20, 20));
    EXPECT_EQ(numberAt(object, "faces"), 12);
    EXPECT_EQ(numberAt(object, "corners"), 8);
    EXPECT_EQ(numberAt(object, "turned_faces"), 12);
    EXPECT_NEAR(numberAt(object, "volume_mm3"), 8000.0, 1e-9);
    EXPECT_TRUE(isNullAt(object, "unit_question"));
    EXPECT_NE(outcome.out.find(R"("sides": ["both", "outside", "inside"])"), std::string::npos);
    EXPECT_NE(outcome.out.find(from_cache ? R"("from_cache": true)" : R"("from_cache": false)"), std::string::npos);
  }
}

TEST_F(MeshInfo, AsksForTheUnitWhereTheSizeIsImplausibleAndNoneIsStated) {
  const std::string path = folder_.write("metres.obj", obj(cube(0.12F)));
  const Outcome asked = runCli({"mesh", "info", path});
  EXPECT_NE(asked.out.find("Read as millimetres, the mesh is 0.12 mm long. In metres it would be 120 mm."),
            std::string::npos);
  EXPECT_NE(asked.out.find("\"scale_mm_per_unit\": 1000"), std::string::npos);
  const Outcome stated = runCli({"mesh", "info", path, "--scale_mm_per_unit", "1000"});
  EXPECT_EQ(stated.out.find("as millimetres"), std::string::npos);
  EXPECT_NE(stated.out.find("120 x 120 x 120 mm"), std::string::npos) << stated.out;
}

TEST_F(MeshInfo, AnOpenMeshIsFeltFromBothSidesOnly) {
  const Outcome outcome = runCli({"mesh", "info", folder_.write("sheet.off", off(sheet(10))), "--json"});
  EXPECT_NE(outcome.out.find(R"("sides": ["both"])"), std::string::npos);
  EXPECT_EQ(numberAt(lines(outcome.out).at(0), "borders"), 1);
}

TEST_F(MeshInfo, ADamagedFileIsBadInputAndOneThatIsNotThereAFile) {
  const std::string good = folder_.write("good.ply", plyText(cube(10.0F)));
  const std::string bad = folder_.write("bad.ply", plyText(cube(10.0F)).substr(0, 300));
  const Outcome outcome = runCli({"mesh", "info", bad, good, "--json"});
  EXPECT_EQ(outcome.exit, Exit::BadInput);
  EXPECT_EQ(lines(outcome.out).size(), 1U);
  EXPECT_NE(outcome.err.find("bad.ply: error: The file is damaged: "), std::string::npos) << outcome.err;
  EXPECT_EQ(runCli({"mesh", "info", folder_.path() + "/none.stl", bad}).exit, Exit::File);
  EXPECT_EQ(runCli({"mesh", "info"}).exit, Exit::Usage);
  EXPECT_EQ(runCli({"mesh", "info", good, "--scale_mm_per_unit", "0"}).exit, Exit::Usage);
}

/// One box stands on another, 10 deep in it.
std::string minCase() {
  return stlBinary(soup(together({boxOf({-20, -20, -20}, {20, 20, 0}), boxOf({0, -20, -10}, {20, 20, 20})})));
}

std::string sceneWith(const std::string& keys) {
  return R"({
  "underact_scene": 1, "title": "Two boxes", "control": {"law": "P", "kp_N_per_mm": 0.5},
  "constraints": [{"name": "body", "type": "mesh", "file": "two.stl")" +
         keys + "}]\n}\n";
}

TEST_F(MeshInfo, OfAMeshThatIntersectsItselfSaysWhatIsFelt) {
  const std::string path = folder_.write("two.stl", minCase());
  const json::Value object = lines(runCli({"mesh", "info", path, "--json"}).out).at(0);
  EXPECT_EQ(numberAt(object, "parts"), 2);
  EXPECT_GT(numberAt(object, "crossings"), 0);
  EXPECT_EQ(numberAt(object, "faces_within"), 2);
  const Outcome table = runCli({"mesh", "info", path});
  EXPECT_NE(table.out.find("The mesh consists of 2 separate parts."), std::string::npos) << table.out;
  EXPECT_NE(table.out.find("You feel the surface of the whole body"), std::string::npos) << table.out;
  EXPECT_NE(table.out.find("both, outside, inside"), std::string::npos);
}

TEST_F(MeshInfo, OfAMeshThatIntersectsItselfScenesAndRunsSayTheSame) {
  folder_.write("two.stl", minCase());
  const std::string scene = folder_.write("two.json", sceneWith(R"(, "side": "outside")"));
  const std::string note =
      "two.json:3:19: note: constraints[0]: The mesh \"two.stl\": The mesh consists of 2 separate parts. The surface "
      "intersects itself, at ";
  const Outcome checked = runCli({"scene", "check", scene});
  EXPECT_EQ(checked.exit, Exit::Success);
  EXPECT_NE(checked.err.find(note), std::string::npos) << checked.err;
  EXPECT_EQ(checked.out, "");  // nothing, where there is no problem
  const Outcome ran = runCli({"run", scene, "--hand", "still", "--seconds", "0.1", "--fast"});
  EXPECT_EQ(ran.exit, Exit::Success);
  EXPECT_NE(ran.err.find(note), std::string::npos) << ran.err;
  EXPECT_EQ(lines(ran.out).size(), 1U);
}

TEST_F(MeshInfo, TheTargetDeepInTheSecondOfTwoBoxesIsOnTheSurfaceOfBoth) {
  folder_.write("two.stl", minCase());
  const std::string scene = folder_.write("two.json", sceneWith(R"(, "side": "outside")"));
  const Outcome outcome = runCli({"target", scene}, "{\"p_mm\": [10, 0, 8]}\n{\"p_mm\": [-10, 0, 8]}\n");
  const std::vector<json::Value> answers = lines(outcome.out);
  ASSERT_EQ(answers.size(), 2U) << outcome.err;
  EXPECT_EQ(textAt(answers[0], "status"), "unique");
  const Vec3 q_mm = vectorAt(answers[0], "q_mm");
  EXPECT_NEAR((Vec3(std::abs(q_mm.x() - 10.0), q_mm.y(), q_mm.z()) - Vec3(10, 0, 8)).norm(), 0.0, 1e-3);  // either side
  EXPECT_GT(vectorAt(answers[0], "force_N").norm(), 4.9);
  EXPECT_EQ(textAt(answers[1], "status"), "free");
}

TEST_F(MeshInfo, AMeshThatNoHandFeelsOrNoArmReachesIsNotedInTheScene) {
  folder_.write("two.stl", minCase());
  const auto notes = [&](const std::string& keys) {
    return runCli({"scene", "check", folder_.write("size.json", sceneWith(keys))}).err;
  };
  EXPECT_NE(notes(R"(, "scale_mm_per_unit": 250)").find("It is 10000 mm long, far beyond the arm's reach"),
            std::string::npos);
  EXPECT_NE(notes(R"(, "scale_mm_per_unit": 0.0025)").find("It is 0.1 mm long, too small to be felt"),
            std::string::npos);
  EXPECT_EQ(notes("").find(" mm long"), std::string::npos);
}

}  // namespace
}  // namespace underact::test
