#include "core/sim/arm_model_file.h"

#include <gtest/gtest.h>

#include "core/arm/preset.h"
#include "core/sim/plant.h"

namespace underact::sim {
namespace {

ArmModelFile measured() {
  ArmModelFile file;
  file.arm.name = "bench-3";
  file.arm.title = "The arm on \"bench\" 3";
  file.arm.mass_kg = 0.0451234567890123;
  file.arm.friction_N = 0.1;
  file.arm.damping_N_s_per_m = 1.0 / 3.0;
  file.arm.counts_per_turn = arm::EncoderCounts{15280.0, 15399.5, 15419.0, 0.0, 4915.0, 4915.0};
  file.provenance = {
      "Touch", "A-17", "2026-11-22", "underact 0.1.0", "Swings.", 1000, {{0.0, 0.0, 60.0}, {1.0, 2.0, 3.0}}};
  file.uncertainty = ModelUncertainty{1e-5, 2e-4, 3e-3};
  return file;
}

std::string sentences(const Problems& problems) {
  std::string all;
  for (const Problem& problem : problems) all += describe(problem) + "\n";
  return all;
}

TEST(ArmModelFile, ReadsBackWhatWasWritten) {
  const ArmModelFile file = measured();
  const Result<ArmModelFile> read = readArmModel(armModelText(file), "m.json");
  ASSERT_TRUE(static_cast<bool>(read)) << sentences(read.problems());
  const ArmModelFile& back = read.value();
  EXPECT_EQ(back.arm.name, file.arm.name);
  EXPECT_EQ(back.arm.title, file.arm.title);
  EXPECT_EQ(back.arm.mass_kg, file.arm.mass_kg);
  EXPECT_EQ(back.arm.friction_N, file.arm.friction_N);
  EXPECT_EQ(back.arm.damping_N_s_per_m, file.arm.damping_N_s_per_m);
  EXPECT_EQ(back.arm.counts_per_turn, file.arm.counts_per_turn);
  EXPECT_TRUE(back.arm.encoders);
  EXPECT_EQ(back.provenance.serial, "A-17");
  EXPECT_EQ(back.provenance.rate_hz, 1000);
  EXPECT_EQ(back.provenance.places_mm, file.provenance.places_mm);
  EXPECT_EQ(back.uncertainty->damping_N_s_per_m, 3e-3);
  EXPECT_EQ(armModelText(back), armModelText(file));
  EXPECT_EQ(back.arm.provenance, "Measured on Touch, serial A-17, on 2026-11-22 at 1000 Hz by underact 0.1.0. Swings.");
}

TEST(ArmModelFile, AnArmWithoutEncodersSaysSo) {
  ArmModelFile file = measured();
  file.arm.encoders = false;
  file.arm.counts_per_turn.reset();
  const Result<ArmModelFile> read = readArmModel(armModelText(file), "m.json");
  ASSERT_TRUE(static_cast<bool>(read));
  EXPECT_FALSE(read.value().arm.encoders);
  EXPECT_FALSE(read.value().arm.counts_per_turn);
}

TEST(ArmModelFile, TellsEveryProblemAtOnceWithItsPlace) {
  const Result<ArmModelFile> read = readArmModel(R"({
  "underact_arm_model": 2,
  "name": "x", "title": 3,
  "provenance": {"device": "d", "rate_hz": 0.5, "datum": "x"},
  "mass_kg": -1, "friction_n": 0.1,
  "counts_per_turn": [1, 2, 3],
  "uncertainty": {"mass_kg": -2}
})",
                                                 "m.json");
  ASSERT_FALSE(static_cast<bool>(read));
  const std::string all = sentences(read.problems());
  for (const char* part :
       {"m.json:2:25: error: underact_arm_model: ", "m.json:3:25: error: title: ", "error: provenance.rate_hz: ",
        "error: provenance.datum: ", "\"date\"", "m.json:5:14: error: mass_kg: ", "error: friction_n: ", "friction_N",
        "error: counts_per_turn: ", "error: uncertainty.mass_kg: "})
    EXPECT_NE(all.find(part), std::string::npos) << part << "\n" << all;
}

TEST(ArmModelFile, NumbersThatAreNoneAreRefused) {
  std::string text = armModelText(measured());
  for (const auto& [from, to] : {std::pair{"0.1,\n", "1e999,\n"}, {"0.1,\n", "\"0.1\",\n"}, {"0.1,\n", "null,\n"}}) {
    std::string wrong = text;
    wrong.replace(wrong.find(from), std::string(from).size(), to);
    EXPECT_FALSE(readArmModel(wrong, "m.json")) << wrong;
  }
  EXPECT_FALSE(readArmModel("[]", "m.json"));
  EXPECT_FALSE(readArmModel("", "m.json"));
  EXPECT_FALSE(readArmModelFile("/nowhere/at_all.json"));
}

TEST(ArmModelFile, IsChosenByNameOrByFile) {
  EXPECT_EQ(chooseArmModel("vendor-nominal").value().mass_kg, 0.045);
  const Result<ArmModel> none = chooseArmModel("vendor");
  ASSERT_FALSE(static_cast<bool>(none));
  EXPECT_NE(none.problems()[0].sentence.find("\"vendor-nominal\""), std::string::npos);
  EXPECT_FALSE(chooseArmModel("./nowhere.json"));
}

TEST(ArmModel, CountsThatWereNotMeasuredAreThoseOfThePreset) {
  const arm::Preset& preset = *arm::findPreset("omni-thesis");
  const Plant plant = makePlant(preset, measured().arm, {});
  EXPECT_EQ(plant.arm.counts_per_turn[1], 15399.5);
  EXPECT_EQ(plant.arm.counts_per_turn[3], preset.counts_per_turn[3]);
}

}  // namespace
}  // namespace underact::sim
