#include <array>
#include <chrono>
#include <string>
#include <vector>

#include "core/scene/write.h"
#include "tests/core/scene/random_scene.h"
#include "tests/core/scene/scene_support.h"
#include "tests/fuzz/scene_judge.h"

namespace underact::test {
namespace {

constexpr std::size_t kLongestScene = 20000;  // bytes of a mutated scene
constexpr double kLongestEach_s = 5.0;        // with sanitizers, on a busy machine; a few ms in truth

std::vector<std::string> theScenes() {
  std::vector<std::string> texts;
  for (const std::filesystem::path& file : sceneFiles()) texts.push_back(fileText(file));
  texts.push_back(R"({"underact_scene": 1, "title": "all", "combine": "nearest", "arm": "touch-measured",
 "control": {"law": "PID", "kp_N_per_mm": [1, 2, 3], "kd_N_s_per_mm": 0.25, "ki_N_per_mm_s": [4, 5, 6],
             "anisotropy": "weighted", "space": "cartesian",
             "velocity": {"filter": "adaptive_window", "window": 12, "noise_mm": 0.2}, "passivity": "control"},
 "constraints": [{"type": "box", "center_mm": [1, 2, 3], "size_mm": [4, 5, 6], "side": "both",
                  "R_WB": [[0, -1, 0], [1, 0, 0], [0, 0, 1]], "control": {"kp_N_per_mm": 0,
                  "velocity": {"filter": "kalman", "noise_mm": 0.02, "acceleration_mm_per_s2": 1e4}}},
                 {"name": "\u00e4\ud83d\ude00\n", "type": "cylinder", "point_mm": [-0, 1e-300, 1e5], "axis": [1e300, 0, 1],
                  "radius_mm": 1e-9, "side": "inside"}]})");
  return texts;
}

/// One text made of others by a seed: bytes, tokens, numbers, cuts, splices, nests.
class SceneMutator {
 public:
  explicit SceneMutator(Seed seed) : random_(seed), seeds_(theScenes()) {}

  std::string next() {
    std::string text = any(seeds_);
    for (std::size_t count = 1 + random_.below(4); count > 0; --count) mutate(text);
    if (text.size() > kLongestScene) text.resize(kLongestScene);
    return text;
  }

 private:
  template <class List>
  typename List::value_type any(const List& list) {
    return list[random_.below(list.size())];
  }
  std::size_t placeIn(const std::string& text) { return random_.below(text.size() + 1); }

  void mutate(std::string& text) {
    switch (random_.below(9)) {
      case 0:
        return changeByte(text);
      case 1:
        return insertToken(text);
      case 2:
      case 3:
        return replaceNumber(text);
      case 4:
        text.resize(placeIn(text));
        return;
      case 5:
        return splice(text);
      case 6:
        return nest(text);
      case 7:
        return replaceText(text);
      default:
        return repeatSpan(text);
    }
  }

  void changeByte(std::string& text) {
    if (text.empty()) return;
    char& byte = text[random_.below(text.size())];
    byte = random_.below(2) == 0 ? static_cast<char>(random_.bits())
                                 : static_cast<char>(static_cast<unsigned char>(byte) ^ (1U << random_.below(8)));
  }

  void insertToken(std::string& text) {
    static const std::array<const char*, 28> kTokens{"{",
                                                     "}",
                                                     "[",
                                                     "]",
                                                     ",",
                                                     ":",
                                                     "\"",
                                                     "null",
                                                     "true",
                                                     "false",
                                                     "NaN",
                                                     "-",
                                                     "1e999",
                                                     "\\u",
                                                     "\\ud800",
                                                     "\xEF\xBB\xBF",
                                                     "\xED\xA0\x80",
                                                     "\xC3",
                                                     "//",
                                                     "\n",
                                                     "\t",
                                                     "\"side\": \"inside\",",
                                                     "\"radius_mm\": 1,",
                                                     "\"type\": \"mesh\",",
                                                     "\"control\": {},",
                                                     "\"law\": \"PD\",",
                                                     "\"\": [],",
                                                     "\"constraints\": [],"};
    text.insert(placeIn(text), any(kTokens));
  }

  void replaceNumber(std::string& text) {
    static const std::array<const char*, 24> kNumbers{"0",
                                                      "-0",
                                                      "1",
                                                      "-1",
                                                      "0.0",
                                                      "1e6",
                                                      "1000000.0000001",
                                                      "-1e6",
                                                      "1e-320",
                                                      "1e-400",
                                                      "1e308",
                                                      "1e400",
                                                      "-1e999",
                                                      "01",
                                                      "1.",
                                                      ".5",
                                                      "+1",
                                                      "1e",
                                                      "0.1e-5",
                                                      "4503599627370497.5",
                                                      "1e12",
                                                      "1e-100",
                                                      "123456789012345678901234567890",
                                                      "null"};
    replaceRun(text, "0123456789.eE+-", any(kNumbers));
  }

