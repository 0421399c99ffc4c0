// Scenes are the same where their files would be: the text is the oracle, which edits do not write.
#include "core/scene/edit.h"
#include "core/scene/write.h"
#include "tests/core/scene/scene_support.h"

namespace underact::scene {
namespace {

/// As its file would have it, each constraint with a control of its own.
std::string textOf(Description scene) {
  for (std::size_t index = 0; index < scene.constraints.size(); ++index)
    scene.constraints[index].control = controlOf(scene, index);
  scene.control = Control{};
  return writeScene(scene);
}

/// Scenes that differ from one in a single number, word or part of its first constraint, or of the scene.
std::vector<Description> othersThan(const Description& scene) {
  std::vector<Description> others;
  const auto with = [&](const auto& change) {
    Description other = scene;
    change(other, other.constraints.front());
    others.push_back(std::move(other));
  };
  with([](Description& one, Constraint&) { one.title += "!"; });
  with([](Description& one, Constraint&) { one.about += "!"; });
  with([](Description& one, Constraint&) { one.arm = "touch"; });
  with([](Description& one, Constraint&) { one.combine = tick::Combine::Nearest; });
  with([](Description& one, Constraint&) { one.simulation.substep_us += 1.0; });
  with([](Description&, Constraint& first) { first.name += "!"; });
  with([](Description&, Constraint& first) { first.side = target::Side::Inside; });
  with([](Description&, Constraint& first) { first.influence = Influence{0.125}; });
  with([](Description&, Constraint& first) { first.friction = Friction{0.25, 0.125}; });
  with([](Description&, Constraint& first) { first.shape = Sphere{Vec3(1, 2, 3), 4}; });
  with([](Description& one, Constraint&) { one.constraints.pop_back(); });
  with([](Description& one, Constraint&) { one.file += "!"; });
  with([](Description& one, Constraint& first) { first.control = one.control; });
  for (const int change : {0, 1, 2, 3, 4, 5, 6, 7}) {
    Control control = controlOf(scene, 0);
    if (change == 0) control.law = LawType::PID;
    if (change == 1) control.gains.kp_N_per_mm.y() += 0.125;
    if (change == 2) control.gains.kd_N_s_per_mm.x() += 0.125;
    if (change == 3) control.gains.ki_N_per_mm_s.z() += 0.125;
    if (change == 4) control.anisotropy = Anisotropy::Euclidean;
    if (change == 5) control.space = tick::Space::Joint;
    if (change == 6) control.velocity = LowPassFilter{7.0};
    if (change == 7) control.passivity = control::Passivity::Off;
    others.push_back(withControl(scene, 0, control));
  }
  const auto with_shape = [&](auto shape, const auto& change) {
    change(shape);
    others.push_back(withShape(scene, 0, shape));
  };
  const Shape& shape = scene.constraints.front().shape;
  if (const auto* const robot = std::get_if<VirtualManipulator>(&shape)) {
    with_shape(*robot, [](VirtualManipulator& one) { one.joints.front().rest += 0.5; });
    with_shape(*robot, [](VirtualManipulator& one) { one.joints.front().min = -3.0; });
    with_shape(*robot, [](VirtualManipulator& one) { one.X_WV_home(0, 3) += 1.0; });
    with_shape(*robot, [](VirtualManipulator& one) { one.ko_N_mm_per_rad += 1.0; });
    with_shape(*robot, [](VirtualManipulator& one) { one.solver.max_steps += 1; });
    with_shape(*robot, [](VirtualManipulator& one) { one.force_law = manipulator::ForceLaw::Thesis52; });
  }
  if (const auto* const mesh = std::get_if<Mesh>(&shape)) {
    with_shape(*mesh, [](Mesh& one) { one.file += "!"; });
    with_shape(*mesh, [](Mesh& one) { one.scale_mm_per_unit *= 2.0; });
    with_shape(*mesh, [](Mesh& one) { one.X_WM(1, 3) += 1.0; });
    with_shape(*mesh, [](Mesh& one) { one.smooth_deg += 1.0; });
    with_shape(*mesh, [](Mesh& one) { one.checksum += "0"; });
    with_shape(*mesh, [](Mesh& one) { one.loaded_checksum += "0"; });
  }
  if (const auto* const curve = std::get_if<Curve>(&shape)) {
    with_shape(*curve, [](Curve& one) { one.kind = curve::CurveKind::Polyline; });
    with_shape(*curve, [](Curve& one) { one.closed = !one.closed; });
    with_shape(*curve, [](Curve& one) { one.guide = CurveGuidance{0.5, 20.0, 5.0}; });
    with_shape(*curve, [](Curve& one) { one.X_WM(2, 3) += 1.0; });
  }
  return others;
}

}  // namespace

TEST(Equality, OfScenesIsThatOfWhatTheirFilesWouldSay) {
  std::vector<Description> scenes;
  for (const std::filesystem::path& file : test::sceneFiles()) scenes.push_back(readSceneFile(file.string()).value());
  int same = 0, compared = 0;
  for (const Description& scene : scenes) {
    std::vector<Description> others = othersThan(scene);
    others.insert(others.end(), scenes.begin(), scenes.end());
    const std::string text = textOf(scene);
    for (const Description& other : others) {
      ASSERT_EQ(isSame(scene, other), text == textOf(other)) << text << textOf(other);
      ASSERT_EQ(isSame(other, scene), isSame(scene, other));
      same += isSame(scene, other) ? 1 : 0;
      ++compared;
    }
  }
  EXPECT_GT(same, static_cast<int>(2 * scenes.size()));
  EXPECT_LT(same, compared / 2);
}

}  // namespace underact::scene
