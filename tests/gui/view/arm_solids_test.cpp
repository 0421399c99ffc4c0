#include "app/gui/view/arm_solids.h"

#include <gtest/gtest.h>

#include "app/gui/view/arm_picture.h"
#include "app/gui/view/shadow_picture.h"
#include "core/base/units.h"
#include "core/chain/kinematics.h"
#include "tests/gui/example.h"

namespace underact::gui {
namespace {

const arm::Model& modelNamed(const char* name) {
  return *arm::findModel(name);
}

/// Some points of the surface of a solid, with all joints at 0.
std::vector<Vec3> pointsOfSolid(const ArmSolid& solid) {
  std::vector<Vec3> points;
  if (const auto* turned = std::get_if<TurnedForm>(&solid.form)) {
    for (const Ring& ring : turned->profile) {
      for (int part = 0; part < 8; ++part) {
        const double angle_rad = 0.25 * kPi * part;
        points.push_back(turned->X_WS *
                         Vec3(ring.radius * std::cos(angle_rad), ring.radius * std::sin(angle_rad), ring.z));
      }
    }
  } else if (const auto* bent = std::get_if<BentForm>(&solid.form)) {
    for (int part = 0; part <= 8; ++part) {
      const double angle_rad = bent->turn_rad * part / 8;
      points.push_back(bent->p_WC +
                       bent->radius_m * (std::cos(angle_rad) * bent->from_W + std::sin(angle_rad) * bent->to_W));
    }
  } else if (const auto* box = std::get_if<BoxForm>(&solid.form)) {
    for (const double side : {-1.0, 1.0}) points.push_back(box->X_WS * Vec3(side * box->half_m));
  }
  return points;
}

double distanceToAxis(const chain::Joint& joint, const Vec3& p_W) {
  return (p_W - joint.p_WJ).cross(joint.axis_W).norm();
}

/// An arm of joints along x, which turn about z and y in turn; every third one slides.
arm::Model armOf(std::size_t joints) {
  arm::Model model;
  std::vector<chain::Joint> chain;
  for (std::size_t index = 0; index < joints; ++index) {
    chain::Joint joint;
    joint.type = index % 3 == 2 ? chain::JointType::Prismatic : chain::JointType::Revolute;
    joint.axis_W = index % 3 == 2 ? Vec3::UnitX() : index % 2 == 0 ? Vec3::UnitZ() : Vec3::UnitY();
    joint.p_WJ = Vec3(0.1 * static_cast<double>(index), 0.0, 0.2);
    joint.min = -0.1;
    joint.max = 0.1;
    chain.push_back(joint);
  }
  Pose X_WT = Pose::Identity();
  X_WT.translation() = Vec3(0.1 * static_cast<double>(joints), 0.0, 0.2);
  model.chain = chain::makeChain(chain, X_WT, {}).value();
  model.joints.resize(joints);
  return model;
}

}  // namespace

TEST(ArmSolids, EveryArmHasABaseOnTheDeskAndSolidsOnEachLinkThatReachTheTip) {
  for (const arm::Model& model : arm::models()) {
    const ArmSolids arm = solidsOf(model);
    const std::size_t count = model.chain.joints.size();
    ASSERT_EQ(arm.axes.size(), count) << model.name;
    std::vector<int> on_link(count + 1, 0);
    double nearest_to_tip_m = kInfinity, lowest_m = kInfinity;
    for (const ArmSolid& solid : arm.solids) {
      ASSERT_LE(solid.link, count) << model.name;
      ++on_link[solid.link];
      for (const Vec3& p_W : pointsOfSolid(solid)) {
        ASSERT_TRUE(p_W.allFinite()) << model.name;
        if (solid.link == 0) lowest_m = std::min(lowest_m, (p_W - arm.stand.p_WG).dot(arm.stand.up_W()));
        if (solid.link == count) nearest_to_tip_m = std::min(nearest_to_tip_m, (p_W - arm.p_WTip).norm());
      }
    }
    EXPECT_GT(on_link.front(), 0) << model.name;
    EXPECT_GT(on_link.back(), 0) << model.name;
    for (std::size_t link = 1; link < count; ++link) {
      const bool moves_alone = (arm.axes[link].in_W - arm.axes[link - 1].out_W).norm() > 0.03 * kOmniReach_m;
      EXPECT_TRUE(!moves_alone || on_link[link] > 0) << model.name << ' ' << link;
    }
    EXPECT_LT(nearest_to_tip_m, 0.004 * arm.stand.size) << model.name;
    const bool has_rail = model.chain.joints.front().type == chain::JointType::Prismatic;  // which may reach farther
    EXPECT_TRUE(has_rail || std::abs(lowest_m) < 1e-9) << model.name << ' ' << lowest_m;
  }
}

TEST(ArmSolids, AHousingStandsOnItsAxisAndLinksBeginAndEndOnAxes) {
  for (const arm::Model& model : arm::models()) {
    const std::vector<DrawnAxis> axes = drawnAxes(model);
    for (std::size_t index = 0; index < axes.size(); ++index) {
      const chain::Joint& joint = model.chain.joints[index];
      if (joint.type != chain::JointType::Revolute) continue;
      EXPECT_NEAR(distanceToAxis(joint, axes[index].in_W), 0.0, 1e-9) << model.name << ' ' << index;
      EXPECT_NEAR(distanceToAxis(joint, axes[index].out_W), 0.0, 1e-9) << model.name << ' ' << index;
      EXPECT_GT(axes[index].radius_m, 0.0) << model.name;
    }
  }
}

TEST(ArmSolids, ArmsOfOneToEightJointsThatTurnOrSlideAreDrawn) {
  for (std::size_t joints = 1; joints <= arm::kMaxJoints; ++joints) {
    const arm::Model model = armOf(joints);
    ArmPicture picture;
    picture.setArm(model);
    EXPECT_EQ(picture.solids().size(), joints + 1);
    EXPECT_FALSE(picture.known());
    std::vector<double> q(joints, 0.05);
    EXPECT_TRUE(picture.present(q));
    const Pose X_WT = chain::forward(model.chain, q);
    EXPECT_TRUE(picture.X_WT().isApprox(X_WT, 1e-12));
    EXPECT_TRUE(picture.stylus_W()[0].isApprox(X_WT.translation(), 1e-12)) << joints;
    q.back() = kNotANumber;
    EXPECT_FALSE(picture.present(q));  // the last pose stays
    EXPECT_TRUE(picture.X_WT().isApprox(X_WT, 1e-12));
  }
}

TEST(ArmSolids, ThoseOfTheArmsFileAreDrawnInPlaceOfTheFormula) {
  arm::Model model = armOf(3);
  const std::size_t by_formula = solidsOf(model).solids.size();
  model.solids = {{0, Pose::Identity(), arm::BoxSolid{Vec3(0.1, 0.1, 0.02)}},
                  {1, Pose::Identity(), arm::CylinderSolid{0.02, 0.2}},
                  {2, Pose::Identity(), arm::CapsuleSolid{0.01, 0.1}},
                  {3, Pose::Identity(), arm::SphereSolid{0.02}}};
  const ArmSolids drawn = solidsOf(model);
  ASSERT_GE(drawn.solids.size(), 4U);
  EXPECT_NE(drawn.solids.size(), by_formula);
  EXPECT_EQ(std::get<BoxForm>(drawn.solids[0].form).half_m, Vec3(0.05, 0.05, 0.01));
  const TurnedForm& rod = std::get<TurnedForm>(drawn.solids[1].form);
  EXPECT_EQ(rod.profile.front().z, -0.1);
  EXPECT_EQ(rod.profile.back().z, 0.1);
  const TurnedForm& capsule = std::get<TurnedForm>(drawn.solids[2].form);
  EXPECT_NEAR(capsule.profile.front().z, -0.06, 1e-15);
  EXPECT_NEAR(std::get<TurnedForm>(drawn.solids[3].form).profile.back().z, 0.02, 1e-15);
  ArmPicture picture;
  picture.setArm(model);
  EXPECT_TRUE(picture.present(std::vector<double>(3, 0.1)));
  EXPECT_EQ(picture.solids().size(), 4U);
}

TEST(ArmSolids, AnArmOfTwiceTheSizeIsDrawnTwiceAsLarge) {
  arm::Model large = modelNamed("ur5e");
  const ArmSolids small = solidsOf(large);
  for (chain::Joint& joint : large.chain.joints) joint.p_WJ *= 2.0;
  large.chain.X_WT_home.translation() *= 2.0;
  const ArmSolids twice = solidsOf(large);
  ASSERT_EQ(small.solids.size(), twice.solids.size());
  for (std::size_t index = 0; index < small.solids.size(); ++index) {
    const std::vector<Vec3> before = pointsOfSolid(small.solids[index]), after = pointsOfSolid(twice.solids[index]);
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t at = 0; at < before.size(); ++at) EXPECT_TRUE(after[at].isApprox(2.0 * before[at], 1e-9)) << index;
  }
  EXPECT_NEAR(twice.stand.size, 2.0 * small.stand.size, 1e-12);
}

