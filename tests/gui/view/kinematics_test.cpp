#include <gtest/gtest.h>

#include "app/gui/view/hand_picture.h"
#include "app/gui/view/kinematics_picture.h"
#include "core/arm/branches.h"
#include "core/arm/jacobian.h"
#include "core/arm/model.h"
#include "core/base/units.h"
#include "tests/gui/example.h"

namespace underact::gui {
namespace {

using test::count;
using test::isPurple;
using test::preset;
using test::Shown;

const Vec3 kTip(0.020, 0.010, 0.020);

bool isSky(const QColor& c) {
  return c.saturation() > 100 && c.hue() > 195 && c.hue() < 212;
}

Layers only(bool Layers::*layer) {
  Layers layers;
  layers.workspace = layers.triads = layers.target = layers.force = false;
  layers.*layer = true;
  return layers;
}

/// A view of the arm alone, from the right and above, with one of the layers for teaching.
struct Taught : Shown {
  explicit Taught(bool Layers::*layer) : Shown({}, Camera::Isometric) {
    snapshot = test::snapshotAt(kTip, kTip, Vec3::Zero());
    snapshot.report.sample.q_rad[3] = 0.4;
    snapshot.report.sample.q_rad[4] = 1.1;
    snapshot.report.sample.q_rad[5] = 0.5;
    view.setLayers(only(layer));
    view.present(snapshot);
    moveCamera(Camera::Isometric);
  }
  const arm::JointAngles& q_rad() const { return snapshot.report.sample.q_rad; }
  arm::Solutions solutions() const {
    return arm::solveAll(preset().geometry, preset().limits, arm::tipPose(preset().geometry, q_rad()));
  }
  template <class Fits>
  int at(const Vec3& p_W, Fits fits, double around = 2.5) {
    return count(view.picture(), view.screenOf(p_W), around, fits);
  }
  servo::Snapshot snapshot;
};

TEST(KinematicsPicture, GhostsStandWhereTheLibraryPutsTheirElbows) {
  Taught taught(&Layers::ghosts);
  const arm::Solutions solutions = taught.solutions();
  ASSERT_EQ(solutions.count, 8u);
  EXPECT_EQ(taught.view.solutionsDrawn(), 8u);
  for (const arm::Solution& solution : solutions) {
    const arm::Skeleton ghost = arm::skeleton(preset().geometry, solution.q_rad);
    const arm::Skeleton arm = arm::skeleton(preset().geometry, taught.q_rad());
    if ((ghost.p_WElbow - arm.p_WElbow).norm() < 1e-6) continue;  // inside the arm's own links
    int upper = 0, fore = 0;  // dashed: somewhere along the link, and all along it in many places
    for (double share = 0.05; share < 1.0; share += 0.05) {
      upper += taught.at(ghost.p_WShoulder + share * (ghost.p_WElbow - ghost.p_WShoulder), isPurple) > 0 ? 1 : 0;
      fore += taught.at(ghost.p_WElbow + share * (ghost.p_WTip - ghost.p_WElbow), isPurple) > 0 ? 1 : 0;
    }
    EXPECT_GE(upper, 8) << static_cast<int>(solution.branch.elbow);
    EXPECT_GE(fore, 8) << static_cast<int>(solution.branch.elbow);
  }
  Layers none = only(&Layers::arm);
  taught.view.setLayers(none);
  EXPECT_EQ(taught.view.solutionsDrawn(), 0u);
  const Vec3 other_elbow = arm::skeleton(preset().geometry, solutions.all[2].q_rad).p_WElbow;
  EXPECT_EQ(taught.at(other_elbow, isPurple, 30.0), 0);
}

TEST(KinematicsPicture, TheChosenGhostIsSolidAndNothingHidesIt) {
  Taught taught(&Layers::arm);
  taught.view.chooseSolution(3);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !taught.view.solutionMoving(); }));
  const arm::Solution solution = taught.solutions().all[2];
  ASSERT_EQ(solution.branch, (arm::Branch{1, -1, 1}));
  const arm::Skeleton ghost = arm::skeleton(preset().geometry, solution.q_rad);
  EXPECT_GT(taught.at(0.5 * (ghost.p_WElbow + ghost.p_WTip), isPurple), 0);
  EXPECT_GT(taught.at(0.5 * (ghost.p_WElbow + ghost.p_WShoulder), isPurple), 0);
  EXPECT_GT(taught.at(ghost.p_WElbow, isPurple, 10.0), 10);
  const Pose X_WT = arm::tipPose(preset().geometry, solution.q_rad);
  EXPECT_GT(taught.at(X_WT * Vec3(0, 0, 0.050), isPurple), 0);  // along the stylus, though the stylus is there
  taught.view.chooseSolution(1);                                // the arm itself: over its links
  ASSERT_TRUE(QTest::qWaitFor([&] { return !taught.view.solutionMoving(); }));
  const arm::Skeleton own = arm::skeleton(preset().geometry, taught.q_rad());
  EXPECT_GT(taught.at(0.5 * (own.p_WElbow + own.p_WShoulder), isPurple), 0);
  taught.view.chooseSolution(0);
  EXPECT_EQ(taught.at(0.5 * (own.p_WElbow + own.p_WShoulder), isPurple, 6.0), 0);
}

