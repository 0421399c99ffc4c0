#include "core/chain/closed_form.h"
#include "tests/core/chain/arms.h"

namespace underact::chain {
namespace {

/// The chain of an arm, changed in one place.
template <class Change>
std::optional<SphericalWristArm> recogniseWith(const test::Arm& arm, const Change& change) {
  Chain chain = arm.chain();
  change(chain);
  return recognise(chain);
}

TEST(Recognise, KnowsTheArmsOfTheHouse) {
  for (const test::Arm& arm : test::arms()) EXPECT_TRUE(recognise(arm.chain()).has_value()) << arm.name;
}

TEST(Recognise, MeasuresThePuma) {  // by hand: see its table
  const SphericalWristArm arm = recognise(test::puma().chain()).value();
  EXPECT_NEAR(arm.upper_W.norm(), 0.4318, 1e-15);
  EXPECT_NEAR(arm.fore_W.norm(), std::hypot(0.0203, 0.4331), 1e-15);
  EXPECT_NEAR(arm.along_m, 0.1501, 1e-15);
  EXPECT_NEAR(arm.offset_W.norm(), 0.0, 1e-15);
  EXPECT_EQ(arm.sense, 1.0);
}

TEST(Recognise, DoesNotCareWhichPointsOfTheAxesAreGivenNorWhichWayTheyPoint) {
  const test::Arm puma = test::puma();
  const auto slid = recogniseWith(puma, [](Chain& chain) {
    for (Joint& joint : chain.joints) joint.p_WJ += 0.3 * joint.axis_W;
    chain.joints[2].axis_W *= -1;
  });
  ASSERT_TRUE(slid);
  const SphericalWristArm plain = recognise(puma.chain()).value();
  EXPECT_LE((slid->upper_W - plain.upper_W).norm(), 1e-15);
  EXPECT_LE((slid->p_TC - plain.p_TC).norm(), 1e-15);
  EXPECT_EQ(slid->sense, -1.0);
}

TEST(Recognise, RefusesWhatItIsNot) {
  const test::Arm arm = test::puma();
  EXPECT_FALSE(recogniseWith(arm, [](Chain& chain) { chain.joints.pop_back(); }));
  EXPECT_FALSE(recogniseWith(arm, [](Chain& chain) { chain.joints.push_back(chain.joints[5]); }));
  EXPECT_FALSE(recogniseWith(arm, [](Chain& chain) { chain.joints[2].type = JointType::Prismatic; }));
  EXPECT_FALSE(recogniseWith(arm, [](Chain& chain) { chain.joints[2].axis_W = Vec3(1e-6, 1, 0).normalized(); }));
  EXPECT_FALSE(recogniseWith(arm, [](Chain& chain) { chain.joints[5].p_WJ.x() += 1e-6; }));
  EXPECT_FALSE(recogniseWith(arm, [](Chain& chain) { chain.joints[3].p_WJ.x() += 1e-6; }));
  EXPECT_FALSE(recogniseWith(arm, [](Chain& chain) { chain.joints[0].axis_W = chain.joints[1].axis_W; }));
  EXPECT_FALSE(recogniseWith(arm, [](Chain& chain) { chain.joints[3] = chain.joints[4]; }));
  EXPECT_FALSE(recogniseWith(arm, [](Chain& chain) { chain.joints[5] = chain.joints[4]; }));
  EXPECT_FALSE(recogniseWith(arm, [](Chain& chain) { chain.joints[2] = chain.joints[1]; }));            // no upper arm
  EXPECT_FALSE(recogniseWith(arm, [](Chain& chain) { chain.joints[2].p_WJ = chain.joints[4].p_WJ; }));  // no forearm
}

TEST(Recognise, ForgivesRounding) {  // what a file of 12 digits leaves
  EXPECT_TRUE(recogniseWith(test::puma(), [](Chain& chain) {
    chain.joints[2].axis_W = Vec3(1e-11, 1, 0).normalized();
    chain.joints[5].p_WJ.x() += 1e-11;
  }));
}

}  // namespace
}  // namespace underact::chain