TEST(ArmSolids, TheGimbalOfAHapticDeviceLeavesTheTipFreeAndCarriesAStylusTowardsTheHand) {
  const ArmSolids arm = solidsOf(modelNamed("omni-thesis"));
  for (const ArmSolid& solid : arm.solids) {
    if (solid.link == 6) continue;
    for (const Vec3& p_W : pointsOfSolid(solid)) EXPECT_GT((p_W - arm.p_WTip).norm(), 0.012) << solid.link;
  }
  const Vec3 z_W = modelNamed("omni-thesis").chain.X_WT_home.linear().col(2);
  EXPECT_GT((arm.p_WEnd - arm.p_WTip).dot(z_W), 0.08);
  EXPECT_TRUE(arm.stand.up_W().isApprox(Vec3::UnitY()));
  EXPECT_TRUE(standOf(modelNamed("ur10e")).up_W().isApprox(Vec3::UnitZ()));
  EXPECT_GT(standOf(modelNamed("ur10e")).size, 4.0);
}

TEST(ArmSolids, ARailStaysInItsSleeveOverTheWholeRange) {
  const arm::Model& model = modelNamed("stanford");  // joint 3 slides
  const ArmSolids arm = solidsOf(model);
  const chain::Joint& slide = model.chain.joints[2];
  const BoxForm *rail = nullptr, *sleeve = nullptr;
  for (const ArmSolid& solid : arm.solids) {
    const auto* box = std::get_if<BoxForm>(&solid.form);
    if (box == nullptr || solid.finish == Finish::Trim) continue;
    (solid.link == 3 ? rail : sleeve) = box;
  }
  ASSERT_NE(rail, nullptr);
  ASSERT_NE(sleeve, nullptr);
  const double middle_m = sleeve->X_WS.translation().dot(slide.axis_W);
  for (const double q : {slide.min, slide.max}) {
    const double at_m = rail->X_WS.translation().dot(slide.axis_W) + q;
    EXPECT_LT(std::abs(at_m - middle_m), rail->half_m.z()) << q;
  }
}

