// What a recording does to the files of its person: none is written over unasked, others cannot read it, and it tells
// nothing of where they lie.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "core/record/session.h"
#include "tests/cli/session.h"
#include "tests/core/mesh_file/some_meshes.h"
#include "tests/support/modes.h"

namespace underact::test {
namespace {

using cli::Exit;
namespace fs = std::filesystem;

Outcome recordTo(const std::string& path, std::vector<std::string> more = {}) {
  std::vector<std::string> all{
      "run", shipped("02_sphere.json"), "--hand", "probe", "--seconds", "0.2", "--fast", "--record", path};
  all.insert(all.end(), more.begin(), more.end());
  return runCli(all);
}

// A hand that is elsewhere within a millisecond, as no hand is.
constexpr const char* kLeaps = R"({"underact_hand": 1,
  "hand": {"mass_kg": 0.001, "damping_N_s_per_m": 10, "stiffness_N_per_m": 1e7},
  "path": [{"t_s": 0, "p_mm": [0, 0, 60]}, {"t_s": 0.5, "p_mm": [0, 0, 60]}, {"t_s": 0.501, "p_mm": [60, 0, 60]}]})";

class RecordTo : public testing::TestWithParam<const char*> {};

TEST_P(RecordTo, AFileOrALinkThatIsThereIsRefusedBeforeAnythingRuns) {
  const ScratchFolder folder;
  const std::string ending = GetParam(), file = folder.write("file" + ending, "mine");
  const std::string link = folder.file("link" + ending), dangling = folder.file("dangling" + ending);
  fs::create_symlink(file, link);
  fs::create_symlink(folder.file("nowhere"), dangling);
  fs::create_directory(folder.file("folder" + ending));
  for (const std::string& path : {file, link, dangling, folder.file("folder" + ending)}) {
    const Outcome outcome = recordTo(path);
    EXPECT_EQ(outcome.exit, Exit::File) << path;
    EXPECT_EQ(outcome.out, "") << path;
    EXPECT_NE(outcome.err.find(path), std::string::npos) << outcome.err;
  }
  EXPECT_NE(recordTo(link).err.find("--overwrite"), std::string::npos);
  EXPECT_EQ(fileContent(file), "mine");
  EXPECT_TRUE(fs::is_symlink(link) && fs::is_symlink(dangling));
  EXPECT_FALSE(fs::exists(folder.file("nowhere")));
}

TEST_P(RecordTo, WithOverwriteTheFileIsReplacedAndOfALinkTheLinkAlone) {
  const ScratchFolder folder;
  const std::string ending = GetParam(), file = folder.write("file" + ending, "mine");
  const std::string link = folder.file("link" + ending), dangling = folder.file("dangling" + ending);
  fs::create_symlink(file, link);
  fs::create_symlink(folder.file("nowhere"), dangling);
  for (const std::string& path : {link, dangling}) {
    EXPECT_EQ(recordTo(path, {"--overwrite"}).exit, Exit::Success) << path;
    EXPECT_FALSE(fs::is_symlink(path));
    EXPECT_GT(fs::file_size(path), 1000U);
  }
  EXPECT_EQ(fileContent(file), "mine");
  EXPECT_FALSE(fs::exists(folder.file("nowhere")));
  EXPECT_EQ(recordTo(file, {"--overwrite"}).exit, Exit::Success);
  EXPECT_GT(fs::file_size(file), 1000U);
  fs::create_directory(folder.file("folder" + ending));
  EXPECT_EQ(recordTo(folder.file("folder" + ending), {"--overwrite"}).exit, Exit::File);
}

TEST_P(RecordTo, IsItsOwnersAloneWhateverTheUmaskIs) {
  const ScratchFolder folder;
  const Umask everybody(0);
  const std::string path = folder.file(std::string("s") + GetParam());
  ASSERT_EQ(recordTo(path).exit, Exit::Success);
  EXPECT_EQ(modeOf(path), 0600U);
}

INSTANTIATE_TEST_SUITE_P(Every, RecordTo, testing::Values(".csv", ".h5"),
                         [](const auto& one) { return std::string(one.param).substr(1); });

