#pragma once
#include <array>
#include <cmath>

#include "core/scene/fields.h"
#include "tests/core/scene/scene_support.h"

namespace underact::test {

/// Scenes that keep every rule, with numbers of all sizes that the rules allow.
class RandomScene {
 public:
  explicit RandomScene(Seed seed) : random_(seed) {}

  scene::Description next() {
    scene::Description made;
    made.title = words();
    if (chance(2)) made.about = words();
    if (chance(3)) made.arm = "touch-measured";
    if (chance(2)) made.control = control();
    if (chance(2)) made.combine = tick::Combine::Nearest;
    if (chance(3))
      made.simulation = {chance(2) ? Integrator::EndVelocity : Integrator::Trapezoidal, random_.between(5.0, 10'000.0)};
    made.constraints.resize(1 + random_.below(chance(20) ? 64 : 4));
    for (std::size_t i = 0; i < made.constraints.size(); ++i) {
      scene::Constraint& constraint = made.constraints[i];
      constraint.shape = shape();
      constraint.name = std::string(scene::typeName(constraint.shape)) + " " + std::to_string(i + 1);
      if (chance(2)) constraint.name = words() + " " + std::to_string(i);  // no two alike: the number is its last word
      if (scene::hasSides(constraint.shape)) constraint.side = static_cast<target::Side>(random_.below(3));
      if (chance(3)) constraint.control = control();
      const scene::Control& held = constraint.control ? *constraint.control : made.control;
      const Vec3& kp = held.gains.kp_N_per_mm;
      if (std::holds_alternative<scene::VirtualManipulator>(constraint.shape)) constraint.control = plainControl();
      const bool own_metric = held.anisotropy == scene::Anisotropy::Weighted && held.space == tick::Space::Cartesian &&
                              !(kp.x() == kp.y() && kp.y() == kp.z());
      if (scene::takesInfluence(constraint.shape) && constraint.side == target::Side::Both && !own_metric &&
          chance(3)) {
        constraint.influence = scene::Influence{random_.between(0.0, 1.0),
                                                chance(2) ? scene::StylusAxis::PlusZ : scene::StylusAxis::MinusZ,
                                                chance(2) ? 5.0 : random_.between(0.0, 30.0)};
      }
    }
    return made;
  }

 private:
  bool chance(std::size_t one_in) { return random_.below(one_in) == 0; }

  std::string words() {
    static const std::array<const char*, 12> kWords{
        "wall",         "a \"quote\"",      "back\\slash", "tab\t", "line\nend", "\x01", "\xC3\xA9t\xC3\xA9",
        "\xE2\x82\xAC", "\xF0\x9F\x98\x80", "/",           "\x7F",  "{}[],:"};
    std::string text = "w";
    for (std::size_t i = random_.below(4); i > 0; --i) text += std::string(" ") + kWords[random_.below(kWords.size())];
    return text;
  }

  double size() { return std::ldexp(random_.between(0.5, 1.0), static_cast<int>(random_.between(-60, 19))); }
  double coordinate() {
    switch (random_.below(5)) {
      case 0:
        return 0.0;
      case 1:
        return -0.0;
      case 2:
        return std::floor(random_.between(-100.0, 100.0));
      case 3:
        return random_.between(-1e6, 1e6);
      default:
        return std::ldexp(random_.between(-1.0, 1.0), static_cast<int>(random_.between(-1070, 19)));
    }
  }
  Vec3 position() { return {coordinate(), coordinate(), coordinate()}; }
  Vec3 direction() {
    const Vec3 d = std::ldexp(1.0, static_cast<int>(random_.between(-900, 900))) * random_.direction();
    return chance(3) ? Vec3(0.0, -0.0, d.z() == 0.0 ? 1.0 : d.z()) : d;
  }
  Mat3 rotation() {
    if (chance(2)) return Mat3::Identity();
    return Eigen::AngleAxisd(random_.between(-3.0, 3.0), random_.direction()).toRotationMatrix();
  }
  void fill(scene::Meaning, double& number) { number = size(); }
  void fill(scene::Meaning, Mat3& number) { number = rotation(); }
  void fill(scene::Meaning meaning, Vec3& number) {
    if (meaning == scene::Meaning::Position)
      number = position();
    else if (meaning == scene::Meaning::Direction)
      number = direction();
    else
      for (double& one : number) one = size();
  }
  scene::Shape shape() {
    std::vector<scene::Shape> all =
        plainShapes([this](scene::Meaning meaning, auto& number) { this->fill(meaning, number); });
    all.emplace_back(robot());
    return all[random_.below(all.size())];
  }
  scene::Joint joint() {
    scene::Joint made;
    if (chance(3)) made.type = chain::JointType::Prismatic;
    made.axis = direction();
    if (made.type == chain::JointType::Revolute) made.point_mm = position();
    if (chance(3)) made.min = -random_.between(0.0, 900.0);
    if (chance(3)) made.max = random_.between(0.0, 900.0);
    if (chance(4)) made.stiffness = random_.between(0.1, 1e3), made.rest = random_.between(-900.0, 900.0);
    return made;
  }
  scene::VirtualManipulator robot() {
    scene::VirtualManipulator made;
    made.joints.resize(1 + random_.below(8));
    for (scene::Joint& one : made.joints) one = joint();
    made.X_WV_home.topLeftCorner<3, 3>() = rotation();
    made.X_WV_home.topRightCorner<3, 1>() = position();
    constexpr std::array kOrientations{manipulator::Orientation::None, manipulator::Orientation::Axis,
                                       manipulator::Orientation::Full};  // an angle needs a chain of its own
    made.orientation = kOrientations[random_.below(kOrientations.size())];
    if (made.orientation != manipulator::Orientation::None) made.ko_N_mm_per_rad = random_.between(0.0, 1e3);
    if (chance(3)) made.solver = {scene::SolverMethod::Iterative, 1 + static_cast<int>(random_.below(100)), 1e-6};
    return made;
  }
  /// One that a virtual manipulator takes.
  scene::Control plainControl() {
    scene::Control made = control();
    made.space = tick::Space::Cartesian;
    made.anisotropy = scene::Anisotropy::Weighted;
    return made;
  }
  Vec3 gain() {
    if (chance(4)) return Vec3::Constant(chance(2) ? -0.0 : 0.0);
    if (chance(2)) return Vec3::Constant(random_.between(0.0, 2.0));
    return {random_.between(0.01, 2.0), random_.between(0.01, 2.0), random_.between(0.01, 2.0)};
  }
  scene::Velocity velocity() {
    switch (random_.below(4)) {
      case 0:
        return scene::KalmanFilter{random_.between(1e-6, 1.0), random_.between(1e-3, 1e9)};
      case 1:
        return scene::LowPassFilter{chance(3) ? -0.0 : random_.between(0.0, 1e3)};
      case 2:
        return scene::AdaptiveWindowFilter{std::floor(random_.between(1.0, 33.0)), random_.between(0.0, 1e3)};
      default:
        return scene::RawFilter{};
    }
  }
  scene::Control control() {
    scene::Control made;
    made.law = static_cast<scene::LawType>(random_.below(3));
    if (chance(3)) made.anisotropy = scene::Anisotropy::Euclidean;
    if (chance(4)) made.space = tick::Space::Joint;
    if (!chance(4)) made.gains.kp_N_per_mm = gain();
    if (made.law != scene::LawType::P) made.gains.kd_N_s_per_mm = gain();
    if (made.law == scene::LawType::PID) made.gains.ki_N_per_mm_s = gain();
    if (chance(2)) made.velocity = velocity();
    made.passivity = static_cast<control::Passivity>(random_.below(3));
    return made;
  }

  Random random_;
};

}  // namespace underact::test