TEST(ArmShadow, IsDarkUnderARodNearTheDeskPaleUnderAHighOneAndNowhereElse) {
  const auto shadeAt = [](const ShadowField& field, const Vec3& p_W) {
    double nearest_m = kInfinity;
    float shade = 0.0F;
    const int n = ShadowField::kPoints;
    for (int at = 0; at < n * n; ++at) {
      const double x = at % n, z = std::floor(static_cast<double>(at) / n);
      const Vec3 q_W = field.p_WCorner + x / (n - 1) * field.x_W + z / (n - 1) * field.z_W;
      if ((q_W - p_W).norm() >= nearest_m) continue;
      nearest_m = (q_W - p_W).norm();
      shade = field.shade[static_cast<std::size_t>(at)];
    }
    return shade;
  };
  const auto rodAt = [](double height_m) {
    return std::vector<ShadowRod>{{{-0.1, height_m, 0.0}, {0.1, height_m, 0.0}, 0.01, 0.01}};
  };
  const ShadowField low = shadowOf(rodAt(0.01), Pose::Identity(), 1.0);
  const ShadowField high = shadowOf(rodAt(0.2), Pose::Identity(), 1.0);
  EXPECT_GT(shadeAt(low, Vec3::Zero()), 0.9F);
  EXPECT_LT(shadeAt(low, Vec3(0.0, 0.0, 0.02)), 0.02F);
  EXPECT_LT(shadeAt(high, Vec3::Zero()), 0.4F);
  EXPECT_GT(shadeAt(high, Vec3::Zero()), 0.02F);
  EXPECT_GT(shadeAt(high, Vec3(0.0, 0.0, 0.02)), 0.02F);  // wide
  for (const float shade : low.shade) EXPECT_TRUE(shade >= 0.0F && shade <= 1.0F);
  EXPECT_TRUE(shadowOf({}, Pose::Identity(), 1.0).shade.empty());
}

TEST(ArmPicture, TheArmAndItsShadowAreInThePictureAndGoWithTheirLayer) {
  test::Shown shown({}, Camera::Isometric);
  const Vec3 tip_W(0.02, 0.01, 0.02);
  servo::Snapshot snapshot = test::snapshotAt(tip_W, tip_W, Vec3::Zero());
  shown.view.present(snapshot);
  shown.moveCamera(Camera::Isometric);  // to all, the floor with it
  Layers layers;
  layers.workspace = layers.triads = layers.target = false;
  shown.view.setLayers(layers);
  const arm::Skeleton bones = arm::skeleton(test::preset().geometry, snapshot.report.sample.q_rad);
  const auto is_dark = [](const QColor& c) { return c.lightness() < 150; };
  const auto is_shade = [](const QColor& c) {
    return c.lightness() < 238 && c.lightness() > 150 && c.saturation() < 20;
  };
  QImage picture = shown.view.picture();
  for (const double share : {0.15, 0.5, 0.85}) {
    const Vec3 thigh_W = bones.p_WShoulder + share * (bones.p_WElbow - bones.p_WShoulder);
    EXPECT_GT(test::count(picture, shown.view.screenOf(thigh_W), 2.0, is_dark), 8) << share;
  }
  const ArmStand stand = standOf(*arm::findModel(arm::kDefaultArm));
  const Vec3 under_W = Vec3(bones.p_WTip.x(), stand.p_WG.y(), bones.p_WTip.z());
  EXPECT_GT(test::count(picture, shown.view.screenOf(under_W), 3.0, is_shade), 20);
  layers.arm = false;
  shown.view.setLayers(layers);
  picture = shown.view.picture();
  EXPECT_EQ(test::count(picture, shown.view.screenOf(bones.p_WElbow), 3.0, is_dark), 0);
  EXPECT_EQ(test::count(picture, shown.view.screenOf(under_W), 3.0, is_shade), 0);
  EXPECT_EQ(shown.view.glErrors(), 0);
}

}  // namespace underact::gui
