
#include "core/curve/along.h"
#include "core/scene/compile.h"
#include "core/scene/edit.h"
#include "core/scene/mesh_notes.h"
#include "core/scene/read.h"
#include "core/scene/write.h"
#include "tests/core/scene/scene_support.h"

namespace underact::scene {
namespace {

using test::problemsIn;
using test::sceneWith;

std::string firstProblemOf(const std::string& constraint) {
  const std::vector<std::string> lines = problemsIn(sceneWith(constraint));
  return lines.empty() ? "" : lines.front();
}

Description sceneOf(const std::string& constraint) {
  return readScene(sceneWith(constraint), "").value();
}

/// A tetrahedron; without its last face it is open.
std::shared_ptr<const mesh::Surface> tetrahedron(bool is_closed) {
  mesh::Triangles triangles;
  triangles.p_MV = {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {0, 0, 10}};
  triangles.faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  if (!is_closed) triangles.faces.pop_back();
  return mesh::makeSurface(std::move(triangles)).value();
}

constexpr const char* kMesh =
    R"({"type": "mesh", "file": "a.stl", "scale_mm_per_unit": 25.4, "X_WM": [[0, -1, 0, 1], [1, 0, 0, 2], [0, 0, 1, 3],
        [0, 0, 0, 1]], "search": "local", "smooth_deg": 25.5, "friction": {"static": 0.4, "dynamic": 0.25}})";

TEST(MeshScene, IsReadWholeAndWrittenBack) {
  const Description scene = sceneOf(kMesh);
  const Constraint& constraint = scene.constraints.at(0);
  const Mesh& mesh = std::get<Mesh>(constraint.shape);
  EXPECT_EQ(mesh.file, "a.stl");
  EXPECT_EQ(mesh.scale_mm_per_unit, 25.4);
  EXPECT_EQ(mesh.X_WM(0, 1), -1.0);
  EXPECT_EQ(mesh.X_WM(2, 3), 3.0);
  EXPECT_EQ(mesh.search, mesh::Search::Local);
  EXPECT_EQ(mesh.smooth_deg, 25.5);
  EXPECT_EQ(constraint.friction->static_share, 0.4);
  EXPECT_EQ(constraint.friction->dynamic_share, 0.25);
  const Result<Description> again = readScene(writeScene(scene), "");
  ASSERT_TRUE(again);
  EXPECT_TRUE(isSame(scene, again.value())) << writeScene(scene);
}

TEST(SceneNotes, ARotationOfFourDecimalsIsTakenAndNoted) {
  const auto box = [](const std::string& h) {
    return sceneOf(R"({"type": "box", "center_mm": [0, 0, 0], "size_mm": [1, 1, 1], "R_WB": [[)" + h + ", -" + h +
                   ", 0], [" + h + ", " + h + ", 0], [0, 0, 1]]}");
  };
  EXPECT_TRUE(meshNotes(box("0.70710678")).empty());
  const Problems notes = meshNotes(box("0.7071"));
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes[0].sentence.find("6.8e-06 off a rotation"), std::string::npos) << notes[0].sentence;
  EXPECT_EQ(notes[0].place.line, 2);
}

TEST(MeshScene, TakesTheDefaultOfEachAbsentKey) {
  const Constraint constraint =
      sceneOf(R"({"type": "mesh", "file": "a.stl", "friction": {"static": 0.4}})").constraints.at(0);
  const Mesh& mesh = std::get<Mesh>(constraint.shape);
  EXPECT_EQ(mesh.scale_mm_per_unit, 1.0);
  EXPECT_TRUE(mesh.X_WM.isIdentity(0.0));
  EXPECT_EQ(mesh.search, mesh::Search::Hybrid);
  EXPECT_EQ(mesh.smooth_deg, 0.0);
  EXPECT_EQ(constraint.friction->dynamic_share, 0.4);
}

