#include <string>

#include "core/arm/arm_text.h"
#include "core/arm/gravity.h"
#include "core/arm/model.h"
#include "core/arm/urdf.h"
#include "core/base/units.h"
#include "core/chain/kinematics.h"
#include "core/chain/numeric_inverse.h"
#include "tests/support/property.h"

namespace underact::arm {
namespace {

const std::string kHead = R"({"underact_arm": 1, "name": "a", "title": "b", "provenance": "c", )";
const std::string kUnit = "[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]";

std::string tableWith(const std::string& rows, const std::string& more = "") {
  return kHead + "\"dh\": [\n" + rows + "\n], \"X_WB\": " + kUnit + more + "}";
}

/// "LINE KEY: sentence" of all problems; empty: it can be read.
std::string problemsIn(const Result<Model>& read) {
  std::string all;
  if (read) return all;
  for (const Problem& one : read.problems())
    all += std::to_string(one.place.line) + " " + one.place.key + ": " + one.sentence + "\n";
  return all;
}

double maxApart(const chain::Chain& a, const chain::Chain& b) {
  std::uint64_t random = 5;
  double max = a.joints.size() == b.joints.size() ? 0.0 : kInfinity;
  for (int draw = 0; draw < 50; ++draw) {
    const chain::JointValues q = chain::drawnJoints(a, random);
    max = std::max(max, (chain::forward(a, q).matrix() - chain::forward(b, q).matrix()).cwiseAbs().maxCoeff());
  }
  return max;
}

TEST(ArmForms, ClassicRowsByHand) {  // two links of 100 and 50 mm, the second axis turned up by the first row's alpha
  const Result<Model> read =
      readArm(tableWith(R"({"alpha_deg": 90, "a_mm": 100, "d_mm": 20}, {"alpha_deg": 0, "a_mm": 50, "d_mm": 0})",
                        R"(, "convention": "classic")"),
              "a.json");
  ASSERT_TRUE(read) << problemsIn(read);
  const std::array<double, 2> q{0.0, kPi / 2};
  const Pose X_WT = chain::forward(read.value().chain, q);
  EXPECT_LE((X_WT.translation() - Vec3(0.1, 0, 0.07)).norm(), 1e-15);
  const std::array<double, 2> turned{kPi / 2, 0.0};
  EXPECT_LE((chain::forward(read.value().chain, turned).translation() - Vec3(0, 0.15, 0.02)).norm(), 1e-15);
}

TEST(ArmForms, AProductOfExponentialsByHand) {  // a turn about z, then a slide along x at home
  const Result<Model> read = readArm(
      kHead +
          R"("joints": [{"type": "revolute", "axis": [0, 0, 2], "point_mm": [0, 0, 0], "min_deg": -90, "max_deg": 90},
                            {"type": "prismatic", "axis": [1, 0, 0], "min_mm": 0, "max_mm": 200, "name": "boom"}],
                 "X_WT_home": [[1, 0, 0, 100], [0, 1, 0, 0], [0, 0, 1, 10], [0, 0, 0, 1]]})",
      "a.json");
  ASSERT_TRUE(read) << problemsIn(read);
  const std::array<double, 2> q{kPi / 2, 0.05};
  EXPECT_LE((chain::forward(read.value().chain, q).translation() - Vec3(0, 0.15, 0.01)).norm(), 1e-15);
  EXPECT_EQ(read.value().joints[1].name, "boom");
  EXPECT_DOUBLE_EQ(read.value().chain.joints[1].max, 0.2);
  // The table beside it is the same arm.
  const Model& model = read.value();
  EXPECT_LE(maxApart(model.chain, chain::chainFromDh(model.rows, model.X_WB, model.X_NT)), 1e-14);
  EXPECT_TRUE(isWithinLimits(model, q));
  EXPECT_FALSE(isWithinLimits(model, std::array<double, 2>{0.0, 0.25}));
}

