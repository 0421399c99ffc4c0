#include "core/identify/plan.h"

#include <array>
#include <cmath>

#include "core/arm/inverse.h"
#include "core/arm/preset.h"
#include "core/base/translate.h"
#include "core/base/units.h"
#include "core/json/json.h"
#include "core/json/text.h"
#include "core/scene/scene_arm.h"

namespace underact::identify {
namespace {

// Large swings for damping, which depends on speed, small ones for friction, which does not; both ways. All differ:
// where a swing is repeated, the tip meets the same encoder steps again, and their errors are no more independent.
constexpr std::array<double, 12> kSwings_mm{10.0, -9.8, 9.3, -6.2, 5.9, -10.0, 9.6, -9.1, 8.8, -5.6, 6.5, -9.4};
constexpr double kSwing_s = 0.4;  // longer than 0.3 kg takes for 20 mm under 0.3 N net, 0.2 s
constexpr double kArrive_s = 2.0, kSettle_s = 0.6, kRest_s = 1.2;
constexpr double kPress_s = 9.0, kTurn_s = 4.0, kGrip_s = 1.0;
constexpr double kReach_m = 0.02;  // about a position: the swings, and as much again for overshoot
// On the way to a swing: the damping, N s/mm. At 20 g and 1 kHz b T / m is 0.05, far from 1. During the swing there is
// none across it either: friction is enough there, and the noise of the velocity would shake the tip across and take
// from the friction along (half a deviation of mass, friction and damping).
constexpr double kCalm_N_s_per_mm = 1e-3, kAcross_N_per_mm = 0.2;

scene::Description held(const Wanted& wanted, const Vec3& p_W, const Vec3& kp_N_per_mm, const Vec3& kd_N_s_per_mm) {
  scene::Description scene = scene::withArmOf(wanted.arm_of, {});
  scene.title = "Measure the arm";
  scene.control.law = scene::LawType::PD;
  scene.control.gains.kp_N_per_mm = kp_N_per_mm;
  scene.control.gains.kd_N_s_per_mm = kd_N_s_per_mm;
  scene.constraints.push_back({"place", scene::Point{kMillimetrePerMetre * p_W}, target::Side::Both, {}, {}});
  return scene;
}

class Maker {
 public:
  explicit Maker(const Wanted& wanted) : wanted_(wanted) { plan_.places_W = wanted.places_W; }
  void addSwings(std::size_t place, int axis) {
    const Vec3 p_W = wanted_.places_W[place], along_W = Vec3::Unit(axis);
    const Vec3 kp = kAcross_N_per_mm * Vec3::Ones() + (kSwing_N_per_mm - kAcross_N_per_mm) * along_W;
    const Vec3 calm = Vec3::Constant(kCalm_N_s_per_mm);
    add({StageKind::Settle, HandTask::LetsGo, axis, place, axis == 0 ? kArrive_s : kSettle_s,
         held(wanted_, p_W, kp, calm), true});
    for (const double swing_mm : kSwings_mm)
      add({StageKind::Swing, HandTask::LetsGo, axis, place, kSwing_s,
           held(wanted_, p_W + kMetrePerMillimetre * swing_mm * along_W, kp, Vec3::Zero())});
  }
  void addRest(std::size_t place) {
    const Vec3 kp = Vec3::Constant(kSwing_N_per_mm), calm = Vec3::Constant(kCalm_N_s_per_mm);
    add({StageKind::Settle, HandTask::LetsGo, 0, place, kSettle_s, held(wanted_, wanted_.places_W[place], kp, calm),
         true});
    add({StageKind::Rest, HandTask::LetsGo, 0, place, kRest_s, plan_.stages.back().scene});
  }
  void addHandWork() {
    scene::Description scene = held(wanted_, wanted_.places_W[0], Vec3::Constant(kPress_N_per_mm), Vec3::Zero());
    scene.control.law = scene::LawType::P;
    add({StageKind::Settle, HandTask::Presses, 0, 0, kGrip_s, scene, true});
    add({StageKind::Press, HandTask::Presses, 0, 0, kPress_s, scene});
    add({StageKind::Turn, HandTask::Turns, 0, 0, kTurn_s, scene, true});
  }
  Plan take() { return std::move(plan_); }

 private:
  void add(Stage stage) { plan_.stages.push_back(std::move(stage)); }
  const Wanted& wanted_;
  Plan plan_;
};

bool isReached(const arm::Preset& arm, const Vec3& p_WT) {
  const arm::PositionSolution reach = arm::solvePosition(arm.geometry, p_WT);
  const arm::JointAngles held_rad = arm::withinLimits(arm.limits, reach.q_rad);
  return reach.reachable && std::equal(held_rad.begin(), held_rad.begin() + 3, reach.q_rad.begin());
}

}  // namespace

double Plan::seconds() const {
  double sum = 0.0;
  for (const Stage& stage : stages) sum += stage.seconds;
  return sum;
}

Result<Plan> makePlan(const Wanted& wanted) {
  const arm::Preset* const arm = scene::findArm(wanted.arm_of);
  if (arm == nullptr)
    return Problems{{phrase(TRANSLATE_NOOP("problem", "There is no arm %1."), {json::shown(wanted.arm_of.arm)})}};
  if (wanted.places_W.empty() || wanted.places_W.size() > 3)
    return Problems{{phrase(TRANSLATE_NOOP("problem", "State one to three positions."))}};
  Problems problems;
  for (const Vec3& p_W : wanted.places_W) {
    bool reached = p_W.allFinite() && isReached(*arm, p_W);
    for (int axis = 0; axis < 3 && reached; ++axis)
      reached =
          isReached(*arm, p_W + kReach_m * Vec3::Unit(axis)) && isReached(*arm, p_W - kReach_m * Vec3::Unit(axis));
    if (reached) continue;
    const Vec3 p_mm = kMillimetrePerMetre * p_W;
    problems.push_back({phrase(TRANSLATE_NOOP("problem",
                                              "Around (%1, %2, %3) mm the arm cannot move 20 mm in every direction. "
                                              "Choose a position nearer to the middle of the workspace."),
                               {json::numberText(p_mm.x()), json::numberText(p_mm.y()), json::numberText(p_mm.z())})});
  }
  if (!problems.empty()) return problems;
  Maker maker(wanted);
  for (std::size_t place = 0; place < wanted.places_W.size(); ++place) {
    for (int axis = 0; axis < 3; ++axis) maker.addSwings(place, axis);
    maker.addRest(place);
  }
  maker.addHandWork();
  return maker.take();
}

}  // namespace underact::identify