TEST(RecordFiles, ReplayAndExportsKeepToTheSame) {
  const ScratchFolder folder;
  const Umask everybody(0);
  const std::string session = folder.file("s.h5"), now = folder.file("now.csv"), out = folder.file("out.csv");
  ASSERT_EQ(recordTo(session).exit, Exit::Success);
  ASSERT_EQ(runCli({"replay", session, "--record", now}).exit, Exit::Success);
  EXPECT_EQ(modeOf(now), 0600U);
  const Outcome again = runCli({"replay", session, "--record", now});
  EXPECT_EQ(again.exit, Exit::File);
  EXPECT_EQ(again.out, "");
  EXPECT_EQ(runCli({"replay", session, "--record", now, "--overwrite"}).exit, Exit::Success);
  EXPECT_EQ(runCli({"replay", session, "--overwrite"}).exit, Exit::Usage);
  for (int time = 0; time < 2; ++time)  // exports go on replacing
    EXPECT_EQ(runCli({"log", "export", session, "--out", out}).exit, Exit::Success);
  EXPECT_EQ(modeOf(out), 0600U);
}

TEST(RecordFiles, ConsentIsAmongTheWordsAndOldSessionsLackIt) {
  const ScratchFolder folder;
  const std::string session = folder.file("s.h5"), none = folder.file("none.h5");
  ASSERT_EQ(recordTo(session, {"--subject", "S07", "--consent", "form 2.1, 2026-11-20, in writing"}).exit,
            Exit::Success);
  ASSERT_EQ(recordTo(none).exit, Exit::Success);
  EXPECT_EQ(textAt(lines(runCli({"log", "info", session, "--json"}).out).at(0), "consent"),
            "form 2.1, 2026-11-20, in writing");
  EXPECT_EQ(textAt(lines(runCli({"log", "info", none, "--json"}).out).at(0), "consent"), "");
  EXPECT_NE(runCli({"log", "info", none}).out.find("consent       not recorded"), std::string::npos);
  EXPECT_TRUE(record::rewriteMetadata(none, {.name = "n", .consent = "given later"}).empty());
  EXPECT_EQ(textAt(lines(runCli({"log", "info", none, "--json"}).out).at(0), "consent"), "given later");
  EXPECT_EQ(runCli({"log", "info", UNDERACT_TEST_DATA "/golden/session.h5"}).exit, Exit::Success);  // of before
}

TEST(RecordFiles, OtherWordsAreWrittenIntoNoFileThatALinkLeadsTo) {
  const ScratchFolder folder;
  const std::string session = folder.file("s.h5"), link = folder.file("link.h5");
  ASSERT_EQ(recordTo(session).exit, Exit::Success);
  fs::create_symlink(session, link);
  const std::string before = fileContent(session);
  const Problems problems = record::rewriteMetadata(link, {.name = "Another"});
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_NE(describe(problems[0]).find("This is a link to another file"), std::string::npos) << describe(problems[0]);
  EXPECT_EQ(fileContent(session), before);
}

/// A person's folder with a scene whose mesh and curve lie in further ones, a hand that jumps, and an arm model.
class Person {
 public:
  Person() {
    fs::create_directories(home() + "/thesis");
    fs::create_directories(home() + "/parts/of the knee");
    write("parts/of the knee/patella.obj", obj(cube(20.0F)));
    write("parts/walk.txt", "0 0 0\n10 0 0\n20 5 0\n30 0 5\n");
    write("thesis/knee.json", R"({"underact_scene": 1, "title": "Knee", "constraints": [
      {"name": "patella", "type": "mesh", "file": ")" +
                                  home() + R"(/parts/of the knee/patella.obj"},
      {"name": "walk", "type": "curve", "file": "../parts/walk.txt"}]})");
    write("thesis/leap.json", kLeaps);
  }
  std::string home() const { return folder_.file("home/some-person"); }
  std::string file(const std::string& name) const { return home() + "/" + name; }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(file(name), std::ios::binary) << text;
  }

 private:
  ScratchFolder folder_;
};

