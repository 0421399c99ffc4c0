#include "device/haply/messages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "core/arm/haply_frame.h"
#include "device/haply/address.h"
#include "tests/support/haply_service.h"
#include "tests/support/mutate.h"
#include "tests/support/property.h"

namespace underact::device::haply {
namespace {

Told toldBy(const std::string& text, Told told = {}) {
  EXPECT_EQ(hearMessage(text, told), Heard::Place) << text;
  return told;
}

const char* const kBare =
    R"({"inverse3": [{"device_id": "A", "state": {"cursor_position": {"x": 1, "y": 2, "z": 3}}}]})";

}  // namespace

TEST(HaplyFrame, XIsToTheRightYIsAwayAndZIsUp) {
  EXPECT_EQ(arm::haplyPlaceFromWorkspace(Vec3(0.01, 0.02, 0.03)), Vec3(0.01, -0.12 - 0.03, 0.15 + 0.02));
  for (const Vec3& p_W : test::pointsInBox(0.2, 50, test::Seed{35}))
    EXPECT_LT((arm::workspacePlaceFromHaply(arm::haplyPlaceFromWorkspace(p_W)) - p_W).norm(), 1e-15);
  EXPECT_EQ(arm::haplyFromWorkspace().determinant(), 1.0);
}

TEST(HaplyMessages, TheFirstOneHasAllAndALaterOneMayLeaveOut) {
  const test::HaplyService service;
  Told told = toldBy(service.stateText(true));
  EXPECT_EQ(told.id, "04C3");
  EXPECT_EQ(told.type, "inverse3x");
  EXPECT_EQ(told.firmware, "8C20");
  EXPECT_TRUE(told.R_HT.has_value());
  EXPECT_EQ(told.angles_deg, Vec3(-89.5, 122.25, -22.75));
  told =
      toldBy(R"({"inverse3": [{"device_id": "04C3", "state": {"cursor_position": {"x": 1, "y": 2, "z": 3}}}]})", told);
  EXPECT_EQ(told.p_HT, Vec3(1, 2, 3));
  EXPECT_EQ(told.type, "inverse3x");
  EXPECT_TRUE(told.R_HT.has_value()) << "it was not said that the grip is gone";
  EXPECT_TRUE(told.is_calibrated && told.has_power && told.is_ready);
}

TEST(HaplyMessages, TakesTheNamedOneOfSeveralArms) {
  const std::string both =
      R"({"inverse3": [{"device_id": "A", "state": {"cursor_position": {"x": 1, "y": 0, "z": 0}}},
                       {"device_id": "B", "state": {"cursor_position": {"x": 2, "y": 0, "z": 0}}}]})";
  EXPECT_EQ(toldBy(both).id, "A");
  Told told;
  told.id = "B";
  EXPECT_EQ(toldBy(both, told).p_HT.x(), 2.0);
  told.id = "C";
  EXPECT_EQ(hearMessage(both, told), Heard::Missing);
  EXPECT_EQ(told.ids, (std::vector<std::string>{"A", "B"}));
}

TEST(HaplyMessages, AGripWithACableHasOneButton) {
  Told told = toldBy(
      R"({"inverse3": [{"device_id": "A", "state": {"cursor_position": {"x": 0, "y": 0, "z": 0}}}],
          "verse_grip": [{"device_id": "G", "state": {"button": true, "orientation": {"w": 0, "x": 0, "y": 0, "z": 1}}}]})");
  EXPECT_EQ(told.buttons, 1U);
  EXPECT_EQ((*told.R_HT)(0, 0), -1.0);
  told = toldBy(
      R"({"inverse3": [{"device_id": "A", "state": {"cursor_position": {"x": 0, "y": 0, "z": 0}}}],
          "custom_verse_grip": [{"device_id": "G", "state": {"buttons": {"a": false, "b": true, "c": true}}}]})",
      told);
  EXPECT_EQ(told.buttons, 6U);
}

TEST(HaplyMessages, IgnoresInvalidMessages) {
  const Told before = toldBy(kBare);
  for (const char* const text :
       {"", "{", "7", "[]", R"({"inverse3": {}})", R"({"inverse3": [{"device_id": "A"}]})",
        R"({"inverse3": [{"device_id": "A", "state": {"cursor_position": {"x": 1, "y": 2}}}]})",
        R"({"inverse3": [{"device_id": "A", "state": {"cursor_position": {"x": "1", "y": 2, "z": 3}}}]})",
        R"({"inverse3": [{"device_id": "A", "state": {"cursor_position": {"x": 1e999, "y": 2, "z": 3}}}]})",
        R"({"inverse3": [{"device_id": "A", "state": {"cursor_position": {"x": 11, "y": 2, "z": 3}}}]})"}) {
    Told told = before;
    EXPECT_EQ(hearMessage(text, told), Heard::Wrong) << text;
    EXPECT_EQ(told.p_HT, before.p_HT);
    EXPECT_EQ(told.id, before.id);
  }
  Told told = before;
  EXPECT_EQ(hearMessage(R"({"error": "no"})", told), Heard::Nothing);
  EXPECT_EQ(hearMessage(R"({"inverse3": []})", told), Heard::Missing);
}

