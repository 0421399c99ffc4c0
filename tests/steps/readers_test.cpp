#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "app/mesh_reader/prepare.h"
#include "core/arm/model.h"
#include "core/arm/urdf.h"
#include "core/curve/points.h"
#include "core/lesson/read.h"
#include "core/registration/registration_file.h"
#include "core/scene/read.h"
#include "core/scene/settings.h"
#include "core/scene/teaching.h"
#include "core/sim/arm_model_file.h"
#include "core/sim/hand_script.h"
#include "device/input/map_file.h"
#include "tests/steps/counter.h"
#include "tests/support/property.h"

namespace underact {
namespace {

constexpr std::size_t kMiB = std::size_t{1} << 20;

template <class T>
std::size_t problemsOf(const Result<T>& result) {
  return result ? 0 : result.problems().size();
}

/// What one reader does with a text: how many problems it names. largest: the bytes of a file that it takes.
struct Reader {
  const char* name;
  std::size_t largest;
  std::size_t (*read)(const std::string& text);
};

/// A text that grows: part, with its number in place of #, between two others.
struct Worst {
  std::string before, part, after;
  std::string text(int count) const {
    std::string all = before;
    for (int index = 0; index < count; ++index) {
      for (const char letter : part)
        all += letter == '#'   ? std::to_string(index)
               : letter == '@' ? std::to_string(index + 1)
                               : std::string(1, letter);
    }
    return all + after;
  }
};

const std::vector<Reader> kJsonReaders{
    {"scene", 16 * kMiB, [](const std::string& text) { return problemsOf(scene::readScene(text, "f")); }},
    {"arm", 16 * kMiB, [](const std::string& text) { return problemsOf(arm::readArm(text, "f")); }},
    {"lesson", kMiB, [](const std::string& text) { return problemsOf(lesson::readLesson(text, "f")); }},
    {"hand", 16 * kMiB, [](const std::string& text) { return problemsOf(sim::readHand(text, "f")); }},
    {"arm model", 16 * kMiB, [](const std::string& text) { return problemsOf(sim::readArmModel(text, "f")); }},
    {"mapping", kMiB, [](const std::string& text) { return problemsOf(device::input::readMap(text, "f")); }},
    {"registration", kMiB,
     [](const std::string& text) { return problemsOf(registration::readRegistration(text, "f")); }},
    {"teaching", 16 * kMiB, [](const std::string& text) { return std::size_t{scene::teachingIn(text) ? 0U : 1U}; }},
};

std::vector<Worst> worstOfJson() {
  std::vector<Worst> all{
      {"{", "\"underact_scene#\": 1, ", "\"a\": 1}"},
      {"{", "\"" + std::string(63, 'k') + "#\": 1, ", "\"a\": 1}"},
      {"{", "\"title\": 1, ", "\"a\": 1}"},
      {"[", std::string(60, '[') + std::string(60, ']') + ",", "1]"},
      {"", "[", ""},
      {"{\"title\": 0.", "1", "}"},
      {"[", "1400e400, -1.5e-999, ", "1e]"},
      {"{\"title\": \"", "\\u00e9\\n", "\"}"},
      {"{", "\n", "]"},
  };
  // Below each key that has a list or an object for one of the readers.
  for (const char* key : {"constraints", "joints", "dh", "solids", "steps", "path", "provenance", "ways", "buttons",
                          "marks", "teach", "control"}) {
    const std::string list = "{\"" + std::string(key) + "\": [", object = "{\"" + std::string(key) + "\": {";
    all.push_back({list, "{},", "{}]}"});
    all.push_back({list, "7,", "7]}"});
    all.push_back({list, R"({"type": "sphere#", "name": "n", "t_s": #, "title": "t", "checks": [{}, {}]},)", "{}]}"});
    all.push_back({list + "{\"type\": \"sphere\", ", "\"radius_m#\": [0], ", "\"a\": 1}]}"});
    all.push_back({object, "\"key#\": [0], ", "\"group\": \"shapes\"}}"});
  }
  return all;
}

std::vector<Worst> worstOfUrdf() {
  const std::string robot = "<robot name=\"r\">", end = "</robot>", link = "<link name=\"l0\"/>";
  const std::string joint = "<joint name=\"j#\" type=\"fixed\"><parent link=\"l#\"/><child link=\"l@\"/></joint>";
  return {
      {robot + "<link ", "a#=\"\" ", "/>" + end},
      {robot, "<origin" + Worst{"", " a#=\"\"", ""}.text(64) + "/>", end},
      {robot, "<lin#/>", end},
      {robot, "<transmissionnnnn#/>", end},
      {robot, "<link name=\"l#\"/>", end},
      {robot, "<link name=\"l\"/>", end},
      {robot + link, "<link name=\"l@\"/>" + joint, end},
      {robot + link,
       "<link name=\"l@\"/><joint name=\"j#\" type=\"fixed\"><parent link=\"l0\"/><child link=\"l@\"/></joint>", end},
      {robot + link, joint, end},
      {robot + "<link name=\"l\">", "<visual><geometry><box size=\"1 1 x\"/></geometry></visual>", "</link>" + end},
      {"<robot name=\"", "&#1", "\"></robot>"},
      {"<robot name=\"", "&#65;&amp;&", "\"></robot>"},
      {robot, "<!-- - -->", end},
      {robot + "<!--", "-", end},
      {robot, "<a>", end},
      {robot, "<", end},
      {robot + "<link name=\"", "x", "\"/>" + end},
      {robot + "<link name=\"l\"><inertial><origin xyz=\"", "1 ", "\"/></inertial></link>" + end},
  };
}

const std::vector<Worst> kPoints{
    {"", "#, 0.1, 2\n", ""}, {"0 0 0\n", "a b c\n", ""}, {"", "% a\n", ""}, {"", "1,", ""}, {"0.", "7", " 0 0\n"}};

const std::vector<Worst> kMeshes{
    {"v 0 0 0\nf 1", " 2\\\n", ""},
    {"", "\\\n", ""},
    {"", "v # 0 0\nf 1 2 3\n", ""},
    {"v 0 0 0\n", "f 1 1 1\n", ""},
    {"OFF\n", "% a\n", "0 0 0"},
    {"", "\n", "OFF 1 1 0\n"},
    {"ply\nformat ascii 1.0\nelement vertex 1\n", "property float x#\n", "end_header\n"},
    {"ply\nformat ascii 1.0\n", "comment c\n", "end_header\n"},
    {"solid s\n", "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n", ""},
};

template <mesh_file::Format kFormat>
std::size_t prepared(const std::string& text) {
  return mesh_reader::prepare(kFormat, text).problem.empty() ? 0 : 1;
}

/// Prints the seconds for a file of the largest size.
void timeLargest(const Reader& reader, const Worst& worst) {
  const double share = static_cast<double>(reader.largest) / static_cast<double>(worst.text(1000).size());
  const std::string text = worst.text(static_cast<int>(1000.0 * share));
  const auto begin = std::chrono::steady_clock::now();
  reader.read(text);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  std::printf("[   TIME   ] %s: %.2f s for %zu bytes, %s\n", reader.name, took.count(), text.size(),
              worst.part.c_str());
}

/// Each text of twice the size takes twice the steps, and no more problems are named than anybody reads.
void checkAll(const std::vector<Reader>& readers, const std::vector<Worst>& texts) {
  for (const Reader& reader : readers) {
    for (const Worst& worst : texts) {
      const auto stepsOf = [&](int count) {
        const std::string text = worst.text(count);
        const long before = test::steps();
        EXPECT_LE(reader.read(text), 101U) << reader.name << ": " << worst.part;  // the last one counts the others
        return static_cast<double>(test::steps() - before);
      };
      stepsOf(10);  // what is made once
      const double once = stepsOf(1000), twice = stepsOf(2000);
      EXPECT_LE(twice, 2.3 * once + 2000.0) << reader.name << ": " << worst.part << ": " << once << ", then " << twice;
      if (test::isSoak()) timeLargest(reader, worst);
    }
  }
}

TEST(Steps, SeeWhatALoopOfTheLibraryDoes) {  // else the tests below would prove nothing
  const std::string one(8000, 'a'), other(8000, 'a');
  const long before = test::steps();
  EXPECT_TRUE(one == other);
  EXPECT_GE(test::steps() - before, 1000);
  const std::string copy = one;
  EXPECT_EQ(copy.find('b'), std::string::npos);
  EXPECT_GE(test::steps() - before, 3000);
}

TEST(EveryReader, TakesTwiceTheStepsForTwiceAnyJson) {
  checkAll(kJsonReaders, worstOfJson());
}

TEST(EveryReader, TakesTwiceTheStepsForTwiceAnyUrdf) {
  checkAll({{"URDF", 4 * kMiB, [](const std::string& text) { return problemsOf(arm::readUrdf(text, "f", {})); }},
            {"URDF with ends", 4 * kMiB,
             [](const std::string& text) {
               return problemsOf(arm::readUrdf(text, "f", {"l1", "l999"}));
             }}},
           worstOfUrdf());
}

TEST(EveryReader, TakesTwiceTheStepsForTwiceAnyFileOfPoints) {
  checkAll({{"points", 256 * kMiB, [](const std::string& text) { return problemsOf(curve::parsePoints(text, "f")); }}},
           kPoints);
}

TEST(EveryReader, TakesTwiceTheStepsForTwiceAnyMesh) {
  using mesh_file::Format;
  checkAll({{"STL", 64 * kMiB, &prepared<Format::StlText>},
            {"OBJ", 64 * kMiB, &prepared<Format::Obj>},
            {"OFF", 64 * kMiB, &prepared<Format::Off>},
            {"PLY", 64 * kMiB, &prepared<Format::Ply>}},
           kMeshes);
}

TEST(EveryReader, TakesTwiceTheStepsForTwiceAnyPathOfASetting) {
  static const scene::Description kScene =
      scene::readScene(
          R"({"underact_scene": 1, "title": "t", "constraints": [{"type": "point", "position_mm": [0, 0, 0]}]})", "f")
          .value();
  checkAll({{"path", kMiB, [](const std::string& text) { return problemsOf(scene::valueAt(kScene, text)); }}},
           {{"", "/", ""}, {"/", "a", ""}, {"", "/constraints", ""}, {"/control/law", "w", ""}});
}

}  // namespace
}  // namespace underact