  void replaceText(std::string& text) {
    static const std::array<const char*, 28> kWords{
        "point",   "sphere",    "line",      "plane",  "circle",      "cylinder", "box",       "mesh",    "P",     "PD",
        "PID",     "radius_mm", "center_mm", "normal", "kp_N_per_mm", "weighted", "euclidean", "inside",  "joint", "",
        "\\u0000", "name",      "velocity",  "filter", "raw",         "low_pass", "kalman",    "noise_mm"};
    std::size_t start = text.find('"', placeIn(text));
    if (start == std::string::npos) start = text.find('"');
    if (start == std::string::npos) return;
    const std::size_t end = text.find('"', start + 1);
    if (end != std::string::npos) text.replace(start + 1, end - start - 1, any(kWords));
  }

  /// Puts other in the place of the first run of these characters after a random place.
  void replaceRun(std::string& text, const char* characters, const char* other) {
    std::size_t start = text.find_first_of(characters, placeIn(text));
    if (start == std::string::npos) start = text.find_first_of(characters);
    if (start == std::string::npos) return;
    const std::size_t end = std::min(text.find_first_not_of(characters, start), text.size());
    text.replace(start, end - start, other);
  }

  void splice(std::string& text) {
    const std::string other = any(seeds_);
    const std::size_t from = placeIn(other);
    const std::size_t length = random_.below(other.size() - from + 1);
    const std::size_t at = placeIn(text);
    text.replace(at, random_.below(std::min<std::size_t>(text.size() - at, 200) + 1), other.substr(from, length));
  }

  void nest(std::string& text) {
    const std::size_t depth = random_.below(200);
    const bool closed = random_.below(2) == 0;
    std::string inside;
    for (std::size_t i = 0; i < depth; ++i) inside += random_.below(3) == 0 ? "{\"a\":" : "[";
    if (closed) inside += "0";
    for (std::size_t i = inside.size(); closed && i > 0; --i) {
      if (inside[i - 1] == '[') inside += ']';
      if (inside[i - 1] == '{') inside += '}';
    }
    replaceRun(text, "0123456789.", inside.c_str());
  }

  void repeatSpan(std::string& text) {
    const std::size_t from = placeIn(text);
    const std::string span = text.substr(from, random_.below(120));
    for (std::size_t times = random_.below(40); times > 0 && text.size() < kLongestScene; --times)
      text.insert(from, span);
  }

  Random random_;
  std::vector<std::string> seeds_;
};

TEST(SceneMutations, EachIsRefusedWithPlacesOrLoadsWhole) {
  using Clock = std::chrono::steady_clock;
  SceneMutator mutator(Seed{20070601});
  const int count = sweep(5000, 100000);
  int accepted = 0;
  for (int i = 0; i < count; ++i) {
    const std::string text = mutator.next();
    const Clock::time_point start = Clock::now();
    ASSERT_EQ(judgeScene(text), "") << "mutation " << i << ":\n" << text;
    ASSERT_LT(std::chrono::duration<double>(Clock::now() - start).count(), kLongestEach_s) << "mutation " << i << ":\n"
                                                                                           << text;
    accepted += isAccepted(text) ? 1 : 0;
  }
  // A mutator that only makes rubbish, or nothing new, would prove nothing.
  EXPECT_GT(accepted, count / 50);
  EXPECT_LT(accepted, count / 2);
  RecordProperty("accepted", accepted);
}

TEST(SceneMutations, EveryPrefixOfASceneIsRefused) {
  for (const std::string& text : theScenes()) {
    const std::size_t end = text.find_last_of('}');
    for (std::size_t length = 0; length <= end; ++length) {
      const std::string_view prefix = std::string_view(text).substr(0, length);
      ASSERT_EQ(judgeScene(prefix), "") << prefix;
      ASSERT_FALSE(isAccepted(prefix)) << prefix;
    }
  }
}

TEST(SceneMutations, WhatKeepsEveryRuleTicksHoweverOddItsNumbers) {
  RandomScene random(Seed{20071203});
  for (int draw = 0; draw < sweep(500, 20'000); ++draw) {
    const std::string text = scene::writeScene(random.next());
    ASSERT_TRUE(isAccepted(text)) << text;
    ASSERT_EQ(judgeScene(text), "") << text;
  }
}

TEST(SceneMutations, ReadsLargeScenesInTime) {
  const std::string head = R"({"underact_scene": 1, "title": ")";
  const std::string tail = R"(", "constraints": [{"type": "point", "position_mm": [0, 0, 0]}]})";
  const auto many = [](const char* text, std::size_t count) {
    std::string all;
    for (std::size_t i = 0; i < count; ++i) all += text;
    return all;
  };
  const std::size_t large = 1U << 20U;
  EXPECT_EQ(judgeScene(head + std::string(large, 'x') + tail), "");
  EXPECT_EQ(judgeScene(head + many("\\u0041", large / 8) + tail), "");
  EXPECT_EQ(judgeScene(std::string(large, '[')), "");
  EXPECT_EQ(judgeScene(std::string(large, '1')), "");
  EXPECT_EQ(judgeScene("[" + many("1e999,", large / 8) + "1]"), "");
  EXPECT_EQ(judgeScene("{" + many("\"a\":1,", large / 8) + "\"b\":1}"), "");
  EXPECT_EQ(judgeScene("{\"" + std::string(large, 'k') + "\":1}"), "");
  EXPECT_EQ(judgeScene(std::string(large, '\n')), "");
  EXPECT_EQ(judgeScene(R"({"constraints": [)" + many("{},", large / 16) + "{}]}"), "");
}

}  // namespace
}  // namespace underact::test
