#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "core/arm/arm_text.h"
#include "core/arm/urdf.h"
#include "core/chain/inverse.h"
#include "tests/support/property.h"

namespace underact::arm {
namespace {

using test::Random;

/// Words of both formats, some of them where they do harm.
const std::vector<std::string> kWords{"\"type\": \"prismatic\"",
                                      "revolute",
                                      "classic",
                                      "\"joints\"",
                                      "\"axis\": [0, 0, 0]",
                                      "null",
                                      "1e308",
                                      "-1e308",
                                      "1e-320",
                                      "0",
                                      "nan",
                                      "\"min_deg\": 5",
                                      "[[",
                                      "]",
                                      "}",
                                      "{",
                                      "<joint",
                                      "</joint>",
                                      "<link name=\"x\"/>",
                                      "<mimic/>",
                                      "floating",
                                      "<!DOCTYPE a>",
                                      "&#0;",
                                      "&lt;",
                                      "<![CDATA[",
                                      "-->",
                                      "<!--",
                                      "xyz=\"1 2 3\"",
                                      "rpy=\"9e9 0 0\"",
                                      "\"",
                                      "'",
                                      "\xff",
                                      "/>"};

std::string mutated(std::string text, Random& random) {
  const std::size_t changes = 1 + random.below(6);
  for (std::size_t change = 0; change < changes && !text.empty(); ++change) {
    const std::size_t at = random.below(text.size()), far = std::min(text.size() - at, 1 + random.below(40));
    switch (random.below(6)) {
      case 0:
        text[at] = static_cast<char>(random.below(256));
        break;
      case 1:
        text.erase(at, far);
        break;
      case 2:
        text.insert(at, text.substr(random.below(text.size()), far));
        break;
      case 3:
        text.insert(at, kWords[random.below(kWords.size())]);
        break;
      case 4:
        text.replace(at, far, kWords[random.below(kWords.size())]);
        break;
      default:
        if (text[at] >= '0' && text[at] <= '9') text[at] = static_cast<char>('0' + random.below(10));
        break;
    }
  }
  return text;
}

/// What reads is an arm that everything can be asked of; what does not has its problems, each a sentence.
void expectSound(const Result<Model>& read) {
  if (!read) {
    ASSERT_FALSE(read.problems().empty());
    for (const Problem& problem : read.problems()) ASSERT_FALSE(problem.sentence.empty());
    return;
  }
  const Model& model = read.value();
  const std::size_t count = model.chain.joints.size();
  ASSERT_TRUE(count >= 1 && count <= kMostJoints);
  ASSERT_EQ(model.rows.size(), count);
  ASSERT_EQ(model.joints.size(), count);
  ASSERT_TRUE(model.masses.empty() || model.masses.size() == count);
  const std::vector<double> home(count, 0.1);
  const Pose X_WT = chain::forward(model.chain, home);
  ASSERT_TRUE(X_WT.matrix().allFinite());
  const chain::Inverse inverse = chain::inverseOf(model.chain);
  const chain::InverseSolutions found = chain::solveAll(inverse, X_WT);
  for (std::size_t i = 0; i < found.count; ++i) {
    for (std::size_t joint = 0; joint < count; ++joint) ASSERT_TRUE(std::isfinite(found.all[i].q[joint]));
  }
  for (const ArmForm form : {ArmForm::ModifiedDh, ArmForm::Exponentials, ArmForm::Urdf}) {
    const Result<std::string> text = textOf(model, form);
    ASSERT_TRUE(text || !text.problems().empty());
  }
}

TEST(ArmMutation, FilesAreAnArmOrSayWhatIsWrong) {
  Random random({321});
  std::vector<std::string> texts, robots;
  for (const Model& model : models()) {
    texts.emplace_back(fileOf(model.name));
    for (const ArmForm form : {ArmForm::Exponentials, ArmForm::Urdf}) {
      const Result<std::string> text = textOf(model, form);
      if (text) (form == ArmForm::Urdf ? robots : texts).push_back(text.value());
    }
  }
  ASSERT_GE(robots.size(), 5U);
  const int draws = test::sweep(3000, 100000);
  int arms = 0, urdf_arms = 0;
  for (int draw = 0; draw < draws && !testing::Test::HasFailure(); ++draw) {
    const std::string text = mutated(texts[random.below(texts.size())], random);
    SCOPED_TRACE(text);
    const Result<Model> read = readArm(text, "a.json");
    arms += read ? 1 : 0;
    expectSound(read);
  }
  for (int draw = 0; draw < draws && !testing::Test::HasFailure(); ++draw) {
    const std::string text = mutated(robots[random.below(robots.size())], random);
    SCOPED_TRACE(text);
    const UrdfEnds ends{random.below(2) == 0 ? "base_link" : "", random.below(2) == 0 ? "tip" : ""};
    const Result<Model> read = readUrdf(text, "a.urdf", ends);
    urdf_arms += read ? 1 : 0;
    expectSound(read);
  }
  EXPECT_GT(arms, draws / 50) << "hardly any of the files is still an arm";
  EXPECT_GT(urdf_arms, draws / 50);
  RecordProperty("arms", arms);
  RecordProperty("urdf_arms", urdf_arms);
}

}  // namespace
}  // namespace underact::arm
