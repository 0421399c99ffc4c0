#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "core/json/json.h"
#include "core/lesson/window_names.h"
#include "tests/core/lesson/lesson_support.h"

namespace underact::lesson {
namespace {

using test::checkOf;
using test::lessonWith;
using test::problemsIn;

std::string folder() {
  return std::string(UNDERACT_SOURCE) + "/resources/lessons";
}

std::vector<std::string> shippedFiles() {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder())) {
    const std::filesystem::path& path = entry.path();
    if (path.extension() == ".json" && path.stem().extension() != ".schema") files.push_back(path.string());
  }
  return files;
}

TEST(ReadLesson, TellsWhatTheFileSays) {
  const Result<Lesson> read = readLesson(R"({"underact_lesson": 1, "title": "Springs", "group": "Forces", "order": 2.5,
    "about": ["One.", "Two."], "steps": [
      {"title": "A", "text": "read", "scene": "02_sphere", "camera": "top", "layers": ["force"], "panels": ["feel"]},
      {"title": "B", "text": ["first", "second"], "hint": "pull", "checks": [{"measure": "force_N", "above": 1}]}]})",
                                         "here/springs.json");
  ASSERT_TRUE(read) << describe(read.problems().front());
  const Lesson& lesson = read.value();
  EXPECT_EQ(lesson.title + lesson.group + lesson.about, "SpringsForcesOne.\nTwo.\n");
  EXPECT_EQ(lesson.order, 2.5);
  ASSERT_EQ(lesson.steps.size(), 2u);
  EXPECT_EQ(lesson.steps[0].camera, "top");
  EXPECT_EQ(lesson.steps[0].layers, std::vector<std::string>{"force"});
  EXPECT_EQ(lesson.steps[0].panels, std::vector<std::string>{"feel"});
  EXPECT_EQ(lesson.steps[1].text, "first\nsecond\n");
  EXPECT_EQ(lesson.steps[1].checks.size(), 1u);
  EXPECT_EQ(sceneFileOf(lesson, 1, "/scenes"), "/scenes/02_sphere.json");  // that of the step before
}

TEST(ReadLesson, ScenesAreShippedOnesOrFilesSeenFromTheLesson) {
  Lesson lesson;
  lesson.file = "/home/t/lesson.json";
  lesson.steps.resize(1);
  lesson.steps[0].scene = "mine/ball.json";
  EXPECT_EQ(sceneFileOf(lesson, 0, "/scenes"), "/home/t/mine/ball.json");
  lesson.steps[0].scene = "/else/ball.json";
  EXPECT_EQ(sceneFileOf(lesson, 0, "/scenes"), "/else/ball.json");
}

TEST(ReadLesson, EveryProblemIsToldAtOnceWithItsPlace) {
  const std::vector<std::string> lines = problemsIn(R"({"underact_lesson": 2, "titel": "T",
 "steps": [{"title": "", "text": [], "layers": ["gosts"], "camera": "fornt",
   "checks": [{"measure": "force", "above": 1}, {"measure": "force_N"}, {"measure": "q_deg", "part": 9, "below": 1},
              {"measure": "q_deg", "near": [1, 2], "within": 1}, {"question": "Q", "choices": ["a"], "right": 3}]}]})");
  const auto has = [&lines](const std::string& what) {
    return std::any_of(lines.begin(), lines.end(),
                       [&](const std::string& line) { return line.find(what) != std::string::npos; });
  };
  EXPECT_TRUE(has("lesson.json:1:21: error: underact_lesson: This must be the number 1"));
  EXPECT_TRUE(has("titel: The key \"titel\" is not known in a lesson. Did you mean \"title\"?"));
  EXPECT_TRUE(has("The key \"title\" is missing; a lesson needs it."));
  EXPECT_TRUE(has("steps[0].title: This must be one line of text"));
  EXPECT_TRUE(has("steps[0].text: The text is empty."));
  EXPECT_TRUE(has("The key \"scene\" is missing; a step needs it."));
  EXPECT_TRUE(has("There is no layer \"gosts\". Did you mean \"ghosts\"?"));
  EXPECT_TRUE(has("There is no camera \"fornt\". Did you mean \"front\"?"));
  EXPECT_TRUE(has("lesson.json:3:27: error: steps[0].checks[0].measure: There is no quantity \"force\". Did you mean"));
  EXPECT_TRUE(has("checks[1].measure: Give a range"));
  EXPECT_TRUE(has("The quantity q_deg has the parts 1 to 8."));
  EXPECT_TRUE(has("steps[0].checks[3].near: This must be a list of 6 numbers; here it has 2."));
  EXPECT_TRUE(has("Give 2 to 9 answers to choose from."));
  EXPECT_TRUE(has("This must be the number of the right answer, 1 to 1."));
}