TEST(KinematicsPicture, EachLinkFrameShowsItsAxes) {
  Taught taught(&Layers::link_frames);
  const Theme theme = Theme::light();
  const std::array<Pose, arm::kMaxJoints> frames = arm::linkFrames(*arm::findModel(arm::kDefaultArm), taught.q_rad());
  const std::array<QColor, 3> colours{theme.x_axis, theme.y_axis, theme.z_axis};
  const QImage picture = taught.view.picture();
  // Two frames in one place may share an axis: the smaller one lies over the larger one, but for its end.
  const std::array<double, 6> near_end_m{0.027, 0.021, 0.021, 0.027, 0.021, 0.015};
  for (std::size_t frame = 0; frame < 6; ++frame) {  // some of them inside a link or the stylus
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Vec3 p_W = frames[frame] * Vec3(near_end_m[frame] * Vec3::Unit(static_cast<Eigen::Index>(axis)));
      const auto fits = [&](const QColor& c) {
        return c.saturation() > 60 && std::abs(c.hue() - colours[axis].hue()) < 16;
      };
      EXPECT_GT(count(picture, taught.view.screenOf(p_W), 2.5, fits), 0) << frame + 1 << " axis " << axis;
    }
  }
  taught.view.setLayers(only(&Layers::arm));
  const Vec3 z3 = frames[2] * Vec3(0, 0, 0.016);
  EXPECT_EQ(taught.at(
                z3, [](const QColor& c) { return c.saturation() > 60; }, 4.0),
            0);
}

TEST(KinematicsPicture, TheMotionEllipsoidEndsWhereAQuarterOfARadTakesTheTip) {
  Taught taught(&Layers::motion_ellipsoid);
  const arm::Dexterity dexterity = arm::dexterity(preset().geometry, taught.q_rad());
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const Vec3 half = side * KinematicsPicture::kTurn_rad * dexterity.gain_m[axis] * dexterity.axes_W.col(axis);
      EXPECT_GT(taught.at(kTip + half, isSky), 0) << axis << ' ' << side;
      // Of the longest axis: beyond the ends of the others there is the surface about it.
      if (axis == 0) {
        EXPECT_EQ(taught.at(kTip + 1.4 * half, isSky, 1.0), 0) << side;
      }
    }
  }
}

TEST(KinematicsPicture, TheMotionEllipsoidIsASurface) {
  Taught taught(&Layers::motion_ellipsoid);
  const arm::Dexterity dexterity = arm::dexterity(preset().geometry, taught.q_rad());
  const auto tinted = [&] {
    int places = 0;
    for (int corner = 0; corner < 8; ++corner) {  // between its ellipses; some are behind the arm
      const Vec3 sides(corner % 2 == 0 ? 1 : -1, corner / 2 % 2 == 0 ? 1 : -1, corner / 4 == 0 ? 1 : -1);
      const Vec3 half = 0.45 * KinematicsPicture::kTurn_rad * dexterity.gain_m.cwiseProduct(sides);
      places += taught.at(
                    kTip + dexterity.axes_W * half,
                    [](const QColor& c) { return c.saturation() > 25 && c.hue() > 190 && c.hue() < 215; }, 0.5) > 0
                    ? 1
                    : 0;
    }
    return places;
  };
  EXPECT_GE(tinted(), 3);
  taught.view.setLayers(only(&Layers::arm));
  EXPECT_EQ(tinted(), 0);
}

