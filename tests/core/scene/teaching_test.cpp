#include "core/scene/teaching.h"

#include <map>

#include "core/json/json.h"
#include "core/scene/write.h"
#include "tests/core/scene/scene_support.h"
#include "tests/support/mutate.h"

namespace underact::scene {
namespace {

std::string sceneThatTeaches(const std::string& teach) {
  return "{\"underact_scene\": 1, \"title\": \"t\",\n\"teach\": " + teach +
         ",\n\"constraints\": [{\"type\": \"point\", \"position_mm\": [0, 0, 0]}]}";
}

const std::string kWhole =
    sceneThatTeaches(R"({"group": "walls", "feel": "firm", "try": "push", "equation": "$f = k_p (q - p)$"})");

TEST(Teaching, IsReadBesideTheScene) {
  EXPECT_EQ(test::problemsIn(kWhole), std::vector<std::string>{});
  EXPECT_EQ(teachingIn(kWhole), (Teaching{Group::Walls, "firm", "push", "$f = k_p (q - p)$"}));
  EXPECT_EQ(teachingIn(sceneThatTeaches(R"({"group": "curves"})")), (Teaching{Group::Curves, "", "", ""}));
  EXPECT_EQ(teachingIn(test::sceneWith(R"({"type": "point", "position_mm": [0, 0, 0]})")), std::nullopt);
  EXPECT_EQ(teachingIn("no JSON"), std::nullopt);
  EXPECT_EQ(teachingOf("/no/such/file.json"), std::nullopt);
}

TEST(Teaching, EveryProblemIsToldWithItsPlace) {
  const std::string text = sceneThatTeaches(R"({"group": "wall", "feel": 7, "equatoin": "push"})");
  EXPECT_EQ(
      test::joined(test::problemsIn(text)),
      "2:20: teach.group: This must be \"shapes\", \"walls\", \"orientation\", \"robots\", \"meshes\", \"curves\", "
      "\"stability\" or \"arms\"; here it is \"wall\".\n"
      "2:36: teach.feel: This must be text in double quotes; here it is a number.\n"
      "2:39: teach.equatoin: The key \"equatoin\" is not known in what a scene teaches. Did you mean \"equation\"?\n");
  EXPECT_EQ(teachingIn(text), std::nullopt);
  EXPECT_EQ(test::joined(test::problemsIn(sceneThatTeaches("{}"))),
            "2:10: teach.group: The key \"group\" is missing; what a scene teaches needs it.\n");
  EXPECT_EQ(test::problemsIn(sceneThatTeaches("[]")).size(), 1u);
}

TEST(Teaching, IsWrittenAndReadsBack) {
  const Description scene = readScene(kWhole, "f").value();
  const Teaching teaching{Group::Stability, "a \"quote\"", "line\nend", "$\\frac{1}{2}$"};
  const std::string text = writeScene(scene, teaching);
  EXPECT_EQ(test::problemsIn(text), std::vector<std::string>{});
  EXPECT_EQ(teachingIn(text), teaching);
  EXPECT_EQ(teachingIn(writeScene(scene)), std::nullopt);  // what is run says nothing of it
}

TEST(Teaching, MutatedTextsAreReadOrRefusedAndNothingElse) {
  const char* const tokens[] = {"{", "}", "[", "\"", "null", "\"teach\": ", "\"group\"", "\\u0000", "$", "1e999"};
  test::Random random(test::Seed{20261123});
  int read = 0;
  for (int round = 0; round < 20'000; ++round) {
    const std::string text = test::mutated(random, kWhole, tokens);
    const std::optional<Teaching> teaching = teachingIn(text);
    if (!test::problemsIn(text).empty()) continue;
    ++read;
    const Description scene = readScene(text, "f").value();
    ASSERT_EQ(teachingIn(writeScene(scene, teaching)), teaching) << text;
  }
  EXPECT_GT(read, 50);
}

TEST(Teaching, EachShippedSceneSaysWhatToFeelWhatToTryAndItsEquation) {
  std::map<Group, int> groups;
  for (const std::filesystem::path& file : test::sceneFiles()) {
    const std::optional<Teaching> teaching = teachingOf(file.string());
    ASSERT_TRUE(teaching) << file;
    EXPECT_GE(teaching->feel.size(), 20u) << file;
    EXPECT_GE(teaching->try_this.size(), 20u) << file;
    EXPECT_LE(teaching->feel.size() + teaching->try_this.size(), 300u) << file << ": it has to fit on a visitor's card";
    EXPECT_EQ(std::count(teaching->equation.begin(), teaching->equation.end(), '$') % 2, 0) << file;
    EXPECT_NE(teaching->equation.find('$'), std::string::npos) << file;
    ++groups[teaching->group];
  }
  EXPECT_EQ(groups.size(), std::size(kGroupWords));
}

TEST(Teaching, TheSchemaHasTheSameKeysAndWords) {
  const std::string path = std::string(UNDERACT_SOURCE) + "/scenes/scene.schema.json";
  const json::Value root = json::parse(test::fileText(path), path).value();
  const json::Value& teach = *root.find("properties")->find("teach");
  EXPECT_EQ(teach.find("properties")->keys, (std::vector<std::string>{"group", "feel", "try", "equation"}));
  std::vector<std::string> words, wanted;
  for (const json::Value& word : teach.find("properties")->find("group")->find("enum")->items)
    words.push_back(word.text);
  for (const auto& word : kGroupWords) wanted.emplace_back(word.word);
  EXPECT_EQ(words, wanted);
}

}  // namespace
}  // namespace underact::scene