TEST(RecordFiles, HoldNoFolderOfThePerson) {
  const Person person;
  const ScratchFolder records;
  const std::string session = records.file("s.h5"), fault = records.file("fault.json"), csv = records.file("s.csv");
  const Outcome run =
      runCli({"run", person.file("thesis/knee.json"), "--hand", person.file("thesis/leap.json"), "--arm-model", "ideal",
              "--seconds", "1", "--fast", "--record", session, "--fault-file", fault});
  ASSERT_EQ(run.exit, Exit::Fault) << run.err;
  ASSERT_EQ(runCli({"log", "export", session, "--out", csv}).exit, Exit::Success);
  for (const std::string& path : {session, fault, csv})
    EXPECT_EQ(fileContent(path).find("some-person"), std::string::npos) << path;
  EXPECT_NE(fileContent(fault).find("patella.obj"), std::string::npos);
  Result<record::Session> read = record::Session::open(session);
  ASSERT_TRUE(read);
  for (const record::ChangeRow& change : read.value().changes()) {  // in the file these may be packed
    const std::string scene = read.value().sceneText(change).value();
    EXPECT_EQ(scene.find("some-person"), std::string::npos) << scene;
    EXPECT_NE(scene.find("\"patella.obj\""), std::string::npos) << scene;
    EXPECT_NE(scene.find("\"walk.txt\""), std::string::npos) << scene;
  }
  const record::SessionMetadata& words = read.value().info().header.words;
  EXPECT_EQ(words.notes, "Hand leap.json, seed 1, arm model ideal.");
}

TEST(RecordFiles, AReplayFindsTheFilesBesideTheSessionOrWhereItIsTold) {
  const Person person;
  const ScratchFolder records;
  const std::string session = records.file("s.h5");
  ASSERT_EQ(runCli({"run", person.file("thesis/knee.json"), "--hand", "probe", "--seconds", "0.5", "--fast", "--record",
                    session})
                .exit,
            Exit::Success);
  const Outcome lost = runCli({"replay", session, "--verify"});
  EXPECT_EQ(lost.exit, Exit::File);
  EXPECT_NE(lost.err.find("\"patella.obj\" was not found"), std::string::npos) << lost.err;
  EXPECT_NE(lost.err.find("--files FOLDER"), std::string::npos) << lost.err;
  const std::vector<std::string> told{"--files", person.file("parts"), person.file("parts/of the knee")};
  for (const char* how : {"--verify", "--kp=0.1"}) {
    std::vector<std::string> words{"replay", session, how};
    words.insert(words.end(), told.begin(), told.end());
    EXPECT_EQ(runCli(words).exit, Exit::Success) << how << runCli(words).err;
  }
  fs::copy(person.file("parts/of the knee/patella.obj"), records.file("patella.obj"));
  fs::copy(person.file("parts/walk.txt"), records.file("walk.txt"));
  EXPECT_EQ(runCli({"replay", session, "--verify"}).exit, Exit::Success);
  records.write("patella.obj", obj(cube(21.0F)));  // another of that name: the checksum tells
  EXPECT_NE(runCli({"replay", session, "--verify"}).err.find("its checksum differs"), std::string::npos);
  std::vector<std::string> words{"replay", session, "--verify"};
  words.insert(words.end(), told.begin(), told.end());
  EXPECT_EQ(runCli(words).exit, Exit::Success);
}

TEST(RecordFiles, AReplayFindsTheMeshesThatShip) {
  const ScratchPath session("s.h5");
  ASSERT_EQ(runCli({"run", shipped("26_bumpy_sphere.json"), "--hand", "probe", "--seconds", "0.2", "--fast", "--record",
                    session.path()})
                .exit,
            Exit::Success);
  ::setenv("UNDERACT_DATA_DIR", UNDERACT_SOURCE, 1);
  const Outcome outcome = runCli({"replay", session.path(), "--verify"});
  ::unsetenv("UNDERACT_DATA_DIR");
  EXPECT_EQ(outcome.exit, Exit::Success) << outcome.err;
}

}  // namespace
}  // namespace underact::test