TEST(KinematicsPicture, TheForceEllipsoidIsLongWhereTheMotionIsShort) {
  Taught taught(&Layers::force_ellipsoid);
  const arm::Dexterity dexterity = arm::dexterity(preset().geometry, taught.q_rad());
  const double metre_per_N = 1e-3 * HandPicture::kArrow_mm / preset().continuous_force_N;  // as the arrow is drawn
  for (int axis = 0; axis < 3; ++axis) {
    const double half_m = metre_per_N * KinematicsPicture::kTorque_N_m / dexterity.gain_m[axis];
    const Vec3 half = half_m * dexterity.axes_W.col(axis);
    const auto is_orange = [](const QColor& c) { return c.saturation() > 120 && c.hue() > 34 && c.hue() < 48; };
    // One end may lie behind the stylus.
    EXPECT_GT(taught.at(kTip + half, is_orange) + taught.at(kTip - half, is_orange), 0) << axis;
  }
}

TEST(KinematicsPicture, AtASingularityNothingGrowsWithoutEndAndNothingBreaks) {
  for (const double q3_rad : {kPi / 2, -kPi / 2}) {
    Taught taught(&Layers::force_ellipsoid);
    Layers layers = only(&Layers::force_ellipsoid);
    layers.ghosts = layers.link_frames = layers.motion_ellipsoid = true;
    taught.view.setLayers(layers);
    taught.snapshot.report.sample.q_rad[2] = q3_rad;
    taught.snapshot.report.sample.q_rad[4] = 0.0;
    taught.view.present(taught.snapshot);
    EXPECT_FALSE(taught.view.picture().isNull());
    EXPECT_EQ(taught.view.solutionsDrawn(), taught.solutions().count);
    EXPECT_LT(taught.view.solutionsDrawn(), 8u);
    EXPECT_EQ(taught.view.glErrors(), 0);
  }
}

/// A view of another arm, a little from its rest.
struct OtherArm : Shown {
  explicit OtherArm(const std::string& arm)
      : Shown(
            [&] {
              scene::Description scene;
              scene.arm = arm;
              return scene;
            }(),
            Camera::Isometric) {
    const arm::Preset& preset = *arm::findPreset(arm);
    servo::Snapshot snapshot = test::snapshotAt(kTip, kTip, Vec3::Zero());
    snapshot.report.sample.q_rad = preset.geometry.mechanism->rest;
    for (std::size_t joint = 0; joint < preset.geometry.mechanism->chain.joints.size(); ++joint)
      snapshot.report.sample.q_rad[joint] += 0.02;
    const Pose X_WT = arm::tipPose(preset.geometry, snapshot.report.sample.q_rad);
    snapshot.report.p_WT = snapshot.report.held[0].p_WP = X_WT.translation();
    found = SolutionFinder(*arm::findModel(arm)).at(X_WT);
    Layers layers = only(&Layers::ghosts);
    layers.arm = false;  // it hides ghosts behind it
    view.setLayers(layers);
    view.present(snapshot);
    moveCamera(Camera::Fit);
    ghost.setArm(*arm::findModel(arm));
  }
  /// On how many of its links the ghost is seen: somewhere, since some are dashed.
  int linksSeen(const arm::JointAngles& q, int saturation = 15) {
    const QImage picture = view.picture();
    const std::vector<Vec3> points_mm = ghost.skeleton_mm(q);
    const auto fits = [saturation](const QColor& c) {
      return c.saturation() > saturation && c.hue() > 300 && c.hue() < 345;
    };
    int seen = 0;
    for (std::size_t index = 0; index + 1 < points_mm.size(); ++index) {
      int here = 0;
      for (double share = 0.05; share < 1.0; share += 0.05) {
        const Vec3 p_W = 1e-3 * (points_mm[index] + share * (points_mm[index + 1] - points_mm[index]));
        here += count(picture, view.screenOf(p_W), 1.5, fits);
      }
      seen += here > 0 ? 1 : 0;
    }
    return seen;
  }
  NumberedSolutions found;
  GhostArm ghost;
};

TEST(KinematicsPicture, TheForceEllipsoidOfABigArmIsNoDot) {
  for (const char* name : {"ur5e", "ur10e", "planar-3", "puma-560"}) {
    OtherArm arm(name);
    Layers layers = only(&Layers::force_ellipsoid);
    layers.arm = false;
    arm.view.setLayers(layers);
    const QImage picture = arm.view.picture();
    const auto is_orange = [](const QColor& c) { return c.saturation() > 60 && c.hue() > 30 && c.hue() < 50; };
    const QPointF middle(0.5 * arm.view.width(), 0.5 * arm.view.height());
    EXPECT_GT(count(picture, middle, 0.5 * arm.view.height(), is_orange), 400) << name;
  }
}

