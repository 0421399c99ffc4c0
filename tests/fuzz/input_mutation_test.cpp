// Maps of hands nobody would write, and reports no 3D mouse would send.
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "device/input/default_maps.h"
#include "device/input/map_file.h"
#include "device/input/space_mouse.h"
#include "tests/support/mutate.h"
#include "tests/support/property.h"

namespace underact::test {
namespace {

namespace input = device::input;

std::vector<std::string> theMaps() {
  std::vector<std::string> texts;
  input::DeviceState controller, mouse;
  input::describeController(controller);
  input::describeSpaceMouse(mouse, 22);
  texts.push_back(input::mapText({"Controller", "030000005e0400008e02000010010000", controller.default_value}));
  texts.push_back(input::mapText({"SpaceMouse Pro", "3d-SpaceMouse Pro", mouse.default_value}));
  texts.emplace_back(R"({"underact_hand_map": 1, "id": "x", "ways": {"up": {"triggers": [5, null]}}})");
  return texts;
}

std::string mutatedMap(Random& random, const std::vector<std::string>& texts) {
  static const std::array<const char*, 20> kTokens{"1e308", "-1",   "1e-400", "nan",  "null",      "true",        "[",
                                                   "]",     "{",    "}",      ",",    "\"id\"",    "99",          "0.5",
                                                   "\"",    "\\u0", "[1,2]",  "\xC3", "999999999", "\"axis\": 0,"};
  std::string text = texts[random.below(texts.size())];
  return test::mutated(random, std::move(text), kTokens);
}

/// Empty: it was refused with sentences, or gives a map that any readings move no faster than it may.
std::string judgeMap(const std::string& text, bool& accepted) {
  const Result<input::MapFile> read = input::readMap(text, "fuzz.json");
  accepted = static_cast<bool>(read);
  if (!read) {
    if (read.problems().empty()) return "Refused with no problem.";
    for (const Problem& problem : read.problems()) {
      if (problem.sentence.size() < 10) return "No sentence: " + describe(problem);
      if (problem.sentence.pattern().empty()) return "No other language can say: " + describe(problem);
    }
    return {};
  }
  const input::Map& map = read.value().map;
  input::Readings readings;
  readings.axes = input::kMaxAxes;
  readings.buttons = input::kMaxButtons;
  readings.axis.fill(1.0);
  readings.pressed = 0x5555555555555555U;
  const input::Motion motion = input::motionOf(map, readings, {{true, true, true, true, true, true}});
  if (!(motion.v_WT.cwiseAbs().maxCoeff() <= input::kFastest_m_per_s + 1e-12)) return "Too fast.";
  if (!(motion.w_WT_W.cwiseAbs().maxCoeff() <= input::kFastest_rad_per_s + 0.01)) return "Turns too fast.";
  if (!input::readMap(input::mapText(read.value()), "again.json"))
    return "What was read is not written so that it can be read.";
  return {};
}

TEST(HandMapMutations, EachIsRefusedWithSentencesOrMovesWithinBounds) {
  Random random(Seed{20071109});
  const std::vector<std::string> texts = theMaps();
  const int count = sweep(20'000, 400'000);
  int taken = 0;
  for (int i = 0; i < count; ++i) {
    const std::string text = mutatedMap(random, texts);
    bool accepted = false;
    ASSERT_EQ(judgeMap(text, accepted), "") << "mutation " << i << ":\n" << text;
    taken += accepted ? 1 : 0;
  }
  EXPECT_GT(taken, count / 100);  // rubbish alone would prove nothing
  EXPECT_LT(taken, count * 3 / 4);
}

TEST(HandMapMutations, EveryPrefixIsWell) {
  for (const std::string& text : theMaps()) {
    bool accepted = false;
    for (std::size_t length = 0; length <= text.size(); ++length)
      ASSERT_EQ(judgeMap(text.substr(0, length), accepted), "") << length;
    EXPECT_TRUE(accepted);
  }
}

TEST(SpaceMouseMutations, AnyBytesGiveAxesWithinTheirWay) {
  Random random(Seed{20071110});
  input::Readings readings;
  for (int i = 0; i < sweep(200'000, 5'000'000); ++i) {
    std::vector<std::uint8_t> report(random.below(70));
    for (std::uint8_t& byte : report) byte = static_cast<std::uint8_t>(random.bits());
    if (!report.empty() && random.below(2) == 0) report[0] = static_cast<std::uint8_t>(random.below(5));
    input::readSpaceMouseReport(report, readings);
    ASSERT_EQ(readings.axes, 6);
    for (const double axis : readings.axis) ASSERT_LE(std::abs(axis), 1.0);
  }
}

}  // namespace
}  // namespace underact::test