TEST(MeshScene, NamesEachInvalidKeyWithItsPlace) {
  EXPECT_NE(firstProblemOf(R"({"type": "mesh"})").find("The key \"file\" is missing; a mesh needs it."),
            std::string::npos);
  EXPECT_NE(firstProblemOf(R"({"type": "mesh", "file": ""})").find("A mesh needs the name of its file."),
            std::string::npos);
  for (const char* wrong : {"0", "1e-10", "-1e-10", "2e9", "-2e9"}) {
    const std::string text = R"({"type": "mesh", "file": "a", "scale_mm_per_unit": )" + std::string(wrong) + "}";
    EXPECT_NE(firstProblemOf(text).find("This must be from 1e-9 to 1e9 mm"), std::string::npos) << wrong;
  }
  EXPECT_EQ(firstProblemOf(R"({"type": "mesh", "file": "a", "scale_mm_per_unit": -25.4})"), "");
  EXPECT_NE(firstProblemOf(
                R"({"type": "mesh", "file": "a", "X_WM": [[2, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]})")
                .find("is not a rotation matrix"),
            std::string::npos);
  EXPECT_NE(firstProblemOf(R"({"type": "mesh", "file": "a", "side": "outside", "search": "local"})")
                .find("A wall's proxy follows the surface"),
            std::string::npos);
  for (const char* wrong : {"-1", "45.5"}) {
    EXPECT_NE(firstProblemOf(R"({"type": "mesh", "file": "a", "smooth_deg": )" + std::string(wrong) + "}")
                  .find("This must be from 0 (faces as they are) to 45 degrees; here it is"),
              std::string::npos);
  }
  EXPECT_NE(
      firstProblemOf(R"({"type": "mesh", "file": "a", "control": {"kp_N_per_mm": [1, 2, 1]}})").find("\"euclidean\""),
      std::string::npos);
  EXPECT_EQ(firstProblemOf(
                R"({"type": "mesh", "file": "a", "control": {"kp_N_per_mm": [1, 2, 1], "anisotropy": "euclidean"}})"),
            "");
  EXPECT_NE(firstProblemOf(R"({"type": "point", "position_mm": [0, 0, 0], "friction": {"static": 1}})")
                .find("Nothing can slide along"),
            std::string::npos);
  EXPECT_NE(
      firstProblemOf(R"({"type": "line", "point_mm": [0, 0, 0], "direction": [0, 0, 1], "friction": {"static": 6}})")
          .find("This must be from 0 (smooth) to 5"),
      std::string::npos);
  EXPECT_NE(
      firstProblemOf(
          R"({"type": "line", "point_mm": [0, 0, 0], "direction": [0, 0, 1], "friction": {"static": 0.1, "dynamic": 0.2}})")
          .find("from 0 to the static friction, 0.1"),
      std::string::npos);
  EXPECT_NE(firstProblemOf(R"({"type": "plane", "point_mm": [0, 0, 0], "normal": [0, 0, 1], "search": "local"})")
                .find("computed by a formula"),
            std::string::npos);
}

TEST(MeshScene, CompilesOnlyWithItsSurfaceAndAWallOnlyWithAClosedOne) {
  Description scene = sceneOf(R"({"type": "mesh", "file": "a.stl", "scale_mm_per_unit": 2, "side": "outside",
      "smooth_deg": 30})");
  const auto problem = [&] { return compile(scene).problems().at(0).sentence; };
  Mesh& mesh = std::get<Mesh>(scene.constraints.at(0).shape);
  ASSERT_FALSE(compile(scene));
  EXPECT_EQ(problem(), "The mesh \"a.stl\" is not loaded.");
  mesh.surface = tetrahedron(false);
  ASSERT_FALSE(compile(scene));
  EXPECT_NE(problem().find("has no inside and no outside"), std::string::npos);
  mesh.surface = tetrahedron(true);
  const Result<tick::TickProgram> program = compile(scene);
  ASSERT_TRUE(program);
  EXPECT_TRUE(program.value().needs.meshes);
  const auto& place = std::get<target::MeshPlace>(program.value().entries.at(0).constraint.goal);
  EXPECT_EQ(place.scale_m, 0.002);
  EXPECT_NEAR(place.lean.sin, 0.5, 1e-15);
}

TEST(MeshScene, AnotherFileIsAnotherSceneAnotherPlaceIsNot) {
  Description scene = sceneOf(R"({"type": "mesh", "file": "a.stl"})");
  std::get<Mesh>(scene.constraints.at(0).shape).surface = tetrahedron(true);
  Description moved = scene, other = scene;
  std::get<Mesh>(moved.constraints.at(0).shape).X_WM(0, 3) = 1.0;
  std::get<Mesh>(other.constraints.at(0).shape).surface = tetrahedron(true);
  EXPECT_EQ(changeBetween(scene, moved), Change::Targets);
  EXPECT_EQ(changeBetween(scene, other), Change::Scene);
}

TEST(CurveScene, IsReadWholeAndWrittenBack) {
  const Description scene = sceneOf(
      R"({"type": "curve", "file": "a.txt", "scale_mm_per_unit": 2, "kind": "polyline", "closed": true, "search": "global",
          "guide": {"speed_mm_per_s": -30, "t": 0.25, "lead_mm": 5}, "friction": {"static": 0.2}})");
  const Curve& curve = std::get<Curve>(scene.constraints.at(0).shape);
  EXPECT_EQ(curve.kind, curve::CurveKind::Polyline);
  EXPECT_TRUE(curve.closed);
  EXPECT_EQ(curve.search, Search::Global);
  EXPECT_EQ(curve.guide->speed_mm_per_s, -30.0);
  EXPECT_EQ(curve.guide->t, 0.25);
  EXPECT_EQ(curve.guide->lead_mm, 5.0);
  const Result<Description> again = readScene(writeScene(scene), "");
  ASSERT_TRUE(again);
  EXPECT_TRUE(isSame(scene, again.value())) << writeScene(scene);
}