TEST(ArmForms, EachMistakeHasItsLineAndTheNearestWord) {
  const auto told = [](const std::string& rows, const std::string& more = "") {
    return problemsIn(readArm(tableWith(rows, more), "a.json"));
  };
  const std::string good = R"({"alpha_deg": 0, "a_mm": 10, "d_mm": 0})";
  EXPECT_EQ(told(good), "");
  EXPECT_EQ(told(good + ",\n" + R"({"alpha_deg": 0, "a_mm": 10, "d_mm": 0, "min_dge": 1})"),
            "3 dh[1].min_dge: The key \"min_dge\" is not known in a row of the DH table. Did you mean \"min_deg\"?\n");
  const std::string far = told(R"({"alpha_deg": 0, "a_mm": 10, "d_mm": 0, "stiffness": 1})");
  EXPECT_NE(far.find("\"min_deg\""), std::string::npos) << far;
  EXPECT_EQ(far.find("\"min_deg\""), far.rfind("\"min_deg\"")) << far;  // each known key once
  EXPECT_NE(told(R"({"type": "prismatic", "alpha_deg": 0, "a_mm": 0, "d_mm": 0, "max_deg": 1})")
                .find("2 dh[0].max_deg: A prismatic joint has its limits in mm: \"max_mm\"."),
            std::string::npos);
  EXPECT_NE(told(R"({"alpha_deg": 0, "a_mm": 0, "d_mm": 0, "max_mm": 1})").find("\"max_deg\""), std::string::npos);
  EXPECT_NE(told(R"({"alpha_deg": 0, "a_mm": 0, "d_mm": 0, "max_deg": 1, "max_rad": 1})").find("already given"),
            std::string::npos);
  EXPECT_NE(told(R"({"type": "screw", "alpha_deg": 0, "a_mm": 0, "d_mm": 0})").find("\"revolute\" or \"prismatic\""),
            std::string::npos);
  EXPECT_NE(told(R"({"alpha_deg": 0, "a_mm": 0, "d_mm": 0, "sensed": false, "driven": true})").find("cannot be driven"),
            std::string::npos);
  EXPECT_NE(told(good, R"(, "X_6T": )" + kUnit).find("\"X_NT\""), std::string::npos);
  EXPECT_NE(told("").find("from one to eight joints; this one has 0"), std::string::npos);
  std::string nine = good;
  for (int row = 1; row < 9; ++row) nine += ", " + good;
  EXPECT_NE(told(nine).find("this one has 9"), std::string::npos);
  EXPECT_NE(told(good, R"(, "joints": [])").find("already given by the table"), std::string::npos);
}

TEST(ArmForms, AHapticArmDrivesItsFirstThreeJoints) {
  const Model& omni = *findModel("omni-thesis");
  for (std::size_t joint = 0; joint < 6; ++joint) {
    EXPECT_EQ(omni.joints[joint].driven, joint < 3);
    EXPECT_TRUE(omni.joints[joint].sensed);
  }
  for (const JointFacts& facts : findModel("puma-560")->joints) EXPECT_TRUE(facts.driven);
}

TEST(ArmForms, EveryShippedArmComesBackFromEveryFormThatCanSayIt) {
  for (const Model& model : models()) {
    SCOPED_TRACE(model.name);
    for (const ArmForm to : {ArmForm::ModifiedDh, ArmForm::Exponentials, ArmForm::Urdf}) {
      const Result<std::string> text = textOf(model, to);
      if (!text) {
        EXPECT_TRUE(model.device) << describe(text.problems().front());
        continue;
      }
      const bool is_urdf = to == ArmForm::Urdf;
      const Result<Model> back = is_urdf ? readUrdf(text.value(), "a.urdf", {}) : readArm(text.value(), "a.json");
      ASSERT_TRUE(back) << problemsIn(back) << text.value();
      EXPECT_LE(maxApart(model.chain, back.value().chain), 1e-14);
      for (std::size_t i = 0; i < model.rows.size(); ++i) {
        const chain::DhRow &one = back.value().rows[i], &given = model.rows[i];
        EXPECT_TRUE(one.min == given.min || std::abs(one.min - given.min) <= 1e-14) << i;  // equal where infinite
        EXPECT_TRUE(one.max == given.max || std::abs(one.max - given.max) <= 1e-14) << i;
        if (!is_urdf) {
          EXPECT_EQ(back.value().joints[i].driven, model.joints[i].driven);
        }
        if (model.masses.empty()) continue;
        EXPECT_LE((back.value().masses[i].p_WC - model.masses[i].p_WC).norm(), 1e-14);
        EXPECT_EQ(back.value().masses[i].mass_kg, model.masses[i].mass_kg);
      }
    }
  }
}

TEST(ArmForms, TheWeightIsTheSlopeOfItsEnergy) {
  const Model& ur = *findModel("ur5e");
  ASSERT_EQ(ur.masses.size(), 6U);
  const Vec3 g(0, 0, -9.80665);
  const auto energyAt = [&](const chain::JointValues& q) {
    std::vector<Pose> links(6, Pose::Identity());
    chain::forward(ur.chain, q, links);
    double energy_J = 0.0;
    for (std::size_t i = 0; i < 6; ++i) energy_J -= ur.masses[i].mass_kg * g.dot(links[i] * ur.masses[i].p_WC);
    return energy_J;
  };
  std::uint64_t random = 3;
  for (int draw = 0; draw < 20; ++draw) {
    const chain::JointValues q = chain::drawnJoints(ur.chain, random);
    const std::vector<double> torques = holdingTorques(ur, std::span(q).first(6), g);
    for (std::size_t i = 0; i < 6; ++i) {
      chain::JointValues up = q, down = q;
      up[i] += 1e-5, down[i] -= 1e-5;
      EXPECT_NEAR(torques[i], (energyAt(up) - energyAt(down)) / 2e-5, 1e-6);
    }
  }
  EXPECT_TRUE(holdingTorques(*findModel("puma-560"), chain::JointValues{}, g).empty());
}

}  // namespace
}  // namespace underact::arm