TEST(HaplyMessages, WhateverComesAPlaceIsFiniteAndNear) {
  const test::HaplyService service;
  const std::string good = service.stateText(true);
  test::Random random(test::Seed{3501});
  for (int round = test::sweep(2000, 200'000); round > 0; --round) {
    std::string text = good;
    for (int change = 0; change < 3; ++change)
      text[static_cast<std::size_t>(random.between(0.0, static_cast<double>(text.size())))] =
          static_cast<char>(random.between(1.0, 127.0));
    Told told;
    if (hearMessage(text, told) != Heard::Place) continue;
    ASSERT_TRUE(told.p_HT.norm() < 10.0) << text;
    const Mat3 R_HT = told.R_HT.value_or(Mat3::Identity());
    ASSERT_LT((R_HT * R_HT.transpose() - Mat3::Identity()).norm(), 1e-9) << text;
  }
}

TEST(HaplyMessages, AForceIsAVectorFromV35OnAndValuesBefore) {
  EXPECT_EQ(formOf(R"({"project_version": "3.5.0"})"), Form::Vector);
  EXPECT_EQ(formOf(R"({"project_version": "3.10"})"), Form::Vector);
  EXPECT_EQ(formOf(R"({"project_version": "4.0"})"), Form::Vector);
  for (const char* const old : {"", "{}", "[]", R"({"project_version": "3.1.4"})", R"({"project_version": 4})"})
    EXPECT_EQ(formOf(old), Form::Values) << old;
  EXPECT_NE(forceText("A", Form::Vector, Vec3(1, 2, 3)).find(R"("vector": {"x": 1, "y": 2, "z": 3})"),
            std::string::npos)
      << forceText("A", Form::Vector, Vec3(1, 2, 3));
  EXPECT_NE(forceText("A", Form::Values, Vec3(1, 2, 3)).find(R"("values": {"x": 1)"), std::string::npos);
}

// The soak reads them with the types of the published crate, from the file that it names: tests/python/test_haply.py.
TEST(HaplyMessages, AreThoseOfThePublishedCrate) {
  test::HaplyService service;
  const std::string full = service.stateText(true), state = service.stateText(false);
  service.unplugArm(true);
  const std::vector<std::pair<const char*, std::string>> messages{
      {"full", full},
      {"state", state},
      {"state", service.stateText(false)},
      {"frame", greetingText(Form::Vector)},
      {"frame", forceText("04C3", Form::Vector, Vec3(0.5, -1e-9, 0.0))}};
  Told told;
  const std::array<Heard, 5> heard{Heard::Place, Heard::Place, Heard::Missing, Heard::Nothing, Heard::Wrong};
  const char* const path = std::getenv("UNDERACT_HAPLY_MESSAGES");
  std::ofstream file(path == nullptr ? "" : path);
  for (std::size_t index = 0; index < messages.size(); ++index) {
    auto [kind, text] = messages[index];
    EXPECT_EQ(hearMessage(text, told), heard[index]) << text;  // a frame with a force tells no place
    std::replace(text.begin(), text.end(), '\n', ' ');
    file << kind << ' ' << text << '\n';
  }
  EXPECT_EQ(path != nullptr, file.good());
}

TEST(HaplyAddress, HasDefaultsAndMayNameTheArm) {
  EXPECT_EQ(readPlace("").value().text(), "127.0.0.1:10001");
  EXPECT_EQ(readPlace("lab-pc").value().text(), "lab-pc:10001");
  EXPECT_EQ(readPlace("[::1]").value().text(), "[::1]:10001");
  EXPECT_EQ(readPlace("[::1]:7/B").value().text(), "[::1]:7");
  EXPECT_EQ(readPlace("10.0.0.2:99/04C3").value().id, "04C3");
  EXPECT_EQ(readPlace("/04C3").value().text(), "127.0.0.1:10001");
  for (const char* const wrong : {"a b", "h:0", "h:70000", "h:1/", "h:1/a/b", "h:1/\"", "http://h:1"})
    EXPECT_FALSE(readPlace(wrong)) << wrong;
}

}  // namespace underact::device::haply