TEST(CurveScene, NamesEachInvalidKeyWithItsPlace) {
  const auto guide = [](const std::string& text) {
    return firstProblemOf(R"({"type": "curve", "file": "a", "guide": )" + text + "}");
  };
  EXPECT_NE(firstProblemOf(R"({"type": "curve"})").find("The key \"file\" is missing; a curve needs it."),
            std::string::npos);
  EXPECT_NE(guide("{}").find("\"speed_mm_per_s\" is missing"), std::string::npos);
  EXPECT_NE(guide(R"({"speed_mm_per_s": 2001})").find("from -2000 to 2000 mm/s"), std::string::npos);
  EXPECT_NE(guide(R"({"speed_mm_per_s": 1, "t": 2})").find("from 0 (guide only)"), std::string::npos);
  EXPECT_NE(guide(R"({"speed_mm_per_s": 1, "lead_mm": 0})").find("above 0 and at most 1000 mm"), std::string::npos);
  EXPECT_NE(firstProblemOf(R"({"type": "curve", "file": "a", "closed": 1})").find("true or false"), std::string::npos);
  EXPECT_NE(firstProblemOf(R"({"type": "curve", "file": "a", "side": "outside"})").find("has no inside"),
            std::string::npos);
}

TEST(CurveScene, CompilesWhereItsPointsAre) {
  Description scene = sceneOf(
      R"({"type": "curve", "file": "a.txt", "kind": "polyline", "scale_mm_per_unit": 10,
          "X_WM": [[0, -1, 0, 1], [1, 0, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1]]})");
  EXPECT_EQ(compile(scene).problems().at(0).sentence, "The curve \"a.txt\" is not loaded.");
  Curve& curve = std::get<Curve>(scene.constraints.at(0).shape);
  curve.points = std::make_shared<const std::vector<Vec3>>(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}});
  const Result<tick::TickProgram> program = compile(scene);
  ASSERT_TRUE(program);
  EXPECT_TRUE(program.value().needs.curves);
  const curve::Curve& made = *std::get<target::CurvePath>(program.value().entries.at(0).constraint.goal).curve;
  EXPECT_NEAR((pointAt(made, 0.004) - Vec3(0.001, 0.006, 0.003)).norm(), 0.0, 1e-15);  // 4 mm along y
}

TEST(CurveScene, AnEditThatMovesNothingKeepsTheCurve) {
  Description scene = sceneOf(R"({"type": "curve", "file": "a.txt", "guide": {"speed_mm_per_s": 30}})");
  Curve& curve = std::get<Curve>(scene.constraints.at(0).shape);
  curve.points = std::make_shared<const std::vector<Vec3>>(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 2, 0}});
  const auto made = [&scene] {
    return std::get<target::CurvePath>(compile(scene).value().entries.at(0).constraint.goal).curve;
  };
  const std::shared_ptr<const curve::Curve> first = made();
  scene.control.gains.kp_N_per_mm = Vec3::Constant(0.125);
  curve.guide->speed_mm_per_s = -50.0;
  curve.search = Search::Local;
  EXPECT_EQ(made(), first);
  const Curve before = curve;
  const auto changed = [&](auto change) {
    curve = before;
    change();
    return made() != first;
  };
  EXPECT_TRUE(changed([&] { curve.kind = curve::CurveKind::Polyline; }));
  EXPECT_TRUE(changed([&] { curve.closed = true; }));
  EXPECT_TRUE(changed([&] { curve.scale_mm_per_unit = 2.0; }));
  EXPECT_TRUE(changed([&] { curve.X_WM(2, 3) = 1e-9; }));
  EXPECT_TRUE(changed([&] { curve.points = std::make_shared<const std::vector<Vec3>>(*curve.points); }));
  EXPECT_FALSE(changed([] {}));
}

TEST(CurveScene, ACurveThatNobodyHoldsIsLetGo) {
  Curve curve;
  curve.points = std::make_shared<const std::vector<Vec3>>(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}});
  const std::weak_ptr<const curve::Curve> first = makeCurvePath(curve).value().curve;
  EXPECT_TRUE(first.expired());
}

}  // namespace
}  // namespace underact::scene
