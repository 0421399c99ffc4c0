// The table: one entry for each setting. See CONTRIBUTING, "Adding a setting".
#include "core/scene/settings.h"

#include "core/base/translate.h"
#include "core/base/units.h"
#include "core/scene/setting_builders.h"

namespace underact::scene {
namespace {

using enum KeyPresence;

constexpr double kMaxFriction = 5.0;  // rubber on rubber is about 1.2
constexpr double kFastest_mm_per_s = kMillimetrePerMetre * curve::kFastestGuidance_m_per_s;

/// Whether the constraint can have a side; a side that it must not have counts as well, so that it is shown.
bool partsSpace(const Constraint& constraint) {
  return hasSides(constraint.shape) || constraint.side != target::Side::Both;
}
bool turns(const Joint& joint) {
  return joint.type == chain::JointType::Revolute;
}
bool slides(const Joint& joint) {
  return !turns(joint);
}

/// At most the static coefficient, where that is valid.
Sentence judgeDynamic(const Friction& friction, double number) {
  const double max = friction.static_share;
  if (!(max >= 0.0 && max <= kMaxFriction) || (number >= 0.0 && number <= max)) return {};
  return phrase(TRANSLATE_NOOP("problem", "This must be from 0 to the static friction, %1; here it is %2."),
                {json::numberText(max), json::numberText(number)});
}

/// By default equal to the static coefficient.
constexpr SettingOf<Friction> dynamicShare(Setting setting) {
  SettingOf<Friction> made = row::member<&Friction::dynamic_share>(setting);
  made.default_value = [](const Friction& friction) { return row::valueOf(friction.static_share); };
  return made;
}

// The labels in panels for the words of a choice, in their order.
constexpr const char* kLawShown[] = {TRANSLATE_NOOP("setting", "P, proportional"),
                                     TRANSLATE_NOOP("setting", "PD, with damping"),
                                     TRANSLATE_NOOP("setting", "PID, with integral")};
constexpr const char* kAnisotropyShown[] = {TRANSLATE_NOOP("setting", "least effort (weighted)"),
                                            TRANSLATE_NOOP("setting", "least distance (euclidean)")};
constexpr const char* kPassivityShown[] = {TRANSLATE_NOOP("setting", "observe"), TRANSLATE_NOOP("setting", "off"),
                                           TRANSLATE_NOOP("setting", "control")};
constexpr const char* kSpaceShown[] = {TRANSLATE_NOOP("setting", "Cartesian (tip)"),
                                       TRANSLATE_NOOP("setting", "joints")};
constexpr const char* kFilterShown[] = {TRANSLATE_NOOP("setting", "Kalman"), TRANSLATE_NOOP("setting", "low-pass"),
                                        TRANSLATE_NOOP("setting", "adaptive window"),
                                        TRANSLATE_NOOP("setting", "raw difference")};
static_assert(std::size(kFilterShown) == std::size(kFilterWords));
constexpr const char* kStylusAxisShown[] = {TRANSLATE_NOOP("setting", "+z, from the tip to the hand"),
                                            TRANSLATE_NOOP("setting", "−z, from the hand to the tip")};
constexpr const char* kSearchShown[] = {TRANSLATE_NOOP("setting", "nearest overall"),
                                        TRANSLATE_NOOP("setting", "nearest overall, by tree"),
                                        TRANSLATE_NOOP("setting", "along the surface")};
constexpr const char* kOrientationShown[] = {
    TRANSLATE_NOOP("setting", "none"), TRANSLATE_NOOP("setting", "direction of z (axis)"),
    TRANSLATE_NOOP("setting", "angle about the joint"), TRANSLATE_NOOP("setting", "full orientation")};
constexpr const char* kForceLawShown[] = {TRANSLATE_NOOP("setting", "energy, F = K e"),
                                          TRANSLATE_NOOP("setting", "thesis 5.2")};
constexpr const char* kSolverShown[] = {TRANSLATE_NOOP("setting", "automatic"),
                                        TRANSLATE_NOOP("setting", "closed form"),
                                        TRANSLATE_NOOP("setting", "iterative")};

constexpr SettingOf<Description> kOfScene[] = {row::oneOf<&Description::combine, kCombineWords>(
    {.key = "combine",
     .label = TRANSLATE_NOOP("setting", "combination of forces"),
     .tip = TRANSLATE_NOOP(
         "setting", "The forces of all constraints are added, or only the constraint nearest to the stylus acts.")})};

constexpr SettingOf<Simulation> kOfSimulation[] = {
    row::oneOf<&Simulation::integrator, kIntegratorWords>(
        {.key = "integrator",
         .label = TRANSLATE_NOOP("setting", "integrator"),
         .tip = TRANSLATE_NOOP("setting", "The integration method for a substep of the simulated arm.")}),
    row::member<&Simulation::substep_us>(
        {.key = "substep_us",
         .label = TRANSLATE_NOOP("setting", "substep"),
         .tip = TRANSLATE_NOOP("setting", "The longest substep of the simulated arm, in microseconds."),
         .unit = TRANSLATE_NOOP("setting", "us"),
         .min = kShortestSubstep_us,
         .max = kLongestSubstep_us,
         .wrong = TRANSLATE_NOOP("problem", "This must be from %1 to %2 µs; here it is %3.")})};

constexpr SettingOf<Control> kOfControl[] = {
    row::oneOf<&Control::law, kLawWords, kLawShown>(
        {.key = "law",
         .label = TRANSLATE_NOOP("setting", "control law"),
         .tip = TRANSLATE_NOOP("setting",
                               "P: f = kp e.  PD: f = kp e + kd de/dt.  PID: f = kp e + kd de/dt + integral of ki e."),
         .given = Always}),
    row::gain<&Gains::kp_N_per_mm, LawType::P>(
        {.key = "kp_N_per_mm",
         .label = TRANSLATE_NOOP("setting", "stiffness"),
         .tip = TRANSLATE_NOOP(
             "setting",
             "Pulls the stylus back with this force for each millimetre of error: f = kp e (proportional gain)."),
         .unit = TRANSLATE_NOOP("setting", "N/mm")}),
    row::gain<&Gains::kd_N_s_per_mm, LawType::PD>(
        {.key = "kd_N_s_per_mm",
         .label = TRANSLATE_NOOP("setting", "damping"),
         .tip = TRANSLATE_NOOP("setting",
                               "Resists a change of the error: f = kd de/dt (derivative gain, for PD and PID)."),
         .unit = TRANSLATE_NOOP("setting", "N s/mm")}),
    row::gain<&Gains::ki_N_per_mm_s, LawType::PID>(
        {.key = "ki_N_per_mm_s",
         .label = TRANSLATE_NOOP("setting", "integral gain"),
         .tip = TRANSLATE_NOOP("setting",
                               "Removes an error that stays, over time: df/dt = ki e (integral gain, for PID)."),
         .unit = TRANSLATE_NOOP("setting", "N/(mm s)")}),
    row::oneOf<&Control::anisotropy, kAnisotropyWords, kAnisotropyShown>(
        {.key = "anisotropy",
         .label = TRANSLATE_NOOP("setting", "nearest point"),
         .tip = TRANSLATE_NOOP(
             "setting",
             "With unequal gains the point of least effort is not the point of least distance. With least effort the "
             "stylus stays where it is put; with least distance, as in the thesis, it may creep.")}),
    row::oneOf<&Control::passivity, kPassivityWords, kPassivityShown>(
        {.key = "passivity",
         .label = TRANSLATE_NOOP("setting", "passivity"),
         .tip = TRANSLATE_NOOP("setting",
                               "Observe: adds up the energy that the stylus puts into the constraint and gets back, E "
                               "= sum of f dx; below 0 the wall is active. Control: also adds the missing damping.")}),
    row::oneOf<&Control::space, kSpaceWords, kSpaceShown>(
        {.key = "space",
         .label = TRANSLATE_NOOP("setting", "control space"),
         .tip = TRANSLATE_NOOP(
             "setting",
             "Cartesian: f = kp e at the tip, axis by axis. Joints: torques pull joints 1 to 3 to those of the target, "
             "tau = K (q* - q), f = J^-T tau; the gains are as felt in the middle of the workspace.")})};

constexpr SettingOf<Velocity> kOfVelocity[] = {
    row::filter({.key = "filter",
                 .label = TRANSLATE_NOOP("setting", "velocity filter"),
                 .tip = TRANSLATE_NOOP("setting",
                                       "How the rate de/dt is estimated from positions in encoder steps: each filter "
                                       "trades delay for noise in another way."),
                 .given = Required,
                 .shown = kFilterShown}),
    row::ofFilter<&KalmanFilter::noise_mm>({.key = "noise_mm",
                                            .label = TRANSLATE_NOOP("setting", "noise"),
                                            .tip = TRANSLATE_NOOP("setting", "The standard deviation of a sample."),
                                            .unit = TRANSLATE_NOOP("setting", "mm"),
                                            .min = 1e-6,
                                            .max = 1e3}),
    row::ofFilter<&KalmanFilter::acceleration_mm_per_s2>(
        {.key = "acceleration_mm_per_s2",
         .label = TRANSLATE_NOOP("setting", "acceleration"),
         .tip = TRANSLATE_NOOP(
             "setting", "The acceleration expected of the hand: with more, the filter follows faster and is noisier."),
         .unit = TRANSLATE_NOOP("setting", "mm/s²"),
         .min = 1e-3,
         .max = 1e9}),
    row::ofFilter<&LowPassFilter::time_constant_ms>(
        {.key = "time_constant_ms",
         .label = TRANSLATE_NOOP("setting", "time constant"),
         .tip = TRANSLATE_NOOP("setting", "Time constant tau of the low-pass, r' = (de/dt - r) / tau: its delay."),
         .unit = TRANSLATE_NOOP("setting", "ms"),
         .min = 0.0,
         .max = 1e3}),
    row::ofFilter<&AdaptiveWindowFilter::window>(
        {.key = "window",
         .label = TRANSLATE_NOOP("setting", "longest window"),
         .tip = TRANSLATE_NOOP("setting", "The longest window, in ticks: a longer one is smoother but adds delay."),
         .unit = TRANSLATE_NOOP("setting", "ticks"),
         .min = 1.0,
         .max = control::kLongestWindow},
        SettingKind::Whole),
    row::ofFilter<&AdaptiveWindowFilter::noise_mm>(
        {.key = "noise_mm",
         .label = TRANSLATE_NOOP("setting", "noise"),
         .tip = TRANSLATE_NOOP("setting", "How far a sample may lie off the line through the ends of the window."),
         .unit = TRANSLATE_NOOP("setting", "mm"),
         .min = 0.0,
         .max = 1e3})};

constexpr SettingOf<Constraint> kOfConstraint[] = {row::presentIf<Constraint>(
    &partsSpace, row::oneOf<&Constraint::side, kSideWords>(
                     {.key = "side",
                      .label = TRANSLATE_NOOP("setting", "side"),
                      .tip = TRANSLATE_NOOP("setting",
                                            "Both: the stylus is held to the surface. Outside, inside: the stylus is "
                                            "free on that side, and a wall pushes it back from the other.")}))};

constexpr SettingOf<Influence> kOfInfluence[] = {
    row::member<&Influence::t>(
        {.key = "t",
         .label = TRANSLATE_NOOP("setting", "influence t"),
         .tip = TRANSLATE_NOOP("setting",
                               "0: the point that the stylus points at; 1: the point nearest to the tip; between "
                               "them along the shorter arc: theta = alpha + t wrap(beta - alpha)."),
         .min = 0.0,
         .max = 1.0,
         .given = Required,
         .wrong =
             TRANSLATE_NOOP("problem", "This must be from 0 (orientation only) to 1 (position only); here it is %1.")}),
    row::oneOf<&Influence::stylus_axis, kStylusAxisWords, kStylusAxisShown>(
        {.key = "stylus_axis",
         .label = TRANSLATE_NOOP("setting", "stylus axis"),
         .tip = TRANSLATE_NOOP(
             "setting",
             "Which end of the stylus points at the shape: z of frame 6 points from the tip into the hand.")}),
    row::member<&Influence::blend_deg>(
        {.key = "blend_deg",
         .label = TRANSLATE_NOOP("setting", "blend width"),
         .tip = TRANSLATE_NOOP("setting",
                               "Within this angle of the shape's axis the stylus's direction counts less and less, and "
                               "the target changes smoothly to position only."),
         .unit = TRANSLATE_NOOP("setting", "°"),
         .min = 0.0,
         .max = 30.0,
         .wrong = TRANSLATE_NOOP("problem", "This must be from 0 to 30 degrees; here it is %1.")})};

constexpr SettingOf<Friction> kOfFriction[] = {
    row::member<&Friction::static_share>(
        {.key = "static",
         .label = TRANSLATE_NOOP("setting", "static friction"),
         .tip = TRANSLATE_NOOP("setting",
                               "How firmly the target sticks: coefficient of static friction. It moves when the force "
                               "along the surface exceeds this share of the force across it."),
         .min = 0.0,
         .max = kMaxFriction,
         .given = Required,
         .wrong = TRANSLATE_NOOP("problem", "This must be from 0 (smooth) to %1; here it is %2.")}),
    row::checkedBy<Friction>(
        &judgeDynamic, dynamicShare({.key = "dynamic",
                                     .label = TRANSLATE_NOOP("setting", "dynamic friction"),
                                     .tip = TRANSLATE_NOOP("setting",
                                                           "How strongly the target drags while it slides: coefficient "
                                                           "of dynamic friction, at most the static one."),
                                     .min = 0.0,
                                     .max = kMaxFriction}))};

// For a mesh and for a curve.
constexpr const char* kSearchTip =
    TRANSLATE_NOOP("setting",
                   "Nearest overall: the target may change to another part of the mesh or curve. Along the surface: it "
                   "stays on the part it is on.");

constexpr SettingOf<Mesh> kOfMesh[] = {
    row::oneOf<&Mesh::search, kSearchWords, kSearchShown>(
        {.key = "search", .label = TRANSLATE_NOOP("setting", "search"), .tip = kSearchTip}),
    row::member<&Mesh::smooth_deg>(
        {.key = "smooth_deg",
         .label = TRANSLATE_NOOP("setting", "smoothing"),
         .tip = TRANSLATE_NOOP("setting",
                               "Bends between faces feel round: the force tilts by up to this angle from the face's "
                               "own normal. Edges that bend by more stay sharp. 0: faces as they are."),
         .unit = TRANSLATE_NOOP("setting", "°"),
         .min = 0.0,
         .max = kMaxSmooth_deg,
         .wrong = TRANSLATE_NOOP("problem", "This must be from 0 (faces as they are) to %1 degrees; here it is %2.")})};

constexpr SettingOf<Curve> kOfCurve[] = {
    row::oneOf<&Curve::search, kSearchWords, kSearchShown>(
        {.key = "search", .label = TRANSLATE_NOOP("setting", "search"), .tip = kSearchTip}),
    row::oneOf<&Curve::kind, kCurveWords>(
        {.key = "kind",
         .label = TRANSLATE_NOOP("setting", "kind of curve"),
         .tip = TRANSLATE_NOOP("setting", "How the points are joined: smoothly, or by straight lines.")}),
    row::member<&Curve::closed>({.key = "closed",
                                 .label = TRANSLATE_NOOP("setting", "closed curve"),
                                 .tip = TRANSLATE_NOOP("setting", "The curve returns to its first point.")})};

constexpr SettingOf<CurveGuidance> kOfGuide[] = {
    row::member<&CurveGuidance::speed_mm_per_s>(
        {.key = "speed_mm_per_s",
         .label = TRANSLATE_NOOP("setting", "speed of the guide"),
         .tip = TRANSLATE_NOOP(
             "setting",
             "How fast the guide moves along the curve; in a scene file, a negative speed moves it backwards."),
         .unit = TRANSLATE_NOOP("setting", "mm/s"),
         .min = -kFastest_mm_per_s,
         .max = kFastest_mm_per_s,
         .given = Required,
         .wrong = TRANSLATE_NOOP("problem", "This must be from -2000 to 2000 mm/s; here it is %1.")}),
    row::member<&CurveGuidance::t>(
        {.key = "t",
         .label = TRANSLATE_NOOP("setting", "guide t"),
         .tip = TRANSLATE_NOOP("setting",
                               "0: to the guide; 1: to the point nearest to the tip; between them along the curve: "
                               "s = s_guide + t (s_hand - s_guide)."),
         .min = 0.0,
         .max = 1.0,
         .wrong =
             TRANSLATE_NOOP("problem", "This must be from 0 (guide only) to 1 (nearest point only); here it is %1.")}),
    row::member<&CurveGuidance::lead_mm>(
        {.key = "lead_mm",
         .label = TRANSLATE_NOOP("setting", "lead of the guide"),
         .tip = TRANSLATE_NOOP("setting", "How far ahead of the hand the guide may go before it waits."),
         .unit = TRANSLATE_NOOP("setting", "mm"),
         .min = 0.0,
         .max = 1000.0,
         .is_above_min = true,
         .wrong = TRANSLATE_NOOP("problem", "This must be above 0 and at most 1000 mm; here it is %1.")})};

constexpr SettingOf<VirtualManipulator> kOfRobot[] = {
    row::oneOf<&VirtualManipulator::orientation, kOrientationWords, kOrientationShown>(
        {.key = "orientation",
         .label = TRANSLATE_NOOP("setting", "orientation"),
         .tip = TRANSLATE_NOOP("setting",
                               "None: e = (p, 0). Direction of z: e_o = z_V − z_T. Angle about the one revolute joint, "
                               "as in the thesis. Full orientation: e_o is the rotation vector.")}),
    row::checkedBy<VirtualManipulator>(
        &row::checkedAsGain,
        row::member<&VirtualManipulator::ko_N_mm_per_rad>(
            {.key = "ko_N_mm_per_rad",
             .label = TRANSLATE_NOOP("setting", "rotational stiffness"),
             .tip = TRANSLATE_NOOP(
                 "setting",
                 "How firmly the end effector's orientation follows the stylus's: it adds Kθ e_o² / 2 to the energy, "
                 "so that the joints, and with them the end effector, go where the stylus points."),
             .unit = TRANSLATE_NOOP("setting", "N mm/rad"),
             .min = 0.0,
             .max = kHighestGain})),
    row::oneOf<&VirtualManipulator::force_law, kForceLawWords, kForceLawShown>(
        {.key = "force_law",
         .label = TRANSLATE_NOOP("setting", "force law"),
         .tip = TRANSLATE_NOOP(
             "setting",
             "Energy: F = K e at the joints of least energy; no work is done around a closed path. Thesis 5.2, for one "
             "joint: F = kp e − (ko e_θ / L) t; it does work around a closed path.")})};

constexpr SettingOf<Solver> kOfSolver[] = {
    row::oneOf<&Solver::method, kSolverWords, kSolverShown>(
        {.key = "method",
         .label = TRANSLATE_NOOP("setting", "solver method"),
         .tip = TRANSLATE_NOOP("setting",
                               "Automatic: a closed form where the chain has one (a circle, sphere, cylinder, line or "
                               "plane), otherwise iteration (Levenberg and Marquardt, from the last tick's joints).")}),
    row::member<&Solver::max_steps>(
        {.key = "max_steps",
         .label = TRANSLATE_NOOP("setting", "solver steps"),
         .tip =
             TRANSLATE_NOOP("setting", "The most iterations in one tick, 1 to 100; the next tick goes on from there."),
         .min = 1.0,
         .max = 100.0}),
    row::member<&Solver::tolerance>(
        {.key = "tolerance",
         .label = TRANSLATE_NOOP("setting", "solver tolerance"),
         .tip = TRANSLATE_NOOP(
             "setting",
             "The iteration ends when no joint would move by more than this: in rad, or as a fraction of the reach."),
         .min = 0.0,
         .max = 0.01,
         .is_above_min = true,
         .wrong = TRANSLATE_NOOP(
             "problem", "This must be above 0 and at most 0.01 (rad, or a fraction of the reach); here it is %1.")})};

constexpr Setting kSpring{
    .key = "stiffness_N_per_mm",
    .label = TRANSLATE_NOOP("setting", "spring of the joint"),
    .tip = TRANSLATE_NOOP("setting",
                          "The joint's own spring adds k (q - rest)^2 / 2 to the energy; 0: the joint moves freely."),
    .unit = TRANSLATE_NOOP("setting", "N/mm"),
    .min = 0.0,
    .max = kHighestGain};
constexpr Setting turningSpring() {
  Setting spring = kSpring;
  spring.key = "stiffness_N_mm_per_rad";
  spring.unit = TRANSLATE_NOOP("setting", "N mm/rad");
  return spring;
}

constexpr SettingOf<Joint> kOfJoint[] = {
    row::checkedBy<Joint>(
        &jointProblem,
        row::member<&Joint::min>({.key = "min",
                                  .label = TRANSLATE_NOOP("setting", "lower limit of the joint"),
                                  .tip = TRANSLATE_NOOP("setting", "The smallest value; none: no limit.")})),
    row::checkedBy<Joint>(&jointProblem, row::member<&Joint::max>(
                                             {.key = "max",
                                              .label = TRANSLATE_NOOP("setting", "upper limit of the joint"),
                                              .tip = TRANSLATE_NOOP("setting", "The largest value; none: no limit.")})),
    row::checkedBy<Joint>(&row::checkedAsGain,
                          row::presentIf<Joint>(&turns, row::member<&Joint::stiffness>(turningSpring()))),
    row::checkedBy<Joint>(&row::checkedAsGain, row::presentIf<Joint>(&slides, row::member<&Joint::stiffness>(kSpring))),
    row::checkedBy<Joint>(
        &jointProblem,
        row::member<&Joint::rest>({.key = "rest",
                                   .label = TRANSLATE_NOOP("setting", "rest position of the joint"),
                                   .tip = TRANSLATE_NOOP("setting", "Where the joint's spring exerts no force.")}))};

}  // namespace

const AllRows& allRows() {
  static constexpr AllRows kAll{kOfScene,     kOfSimulation, kOfControl, kOfVelocity, kOfConstraint,
                                kOfInfluence, kOfFriction,   kOfMesh,    kOfCurve,    kOfGuide,
                                kOfRobot,     kOfSolver,     kOfJoint};
  return kAll;
}

}  // namespace underact::scene