TEST(ReadLesson, EachCheckIsTheKindThatItsKeysSay) {
  const auto kind = [](const std::string& json) { return checkOf(json).task.index(); };
  EXPECT_EQ(kind(R"({"measure": "force_N", "below": 1, "for_s": 2})"), Task(Hold{}).index());
  EXPECT_EQ(kind(R"({"measure": "tip_mm", "visit": [[0, 0, 0]], "within": 1})"), Task(Visit{}).index());
  EXPECT_EQ(kind(R"({"measure": "force_N", "spans": 1})"), Task(Span{}).index());
  EXPECT_EQ(kind(R"({"measure": "force_N", "crosses": 1, "times": 2, "in_s": 1})"), Task(Cross{}).index());
  EXPECT_EQ(kind(R"({"question": "Q", "answer": 1, "within": 0})"), Task(AskNumber{}).index());
  EXPECT_EQ(kind(R"({"question": "Q", "choices": ["a", "b"], "right": 1})"), Task(AskChoice{}).index());
  EXPECT_EQ(std::variant_size_v<Task>, 6u);
}

TEST(ReadLesson, RefusesKeysThatExcludeEachOther) {
  for (const char* check :
       {R"({"measure": "force_N", "above": 2, "below": 1})",
        R"({"measure": "force_N", "above": 2, "near": 1, "within": 1})", R"({"measure": "force_N", "near": 1})",
        R"({"measure": "tip_mm", "spans": 1})", R"({"question": "Q", "answer": 1, "measure": "force_N", "within": 1})",
        R"({"question": "Q", "answer": 1})", R"({"measure": "stylus", "near": [null, 0, 1], "within": 1})",
        R"({"measure": "force_N", "below": 1e999})", R"({"measure": "force_N", "below": 1, "for_s": -1})",
        R"({"measure": "force_N", "below": 1, "while": [{"measure": "force_N"}]})", R"(3)"}) {
    EXPECT_FALSE(problemsIn(lessonWith(check)).empty()) << check;
  }
}

TEST(ReadLesson, AFileThatIsNotThereIsAProblemWithoutALine) {
  const Result<Lesson> read = readLessonFile("/nowhere/lesson.json");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.problems().at(0).place.line, 0);
}

TEST(CheckScenes, SaysWhatAStepsSceneCannotHave) {
  const std::string scenes = std::string(UNDERACT_SOURCE) + "/scenes";
  const auto told = [&scenes](const std::string& scene, const std::string& check) {
    Lesson lesson = readLesson(lessonWith(check), "lesson.json").value();
    lesson.steps[0].scene = scene;
    std::string all;
    for (const Problem& problem : checkScenes(lesson, scenes)) all += describe(problem) + "\n";
    return all;
  };
  const std::string robot = R"({"measure": "robot", "part": 1, "above": 1})";
  EXPECT_EQ(told("16_one_joint_robot", robot), "");
  EXPECT_NE(told("02_sphere", robot).find("steps[0].checks[0]: The scene \"Sphere\" has no robot"), std::string::npos);
  EXPECT_NE(told("nowhere", robot).find("nowhere.json"), std::string::npos);
  const std::string t = R"({"measure": "force_N", "above": 1, "while": [{"measure": "influence_t", "below": 1}]})";
  EXPECT_EQ(told("14_circle_influence", t), "");
  EXPECT_NE(told("02_sphere", t).find("none of its constraints has an influence"), std::string::npos);
  EXPECT_EQ(told("02_sphere", R"({"question": "Q", "measure": "energy_mJ", "within": 1})"), "");
}

