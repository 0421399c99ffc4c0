#include "core/scene/mirror.h"

#include "core/arm/arm_text.h"
#include "core/arm/forward.h"
#include "core/base/trig.h"
#include "core/chain/numeric_inverse.h"
#include "core/scene/compile.h"
#include "core/scene/fields.h"
#include "core/scene/load_meshes.h"
#include "core/scene/scene_arm.h"
#include "core/scene/settings.h"
#include "core/scene/write.h"
#include "tests/core/scene/random_scene.h"
#include "tests/support/tick_hand.h"

namespace underact::scene {
namespace {

using test::Random;
using test::same;

const Vec3 kMirror{-1.0, 1.0, 1.0};
const Vec3 kTip{1.0, -1.0, 1.0};

Vec3 seen(const Vec3& v) {
  return kMirror.cwiseProduct(v);
}

/// The joints of the arm in the mirror.
arm::JointAngles seen(const arm::JointAngles& q_rad) {
  return {-q_rad[0], q_rad[1], q_rad[2], -q_rad[3], q_rad[4], -q_rad[5]};
}

Description shippedFrom(const std::filesystem::path& file) {
  Description scene = readSceneFile(file.string()).value();
  EXPECT_TRUE(loadMeshes(scene).empty()) << file;
  return scene;
}

/// A smooth motion through the middle of the workspace, each way with a pace and a beginning of its own.
class Sway {
 public:
  explicit Sway(test::Seed seed) {
    Random random(seed);
    for (std::size_t part = 0; part < 6; ++part) {
      pace_[part] = random.between(0.7, 3.0);
      begin_[part] = random.between(0.0, 6.28);
    }
  }
  arm::JointAngles at(const arm::Geometry& geometry, int tick) const {
    const auto swing = [&](std::size_t part) { return sinCos(begin_[part] + 1e-3 * tick * pace_[part]).sin; };
    arm::JointAngles q_rad = arm::solvePosition(geometry, 0.04 * Vec3(swing(0), swing(1), swing(2))).q_rad;
    q_rad[3] = swing(3), q_rad[4] = 1.5 + 0.6 * swing(4), q_rad[5] = 0.7 * swing(5);
    return q_rad;
  }

