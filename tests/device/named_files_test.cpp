// Files that people, scenes and sessions name: whatever lies at such a name, the answer comes at once, with the name in
// it.
#include <gtest/gtest.h>

#include <functional>
#include <ostream>

#include "core/arm/model.h"
#include "core/curve/points.h"
#include "core/lesson/read.h"
#include "core/mesh_file/load.h"
#include "core/record/recorder.h"
#include "core/record/session.h"
#include "core/registration/registration_file.h"
#include "core/scene/load_meshes.h"
#include "core/scene/read.h"
#include "core/scene/teaching.h"
#include "core/sim/arm_model_file.h"
#include "core/sim/hand_script.h"
#include "device/input/map_file.h"
#include "device/recorded.h"
#include "device/remote/keys.h"
#include "tests/support/odd_files.h"
#include "tests/support/watchdog.h"

namespace underact {
namespace {

template <class T>
Problems problemsOf(const Result<T>& result) {
  return result ? Problems{} : result.problems();
}

/// A scene that names the file.
Problems problemsOfScene(const std::string& type, const std::string& path) {
  Result<scene::Description> scene =
      scene::readScene(R"({"underact_scene": 1, "title": "T", "constraints": [{"name": "one", "type": ")" + type +
                           R"(", "file": ")" + path + R"("}]})",
                       "");
  return scene ? scene::loadMeshes(scene.value()) : scene.problems();
}

/// A scene that names the file of its arm.
Problems problemsOfArm(const std::string& path) {
  return problemsOf(scene::readScene(R"({"underact_scene": 1, "title": "T", "arm": ")" + path +
                                         R"(", "constraints": [{"type": "point", "position_mm": [0, 0, 0]}]})",
                                     ""));
}

struct Kind {
  const char* name;
  const char* ending;
  std::function<Problems(const std::string& path)> read;
  bool takes_none = false;  // where there is no such file, all is well
};

void PrintTo(const Kind& kind, std::ostream* out) {
  *out << kind.name;
}

class NamedFiles : public testing::TestWithParam<Kind> {};

TEST_P(NamedFiles, WhateverLiesThereIsAnsweredAtOnceWithItsName) {
  const test::Watchdog watchdog(60);
  const test::ScratchFolder folder;
  for (const test::OddFile& odd : test::oddFiles(folder, GetParam().ending)) {
    const Problems problems = GetParam().read(odd.path);
    if (GetParam().takes_none && odd.what == "no file") continue;
    ASSERT_FALSE(problems.empty()) << odd.what;
    EXPECT_NE(describe(problems[0]).find(odd.path), std::string::npos) << odd.what << ": " << describe(problems[0]);
  }
}

TEST_P(NamedFiles, ReportsUtf16ByName) {
  const test::ScratchFolder folder;
  const std::string path = folder.write(std::string("f") + GetParam().ending, "\xFF\xFE{");
  if (!path.ends_with(".h5")) EXPECT_NE(describe(GetParam().read(path)[0]).find("UTF-16"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    Every, NamedFiles,
    testing::Values(
        Kind{"scene", ".json", [](const std::string& path) { return problemsOf(scene::readSceneFile(path)); }},
        Kind{"curve", ".txt", [](const std::string& path) { return problemsOf(curve::readPoints(path)); }},
        Kind{"curve_of_a_scene", ".txt", [](const std::string& path) { return problemsOfScene("curve", path); }},
        Kind{"mesh", ".stl", [](const std::string& path) { return problemsOf(mesh_file::loadMesh(path)); }},
        Kind{"mesh_of_a_scene", ".stl", [](const std::string& path) { return problemsOfScene("mesh", path); }},
        Kind{"lesson", ".json", [](const std::string& path) { return problemsOf(lesson::readLessonFile(path)); }},
        Kind{"arm", ".json", [](const std::string& path) { return problemsOf(arm::readArmFile(path)); }},
        Kind{"arm_of_a_scene", ".json", problemsOfArm},
        Kind{"arm_model", ".json", [](const std::string& path) { return problemsOf(sim::chooseArmModel(path)); }},
        Kind{"hand", ".json", [](const std::string& path) { return problemsOf(sim::readHandFile(path)); }},
        Kind{"registration", ".json",
             [](const std::string& path) { return problemsOf(registration::readRegistrationFile(path)); }},
        Kind{"map", ".json", [](const std::string& path) { return problemsOf(device::input::readMapFile(path)); }},
        Kind{"session", ".h5", [](const std::string& path) { return problemsOf(record::Session::open(path)); }},
        Kind{"session_recovered", ".h5", [](const std::string& path) { return problemsOf(record::recover(path)); }},
        Kind{"session_with_other_words", ".h5",
             [](const std::string& path) { return record::rewriteMetadata(path, {.name = "Other"}); }}),
    [](const testing::TestParamInfo<Kind>& one) { return std::string(one.param.name); });

TEST(NamedFiles, AFileOfKeysIsReadInTheSameWay) {
  const test::Watchdog watchdog(60);
  const test::ScratchFolder folder;
  for (const test::OddFile& odd : test::oddFiles(folder, "")) {
    if (odd.what == "no file") continue;
    const test::ScratchFolder keys;
    std::filesystem::create_symlink(odd.path, keys.file("arm_clients"));
    const device::remote::KeyFolder reader(keys.path());
    const Result<std::vector<std::string>> clients = reader.clients();
    ASSERT_FALSE(clients) << odd.what;
    EXPECT_NE(describe(clients.problems()[0]).find(keys.path()), std::string::npos) << odd.what;
  }
}

}  // namespace
}  // namespace underact
