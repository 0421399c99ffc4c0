#include "core/identify/report.h"

#include <gtest/gtest.h>

namespace underact::identify {
namespace {

Identified someArm() {
  Identified found;
  found.arm = "omni-thesis";
  found.rate_hz = 1000;
  found.places_W = {{0.0, 0.0, 0.06}};
  found.mean_mass_kg = {0.04512, 0.0002};
  found.mean_friction_N = {0.2612, 0.003};
  found.mean_damping_N_s_per_m = {0.001, 0.002};
  found.mass_kg.fill(found.mean_mass_kg);
  found.friction_N.fill(found.mean_friction_N);
  found.damping_N_s_per_m.fill(found.mean_damping_N_s_per_m);
  found.counts_per_turn[0] = Estimate{15280.0, 1e-6};
  found.notes = {{"Nobody pressed."}};
  return found;
}

TEST(Report, AValueHasTheDigitsThatItsUncertaintyAllows) {
  EXPECT_EQ(valueText({"", "", {45.1234, 0.2}}), "45.12");
  EXPECT_EQ(uncertaintyText({"", "", {45.1234, 0.2}}), "0.20");
  EXPECT_EQ(valueText({"", "", {45.1234, 12.0}}), "45");
  EXPECT_EQ(valueText({"", "", {0.26, 1e-9}}), "0.2600");
  EXPECT_EQ(uncertaintyText({"", "", {0.26, 1e-9}}), "< 0.0001");
  EXPECT_EQ(valueText({"", "", {23.59, 0.0}}), "23.59");
  EXPECT_EQ(uncertaintyText({"", "", {23.59, 0.0}}), "");
}

TEST(Report, WhatIsNotToldFromZeroIsBelowSomethingAndNeverRoundedBelowIt) {
  EXPECT_EQ(valueText({"", "", {0.001, 0.0021}}), "below 0.0052");
  EXPECT_EQ(valueText({"", "", {0.00101, 0.0021}}), "below 0.0053");
  EXPECT_EQ(valueText({"", "", {-1.0, 0.5}}), "below 1.00");
}

TEST(Report, TheDifferenceIsAShareOfWhatWasGiven) {
  EXPECT_EQ(differenceText({"", "", {1.02, 0.001}, 1.0}), "+2.00 %");
  EXPECT_EQ(differenceText({"", "", {1.02, 0.001}}), "");
  EXPECT_EQ(differenceText({"", "", {0.001, 0.01}, 0.0}), "");
  EXPECT_EQ(differenceText({"", "", {0.001, 0.01}, 1.0}), "");  // "below" is no number to compare
}

TEST(Report, TheModelHasWhatWasToldAndSaysWhereItComesFrom) {
  sim::Provenance provenance;
  provenance.device = "Touch";
  provenance.date = "2026-11-22";
  const sim::ArmModelFile file = modelFileOf(someArm(), "bench", "Bench", provenance);
  EXPECT_EQ(file.arm.mass_kg, 0.04512);
  EXPECT_EQ(file.arm.friction_N, 0.2612);
  EXPECT_EQ(file.arm.damping_N_s_per_m, 0.0);  // below 0.005
  EXPECT_EQ(file.uncertainty->damping_N_s_per_m, 0.002);
  EXPECT_EQ((*file.arm.counts_per_turn)[0], 15280.0);
  EXPECT_EQ((*file.arm.counts_per_turn)[1], 0.0);
  EXPECT_EQ(file.provenance.places_mm.at(0), Vec3(0.0, 0.0, 60.0));
  EXPECT_EQ(file.provenance.rate_hz, 1000);
  EXPECT_NE(file.arm.provenance.find("Measured on Touch, on 2026-11-22 at 1000 Hz."), std::string::npos);
  const Result<sim::ArmModelFile> back = sim::readArmModel(armModelText(file), "m.json");
  ASSERT_TRUE(static_cast<bool>(back));
  EXPECT_EQ(back.value().arm.mass_kg, file.arm.mass_kg);
}

TEST(Report, OfARealArmComparesWithNothing) {
  const sim::ArmModelFile file = modelFileOf(someArm(), "bench", "Bench", {});
  const std::string real = reportText(someArm(), file, nullptr);
  EXPECT_EQ(real.find("given"), std::string::npos);
  EXPECT_NE(real.find("| Mass | 45.12 | 0.20 | g |\n"), std::string::npos) << real;
  EXPECT_NE(real.find("| Damping | below 0.0050 | 0.0020 | N s/m |\n"), std::string::npos) << real;
  EXPECT_NE(real.find("Not measured: Nobody pressed."), std::string::npos);
  const Given given{*sim::findArmModel("vendor-nominal"), {15280, 1, 1, 1, 1, 1}};
  const std::string simulated = reportText(someArm(), file, &given);
  EXPECT_NE(simulated.find("| Mass | 45.12 | 0.20 | g | 45.0000 | +0.27 % |\n"), std::string::npos) << simulated;
}

}  // namespace
}  // namespace underact::identify