 private:
  arm::JointAngles pace_{}, begin_{};
};

TEST(Mirror, TheArmWithJoints146TheOtherWayIsTheArmInTheMirror) {
  Random random(test::Seed{20261123});
  for (const arm::Preset& preset : arm::presets()) {
    for (int i = 0; i < test::sweep(2000, 200'000); ++i) {
      arm::JointAngles q_rad{};
      for (double& angle_rad : q_rad) angle_rad = random.between(-3.0, 3.0);
      const Pose X_WT = arm::tipPose(preset.geometry, q_rad), X_WM = arm::tipPose(preset.geometry, seen(q_rad));
      ASSERT_LE((X_WM.translation() - seen(X_WT.translation())).norm(), 1e-12) << preset.name;
      const Mat3 R = kMirror.asDiagonal() * X_WT.linear() * kTip.asDiagonal();
      ASSERT_LE((X_WM.linear() - R).norm(), 1e-12) << preset.name;
    }
  }
}

TEST(Mirror, TwiceIsTheSceneItselfToTheLastBit) {
  for (const std::filesystem::path& file : test::sceneFiles()) {
    const Description scene = readSceneFile(file.string()).value(), once = mirrored(scene), twice = mirrored(once);
    EXPECT_TRUE(same(twice, scene)) << file;
    EXPECT_EQ(writeScene(twice), writeScene(scene)) << file;
    EXPECT_EQ(once.file, scene.file);
  }
  test::RandomScene random(test::Seed{12});
  for (int i = 0; i < test::sweep(500, 50'000); ++i) {
    const Description scene = random.next();
    ASSERT_TRUE(same(mirrored(mirrored(scene)), scene)) << writeScene(scene);
  }
}

TEST(Mirror, AMirroredSceneIsOneThatCanBeWrittenAndReadBack) {
  for (const std::filesystem::path& file : test::sceneFiles()) {
    const Description scene = mirrored(readSceneFile(file.string()).value());
    const std::string text = writeScene(scene);
    const Result<Description> again = readScene(text, file.string());
    ASSERT_TRUE(again) << file << "\n" << test::joined(test::linesOf(again.problems()));
    EXPECT_TRUE(same(again.value(), scene)) << file;
    EXPECT_EQ(text.find("-0,"), std::string::npos) << file;
    EXPECT_EQ(text.find("-0]"), std::string::npos) << file;
  }
}

TEST(Mirror, EachNumberGoesWhereAMirrorPutsIt) {
  const auto shape = [](const std::string& constraint) {
    return mirrored(readScene(test::sceneWith(constraint), "").value()).constraints.at(0).shape;
  };
  const auto plane = std::get<Plane>(shape(R"({"type": "plane", "point_mm": [5, 6, 0], "normal": [1, -2, 3]})"));
  EXPECT_EQ(plane.point_mm, Vec3(-5, 6, 0));
  EXPECT_EQ(plane.normal, Vec3(-1, -2, 3));
  const auto box = std::get<Box>(shape(R"({"type": "box", "center_mm": [1, 2, 3], "size_mm": [4, 5, 6],
      "R_WB": [[0, -1, 0], [1, 0, 0], [0, 0, 1]]})"));
  EXPECT_EQ(box.size_mm, Vec3(4, 5, 6));
  EXPECT_EQ(box.R_WB, (Mat3() << 0, 1, 0, -1, 0, 0, 0, 0, 1).finished());  // turned the other way about z
  const auto robot = std::get<VirtualManipulator>(shape(R"({"type": "virtual_manipulator", "joints": [
      {"type": "revolute", "axis": [0, 0, 1], "point_mm": [10, 20, 30], "min": -0.1, "max": 0.5},
      {"type": "prismatic", "axis": [1, 0, 1], "min": -3, "max": 4}],
      "X_WV_home": [[1, 0, 0, 60], [0, 1, 0, 20], [0, 0, 1, 30], [0, 0, 0, 1]]})"));
  EXPECT_EQ(robot.joints[0].axis, Vec3(0, 0, -1));  // a turn to the left is one to the right, and stays as far
  EXPECT_EQ(robot.joints[0].point_mm, Vec3(-10, 20, 30));
  EXPECT_EQ(robot.joints[0].min, -0.1);
  EXPECT_EQ(robot.joints[0].max, 0.5);
  EXPECT_EQ(robot.joints[1].axis, Vec3(-1, 0, 1));
  EXPECT_EQ(robot.joints[1].max, 4.0);
  EXPECT_EQ(Mat3(robot.X_WV_home.topLeftCorner<3, 3>()), Mat3(Vec3(-1, -1, 1).asDiagonal()));
  EXPECT_EQ(Vec3(robot.X_WV_home.topRightCorner<3, 1>()), Vec3(-60, 20, 30));
  const auto mesh = std::get<Mesh>(shape(R"({"type": "mesh", "file": "a.stl", "scale_mm_per_unit": 2, "checksum": "1",
      "X_WM": [[0, -1, 0, 1], [1, 0, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1]]})"));
  EXPECT_EQ(mesh.scale_mm_per_unit, -2.0);
  EXPECT_EQ(mesh.checksum, "1");
  const Vec3 p_M(7, 8, 9), p_W = mesh.X_WM.topRightCorner<3, 1>() + -2.0 * (mesh.X_WM.topLeftCorner<3, 3>() * p_M);
  EXPECT_EQ(p_W, Vec3(15, 16, 21));  // of [-15, 16, 21] without the mirror
}

TEST(Mirror, WhatWasLoadedStays) {
  Description scene = shippedFrom(std::string(UNDERACT_SOURCE) + "/scenes/27_bracket.json");
  const auto surface = [](const Description& of) { return std::get<Mesh>(of.constraints.at(0).shape).surface; };
  ASSERT_NE(surface(scene), nullptr);
  EXPECT_EQ(surface(mirrored(scene)), surface(scene));
}

/// How far the forces of two runs that mirror each other may be apart, N. Nearly every number of a tick but changes its
/// sign, to the bit. Only an angle that is counted from another direction, and a pose that goes through a quaternion,
/// are rounded elsewhere: by 1e-16 of a reach of 0.2 m times 500 N/m, and a rate makes a thousand times as much of it.
constexpr double kRounding_N = 1e-11;

using Named = std::pair<std::string, Description>;

/// What the shippedFrom scenes leave out: a force that leans, a mesh that is held to, every filter with the passivity
/// controller, unequal gains in their own metric, and what stands askew.
std::vector<Named> variants() {
  const auto scene = [](const char* name) {
    return shippedFrom(std::string(UNDERACT_SOURCE) + "/scenes/" + name + ".json");
  };
  Description leaning = withValue(scene("26_bumpy_sphere"), "/constraints/0/smooth_deg", 40.0).value(),
              held = withValue(scene("27_bracket"), "/constraints/0/smooth_deg", 30.0).value();
  held.constraints[0].side = target::Side::Both;
  std::get<Mesh>(held.constraints[0].shape).search = mesh::Search::Local;
  Description turned = held, box = scene("07_box_outside");
  const Mat3 R = Eigen::Quaterniond(0.8, 0.2, -0.4, 0.4).toRotationMatrix();
  std::get<Mesh>(turned.constraints[0].shape).X_WM.topLeftCorner<3, 3>() = R;
  std::get<Mesh>(turned.constraints[0].shape).X_WM.topRightCorner<3, 1>() = Vec3(10.0, -5.0, 3.0);
  std::get<Box>(box.constraints[0].shape).R_WB = R;
  std::vector<Named> all{{"leaning", leaning}, {"held", held}, {"turned mesh", turned}, {"turned box", box}};
  for (const Velocity& velocity :
       {Velocity(KalmanFilter{}), Velocity(LowPassFilter{}), Velocity(AdaptiveWindowFilter{}), Velocity(RawFilter{})}) {
    Description filtered = scene("10_two_spheres_nearest");
    filtered.control.law = LawType::PID;
    filtered.control.gains = {{0.8, 0.2, 0.4}, Vec3::Constant(0.002), {0.9, 0.3, 0.6}};
    filtered.control.velocity = velocity;
    filtered.control.passivity = control::Passivity::Control;
    all.emplace_back(filterName(velocity), filtered);
  }
  return all;
}

std::vector<Named> everyScene() {
  std::vector<Named> all = variants();
  for (const std::filesystem::path& file : test::sceneFiles())
    all.emplace_back(file.stem().string(), shippedFrom(file));
  return all;
}

TEST(Mirror, EachSceneOnTheMirroredArmPushesWithTheMirrorImageOfItsForce) {
  for (const auto& [name, scene] : everyScene()) {
    const arm::Geometry& geometry = arm::findPreset(scene.arm)->geometry;
    if (!arm::solvesInTick(geometry)) continue;  // below: the mirror image of such an arm is another arm
    double max_N = 0.0;
    for (int draw = 0; draw < test::sweep(3, 40); ++draw) {
      const Sway motion(test::Seed{static_cast<std::uint64_t>(100 + draw)});
      test::Hand right(compile(scene).value()), left(compile(mirrored(scene)).value());
      for (int tick = 0; tick < 2000; ++tick) {
        const arm::JointAngles q_rad = motion.at(geometry, tick);
        const tick::TickReport &r = right.feed(q_rad), &l = left.feed(seen(q_rad));
        const std::string where = name + ", tick " + std::to_string(tick);
        ASSERT_EQ(r.fault.kind, l.fault.kind) << where;
        for (std::size_t index = 0; index < r.held.size(); ++index) {
          ASSERT_EQ(r.held[index].status, l.held[index].status) << where;
          ASSERT_EQ(r.held[index].acts, l.held[index].acts) << where;
        }
        max_N = std::max(max_N, r.f_T_W.norm());
        ASSERT_LE((seen(r.f_T_W) - l.f_T_W).norm(), kRounding_N) << where;
        ASSERT_LE((seen(r.force.f_T_W()) - l.force.f_T_W()).norm(), kRounding_N) << where;
      }
    }
    EXPECT_GT(max_N, 0.01) << name << ": nothing was felt, so nothing is shown";
  }
}

/// Another arm keeps its joints, which bring the tip to the mirrored pose in a way of their own: what it is held to
/// there is the mirror image, at the same distance.
TEST(Mirror, OtherArmsAreHeldToTheMirrorImageAcrossTheirOwnPlane) {
  int arms = 0;
  for (const std::filesystem::path& file : test::sceneFiles()) {
    const Description scene = shippedFrom(file);
    const arm::Preset& preset = armOf(scene);
    if (arm::solvesInTick(preset.geometry)) continue;
    ++arms;
    EXPECT_EQ(mirrorPlaneOf(scene), (arm::MirrorPlane{1, 0.0})) << file << ": they face x, and stand on the origin";
    const chain::Chain& chain = preset.geometry.mechanism->chain;
    const std::size_t joints = chain.joints.size();
    const Vec3 across(1.0, -1.0, 1.0);
    Random random(test::Seed{20261126});
    int reached = 0;
    for (int draw = 0; draw < test::sweep(20, 2000); ++draw) {
      arm::JointAngles q = preset.geometry.mechanism->rest;
      for (std::size_t joint = 0; joint < joints; ++joint) {
        const bool slides = chain.joints[joint].type == chain::JointType::Prismatic;
        q[joint] += random.between(-1.0, 1.0) * (slides ? 0.02 : 0.4);
      }
      const Pose X_WT = chain::forward(chain, q);
      Pose X_WM = X_WT;
      X_WM.translation() = across.cwiseProduct(X_WT.translation());
      X_WM.linear() = across.asDiagonal() * X_WT.linear() * kTip.asDiagonal();
      chain::NumericOptions options;
      options.restarts = 20;
      if (joints < 6) options.rotation_length_m = 0.0;
      const chain::NumericSolution found =
          chain::solveNumerically(chain, X_WM, preset.geometry.mechanism->rest, options);
      if (!found.reached) continue;
      ++reached;
      arm::JointAngles image{};
      std::copy_n(found.q.begin(), joints, image.begin());
      test::Hand right(compile(scene).value()), left(compile(mirrored(scene)).value());
      const tick::TickReport &r = right.feed(q), &l = left.feed(image);
      for (std::size_t index = 0; index < r.held.size(); ++index) {
        ASSERT_EQ(r.held[index].status, l.held[index].status) << file;
        ASSERT_NEAR(r.held[index].distance_m, l.held[index].distance_m, 1e-8) << file;
        ASSERT_LE((across.cwiseProduct(r.held[index].p_WP) - l.held[index].p_WP).norm(), 1e-8) << file;
      }
    }
    EXPECT_GT(reached, 5) << file;
  }
  EXPECT_GE(arms, 10);
}

/// The UR5e with its base elsewhere; rows: of X_WB, mm.
arm::MirrorPlane planeOfUr5eAt(const std::string& rows) {
  std::string text(arm::fileOf("ur5e"));
  const std::size_t key = text.find("\"X_WB\""), from = text.find("[[", key), to = text.find("]]", from);
  text.replace(from, to + 2 - from, rows);
  return arm::mirrorPlane(arm::readArm(text, "moved.json").value());
}

TEST(Mirror, APlaneGoesThroughTheBaseAlongTheWayItFaces) {
  EXPECT_EQ(arm::mirrorPlane(*arm::findModel(arm::kDefaultArm)), arm::MirrorPlane{});
  EXPECT_EQ(planeOfUr5eAt("[[1, 0, 0, 50], [0, 1, 0, 200], [0, 0, 1, 0], [0, 0, 0, 1]]"), (arm::MirrorPlane{1, 0.2}));
  EXPECT_EQ(planeOfUr5eAt("[[0, -1, 0, 50], [1, 0, 0, 200], [0, 0, 1, 0], [0, 0, 0, 1]]"), (arm::MirrorPlane{0, 0.05}))
      << "it faces y";
  EXPECT_EQ(planeOfUr5eAt("[[0, 0, 1, 50], [0, 1, 0, 200], [-1, 0, 0, 0], [0, 0, 0, 1]]"), (arm::MirrorPlane{1, 0.2}))
      << "on a wall: away from it";
  const std::string urdf = arm::textOf(*arm::findModel("ur5e"), arm::ArmForm::Urdf).value();
  const arm::MirrorPlane from_urdf = arm::mirrorPlane(arm::readArmText(urdf, "ur5e.urdf").value());
  EXPECT_EQ(from_urdf, (arm::MirrorPlane{1, 0.0}));
}

TEST(Mirror, AcrossAPlaneBesideTheOriginPositionsMoveAndDirectionsTurn) {
  const Constraint plane =
      readScene(test::sceneWith(R"({"type": "plane", "point_mm": [5, 6, 7], "normal": [1, -2, 3]})"), "")
          .value()
          .constraints.at(0);
  const arm::MirrorPlane mirror{1, 0.2};
  const auto once = std::get<Plane>(mirrored(plane, mirror).shape);
  EXPECT_EQ(once.point_mm, Vec3(5, 394, 7));
  EXPECT_EQ(once.normal, Vec3(1, 2, 3));
  EXPECT_EQ(std::get<Plane>(mirrored(mirrored(plane, mirror), mirror).shape).point_mm, Vec3(5, 6, 7));
}

TEST(Mirror, TwiceIsTheSceneOfAnotherArmToTheLastBit) {
  test::RandomScene random(test::Seed{13});
  for (int i = 0; i < test::sweep(200, 20'000); ++i) {
    Description scene = random.next();
    scene.arm = "ur5e";
    const Description once = mirrored(scene);
    ASSERT_TRUE(same(mirrored(once), scene)) << writeScene(scene);
    ASSERT_EQ(mirrorPlaneOf(once).axis, 1);
  }
}

/// A wall of a mesh that is no mirror image of itself: from inside out, and not the other way round.
TEST(Mirror, TheOutsideOfAMirroredMeshIsOutside) {
  mesh::Triangles corner;
  corner.p_MV = {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {0, 0, 10}};
  corner.faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  Description scene =
      readScene(test::sceneWith(R"({"type": "mesh", "file": "a", "scale_mm_per_unit": 2, "side": "outside"})"), "")
          .value();
  std::get<Mesh>(scene.constraints.at(0).shape).surface = mesh::makeSurface(std::move(corner)).value();
  test::Hand hand(compile(mirrored(scene)).value());
  hand.settle({-0.001, 0.005, 0.005});  // a millimetre inside its face x = 0
  EXPECT_EQ(hand.report().held[0].status, target::Status::Unique);
  EXPECT_NEAR(hand.report().held[0].distance_m, 0.001, 1e-12);
  EXPECT_GT(hand.report().f_T_W.x(), 0.4);
  hand.settle({0.001, 0.005, 0.005});
  EXPECT_EQ(hand.report().held[0].status, target::Status::Free);
}

}  // namespace
}  // namespace underact::scene