TEST(ShippedLessons, AreAtLeastTenOfThreeToSixStepsAndAllRight) {
  const std::vector<std::string> files = shippedFiles();
  EXPECT_GE(files.size(), 10u);
  std::set<double> orders;
  for (const std::string& file : files) {
    const Result<Lesson> read = readLessonFile(file);
    ASSERT_TRUE(read) << describe(read.problems().front());
    const Lesson& lesson = read.value();
    EXPECT_TRUE(checkScenes(lesson, std::string(UNDERACT_SOURCE) + "/scenes").empty()) << file;
    EXPECT_GE(lesson.steps.size(), 3u) << file;
    EXPECT_LE(lesson.steps.size(), 6u) << file;
    EXPECT_FALSE(lesson.group.empty() || lesson.about.empty()) << file;
    EXPECT_TRUE(orders.insert(lesson.order).second) << file << " has the order of another one";
    for (const Step& step : lesson.steps) {
      EXPECT_FALSE(step.checks.empty()) << file << " " << step.title;
      EXPECT_FALSE(step.hint.empty()) << file << " " << step.title;
      EXPECT_GE(step.text.size(), 80u) << file << " " << step.title;
    }
  }
}

// The schema is for editors; here it is held against the reader.

json::Value schema() {
  std::ifstream file(folder() + "/lesson.schema.json");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  return json::parse(text, "lesson.schema.json").value();
}

std::set<std::string> wordsOf(const json::Value& list) {
  std::set<std::string> words;
  for (const json::Value& item : list.items) words.insert(item.text);
  return words;
}

template <class Names>
std::set<std::string> setOf(const Names& names) {
  return {names.begin(), names.end()};
}

TEST(LessonSchema, HasTheNamesThatTheReaderHas) {
  const json::Value root = schema();
  const json::Value& defs = *root.find("$defs");
  const json::Value& step = *defs.find("step")->find("properties");
  EXPECT_EQ(wordsOf(*step.find("camera")->find("enum")), setOf(cameraNames()));
  EXPECT_EQ(wordsOf(*step.find("layers")->find("items")->find("enum")), setOf(layerNames()));
  EXPECT_EQ(wordsOf(*step.find("panels")->find("items")->find("enum")), setOf(panelNames()));
  std::set<std::string> quantities;
  for (const Quantity& quantity : lesson::quantities()) quantities.insert(quantity.key);
  EXPECT_EQ(wordsOf(*defs.find("quantity")->find("enum")), quantities);
}

/// The keys that the reader names when it meets one that is near to none.
std::set<std::string> keysKnownIn(const std::string& text) {
  std::set<std::string> keys;
  for (const std::string& line : problemsIn(text)) {
    std::size_t at = line.find("Known keys: ");
    while (at != std::string::npos && (at = line.find('"', at)) != std::string::npos) {
      const std::size_t end = line.find('"', at + 1);
      keys.insert(line.substr(at + 1, end - at - 1));
      at = end + 1;
    }
  }
  return keys;
}

TEST(LessonSchema, KnowsTheKeysThatTheReaderKnowsAndNoOthers) {
  const json::Value root = schema();
  const auto properties = [](const json::Value& of) { return setOf(of.find("properties")->keys); };
  const json::Value& defs = *root.find("$defs");
  const std::string odd = R"("qqqqqqqqqqqqqqqqqqqqqq": 1)";
  EXPECT_EQ(properties(root), keysKnownIn("{" + odd + "}"));
  EXPECT_EQ(properties(*defs.find("step")), keysKnownIn(R"({"steps": [{)" + odd + "}]}"));
  std::set<std::string> keys;  // of all kinds of checks together
  for (const char* kind : {"", R"("visit": [], )", R"("spans": 1, )", R"("crosses": 1, )", R"("question": "q", )",
                           R"("choices": [], "question": "q", )"}) {
    keys.merge(keysKnownIn(lessonWith("{" + std::string(kind) + odd + "}")));
  }
  EXPECT_EQ(properties(*defs.find("check")), keys);
  const std::string condition = R"({"measure": "force_N", "below": 1, "while": [{)" + odd + "}]}";
  EXPECT_EQ(properties(*defs.find("condition")), keysKnownIn(lessonWith(condition)));
  EXPECT_EQ(wordsOf(*root.find("required")), (std::set<std::string>{"underact_lesson", "title", "steps"}));
}

}  // namespace
}  // namespace underact::lesson