TEST(KinematicsPicture, EachSolutionOfAnotherArmIsDrawnFromJointToJoint) {
  for (const char* name : {"ur5e", "cobra-600", "planar-3", "puma-560", "stanford", "panda"}) {
    OtherArm arm(name);
    EXPECT_EQ(arm.view.solutionsDrawn(), arm.found.all.size()) << name;
    EXPECT_GT(arm.found.all.size(), 1U) << name;
    for (const NumberedSolution& one : arm.found.all) {
      EXPECT_GE(arm.linksSeen(one.q), 2) << name << ' ' << one.number;
      // The lines are stronger than the translucent solids, even where several of these lie over one another.
      if (one.within_limits) {
        EXPECT_GE(arm.linksSeen(one.q, 90), 3) << name << ' ' << one.number;
      }
    }
    // To be looked at by people.
    Layers layers = only(&Layers::ghosts);
    arm.view.resize(1280, 800);
    arm.view.setLayers(layers);
    arm.moveCamera(Camera::Fit);
    EXPECT_TRUE(arm.view.picture().save(QString("%1/pictures/ghosts_%2.png").arg(UNDERACT_BINARY).arg(name)));
    EXPECT_EQ(arm.view.glErrors(), 0);
    layers.ghosts = layers.arm = false;
    arm.view.setLayers(layers);
    EXPECT_EQ(arm.view.solutionsDrawn(), 0u);
    EXPECT_EQ(arm.linksSeen(arm.found.all.back().q), 0) << name;
  }
}

TEST(KinematicsPicture, AChosenSolutionOfAnotherArmIsTheOneOfThatNumber) {
  OtherArm arm("ur5e");
  ASSERT_EQ(arm.found.all.size(), 8U);
  for (const int number : {2, 7}) {
    arm.view.chooseSolution(number);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !arm.view.solutionMoving(); }));
    EXPECT_EQ(*arm.view.chosenSolution_rad(), arm.found.find(number)->q);
  }
  arm.view.setLayers(only(&Layers::arm));  // whatever the layers are
  EXPECT_GE(arm.linksSeen(arm.found.find(7)->q), 3);
  arm.view.chooseSolution(12);
  EXPECT_FALSE(arm.view.chosenSolution_rad().has_value());
}

/// How many pixels a turn of the camera by a hundredth of a pixel changes clearly.
int flickering(SceneView& view) {
  Viewpoint viewpoint = view.viewpoint();
  viewpoint.fits = false;
  const QImage one = view.picture();
  viewpoint.camera.azimuth_rad += 2e-5;
  view.setViewpoint(viewpoint);
  const QImage other = view.picture();
  int count = 0;
  for (int y = 0; y < one.height(); ++y) {
    for (int x = 0; x < one.width(); ++x)
      count += std::abs(qGray(one.pixel(x, y)) - qGray(other.pixel(x, y))) > 8 ? 1 : 0;
  }
  return count;
}

TEST(GhostArm, DoesNotFightForDepthWithTheArmAndTheOtherGhosts) {
  for (const bool parallel : {false, true}) {
    OtherArm arm("ur5e");
    Layers layers = only(&Layers::ghosts);
    arm.view.setLayers(layers);  // with the arm, of which each link stands where some ghost's does
    arm.view.setParallel(parallel);
    for (const int number : {1, 3, 6}) {
      arm.view.chooseSolution(number);
      ASSERT_TRUE(QTest::qWaitFor([&] { return !arm.view.solutionMoving() && !arm.view.moving(); }));
      EXPECT_LT(flickering(arm.view), 40) << number << (parallel ? " parallel" : "");
    }
  }
}

TEST(GhostArm, LooksLikeTheSolidsOfItsFile) {
  arm::Model model = *arm::findModel("planar-3");
  GhostArm plain, solid;
  plain.setArm(model);
  model.solids.push_back({2, Pose::Identity(), arm::BoxSolid{Vec3(0.3, 0.3, 0.3)}});
  solid.setArm(model);
  for (GhostArm* ghost : {&plain, &solid}) ghost->presentAll({arm::JointAngles{}});
  EXPECT_LT(plain.actor()->GetBounds()[5], 100.0);
  EXPECT_NEAR(solid.actor()->GetBounds()[5], 150.0, 1e-3);
}

}  // namespace
}  // namespace underact::gui
