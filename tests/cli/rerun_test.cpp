// A recorded run is made again from its file alone, to the bit; and one participant can be taken out.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/arm/model.h"
#include "tests/cli/session.h"
#include "tests/core/mesh_file/some_meshes.h"
#include "tests/session/rig.h"
#include "tests/support/arm_files.h"

namespace underact::test {
namespace {

using cli::Exit;
namespace fs = std::filesystem;

Outcome runAndRecord(const std::string& path, std::vector<std::string> words) {
  words.insert(words.end(), {"--record", path});
  return runCli(std::move(words));
}

/// What rerun answers; the test fails where it is not the same to the bit.
json::Value sameAgain(const std::string& session, std::vector<std::string> more = {}) {
  more.insert(more.begin(), {"rerun", session});
  const Outcome outcome = runCli(more);
  EXPECT_EQ(outcome.exit, Exit::Success) << outcome.err << outcome.out;
  const std::vector<json::Value> answers = lines(outcome.out);
  if (answers.size() != 1) return {};
  EXPECT_TRUE(answers[0].find("identical")->boolean) << outcome.out;
  EXPECT_EQ(numberAt(answers[0], "identical_ticks"), numberAt(answers[0], "ticks"));
  return answers[0];
}

TEST(RerunCommand, MakesARunOfEachHandAgainFromItsFileAlone) {
  const ScratchFolder folder;
  for (const char* hand : {"still", "sweep", "probe", "tremor", "stab"}) {
    const std::string session = folder.file(std::string(hand) + ".h5"), again = folder.file(std::string(hand) + "2.h5");
    runAndRecord(session, {"run", shipped("12_line_pid.json"), "--hand", hand, "--seconds", "1", "--fast", "--seed",
                           "18446744073709551615", "--arm-model", "ideal"});
    EXPECT_EQ(textAt(sameAgain(session, {"--out", again}), "made_from"), "hand") << hand;
    const Outcome difference = runCli({"log", "info", "--diff", session, again});
    EXPECT_EQ(difference.exit, Exit::Success) << hand << difference.out;
    EXPECT_EQ(textAt(sameAgain(again), "made_from"), "hand");
  }
}

TEST(RerunCommand, OfARunInRealTimeCountsItsLateTicksAsTheyWere) {
  const ScratchFolder folder;
  const std::string session = folder.file("s.h5");
  ASSERT_EQ(runAndRecord(session, {"run", shipped("02_sphere.json"), "--hand", "probe", "--seconds", "1", "--rate",
                                   "2000", "--max-late", "1000000", "--scheduling", "normal"})
                .exit,
            Exit::Success);
  sameAgain(session);
}

TEST(RerunCommand, TakesTheMeshByItsChecksumAndTheHandFromTheFile) {
  const ScratchFolder home, records;
  home.write("patella.obj", obj(cube(20.0F)));
  home.write("walk.txt", "0 0 0\n10 0 0\n20 5 0\n30 0 5\n");
  const std::string hand = home.write("mine.json", R"({"underact_hand": 1,
    "path": [{"t_s": 0, "p_mm": [0, 0, 60]}, {"t_s": 0.3, "p_mm": [5, 3, 12.1]}]})");
  const std::string scene = home.write("knee.json", R"({"underact_scene": 1, "title": "Knee", "constraints": [
      {"name": "patella", "type": "mesh", "file": "patella.obj"},
      {"name": "walk", "type": "curve", "file": "walk.txt"}]})");
  const std::string session = records.file("s.h5");
  ASSERT_EQ(runAndRecord(session, {"run", scene, "--hand", hand, "--seconds", "0.5", "--fast"}).exit, Exit::Success);
  fs::remove(hand);
  fs::remove(scene);
  EXPECT_EQ(runCli({"rerun", session}).exit, Exit::File);  // the mesh is elsewhere
  sameAgain(session, {"--files", home.path()});
  fs::copy(home.file("patella.obj"), records.file("patella.obj"));
  fs::copy(home.file("walk.txt"), records.file("walk.txt"));
  sameAgain(session);
  records.write("patella.obj", obj(cube(21.0F)));
  const Outcome other = runCli({"rerun", session});
  EXPECT_NE(other.exit, Exit::Success);
  EXPECT_NE(other.err.find("its checksum differs"), std::string::npos) << other.err;
}

TEST(RerunCommand, OfAnArmFromAFileNeedsThatFileNoMore) {
  const ScratchFolder folder;
  const std::string text = armFile("140");
  // A long provenance: more than the 64 KiB that an attribute of an old HDF5 file takes.
  for (const bool is_long : {false, true}) {
    std::string whole = text;
    if (is_long) whole.replace(whole.find("Measured"), 8, std::string(100'000, 'm'));
    const std::string arm = folder.write("mine.json", whole), session = folder.file(is_long ? "l.h5" : "s.h5");
    const std::string scene = folder.write("ball.json", R"({"underact_scene": 1, "title": "Ball", "arm": "mine.json",
        "constraints": [{"type": "sphere", "center_mm": [0, 0, 20], "radius_mm": 40}]})");
    ASSERT_EQ(runAndRecord(session, {"run", scene, "--hand", "probe", "--seconds", "0.5", "--fast"}).exit,
              Exit::Success);
    fs::remove(scene);
    fs::remove(arm);
    EXPECT_EQ(textAt(sameAgain(session), "made_from"), "hand");
    EXPECT_EQ(runCli({"replay", session, "--verify"}).exit, Exit::Success);
    const std::string again = session + ".again.h5";
    sameAgain(session, {"--out", again});
    EXPECT_EQ(runCli({"log", "info", "--diff", session, again}).exit, Exit::Success);
    const json::Value info = lines(runCli({"log", "info", session, "--json"}).out).at(0);
    EXPECT_EQ(textAt(info, "arm"), "mine.json");
    const json::Value* const kept = info.find("provenance")->find("arm")->find("file");
    ASSERT_NE(kept, nullptr);
    EXPECT_EQ(kept->text, whole);
  }
}

TEST(RerunCommand, OfAnArmFromAFileIsOfItsLengths) {
  const ScratchFolder folder;
  const auto finalPlace = [&](const std::string& arm) {
    const std::string scene =
        folder.write("ball.json", R"({"underact_scene": 1, "title": "Ball", "arm": ")" + arm + R"(",
        "constraints": [{"type": "sphere", "center_mm": [0, 0, 20], "radius_mm": 40}]})");
    const Outcome run = runCli({"run", scene, "--hand", "probe", "--seconds", "0.5", "--fast"});
    EXPECT_EQ(run.exit, Exit::Success) << run.err;
    return run.out;
  };
  folder.write("same.json", std::string(arm::fileOf("touch-measured")));
  folder.write("mine.json", armFile("140"));
  EXPECT_EQ(vectorAt(lines(finalPlace("same.json")).at(0), "final_p_mm"),
            vectorAt(lines(finalPlace("touch-measured")).at(0), "final_p_mm"));
  EXPECT_NE(vectorAt(lines(finalPlace("mine.json")).at(0), "final_p_mm"),
            vectorAt(lines(finalPlace("touch-measured")).at(0), "final_p_mm"));
}

TEST(RerunCommand, OfWhatAPersonDidGoesByTheRecordedInput) {
  const ScratchFolder folder;
  const std::string session = folder.file("s.h5"), again = folder.file("t.h5");
  recordEvents(session, sphereScene(), "tremor", Seed{5});
  EXPECT_EQ(textAt(sameAgain(session, {"--out", again}), "made_from"), "recorded input");
  EXPECT_EQ(runCli({"replay", again, "--verify"}).exit, Exit::Success);
  const Outcome difference = runCli({"log", "info", "--diff", session, again});
  EXPECT_EQ(difference.exit, Exit::Success) << difference.out;
  EXPECT_EQ(runCli({"rerun", session, "--out", again}).exit, Exit::File) << "it is there already";
  EXPECT_EQ(runCli({"rerun", session, "--out", again, "--overwrite"}).exit, Exit::Success);
}

TEST(RerunCommand, SaysWhereARunThatIsNotTheSameDiffers) {
  const ScratchFolder folder;
  const std::string session = folder.file("s.h5");
  ASSERT_EQ(
      runAndRecord(session, {"run", shipped("02_sphere.json"), "--hand", "tremor", "--seconds", "0.5", "--fast"}).exit,
      Exit::Success);
  // Another tremor in its provenance, as if another version had another hand. The texts are bytes of the file.
  std::string bytes = fileContent(session);
  const std::string before = "\"tremor_m\": 5e-04", after = "\"tremor_m\": 6e-04";
  const std::size_t at = bytes.find(before);
  ASSERT_NE(at, std::string::npos);
  bytes.replace(at, before.size(), after);
  std::ofstream(session, std::ios::binary) << bytes;
  const Outcome damaged = runCli({"rerun", session});  // its checksum tells
  EXPECT_EQ(damaged.exit, Exit::File) << damaged.out;
  EXPECT_NE(damaged.err.find("damaged"), std::string::npos) << damaged.err;
}

// Recorded once by a release build of this version; every later one must make the same run of it. Where what is
// computed was changed on purpose: UNDERACT_UPDATE_GOLDEN=1 records it anew.
TEST(RerunCommand, OfTheRunInTheRepositoryIsTheSameToTheBitInThisBuild) {
  const std::string path = std::string(UNDERACT_TEST_DATA) + "/golden/session_rerun.h5";
  if (std::getenv("UNDERACT_UPDATE_GOLDEN") != nullptr) {
    ASSERT_EQ(runAndRecord(path, {"run", shipped("20_scara.json"), "--hand", "tremor", "--seconds", "0.5", "--fast",
                                  "--seed", "7", "--record-details", "--overwrite"})
                  .exit,
              Exit::Success);
  }
  EXPECT_EQ(textAt(sameAgain(path), "made_from"), "hand");
  EXPECT_EQ(runCli({"replay", path, "--verify"}).exit, Exit::Success);
}

// Recorded when arms of other families than the Omni's took no integrator, with one in the scene that did not count.
TEST(RerunCommand, OfARobotWhoseIntegratorDidNotCountIsTheSameAndSoIsItsRerun) {
  const ScratchFolder folder;
  const std::string again = folder.file("again.h5");
  sameAgain(std::string(UNDERACT_TEST_DATA) + "/golden/session_integrator_1.h5", {"--out", again});
  EXPECT_EQ(textAt(sameAgain(again), "made_from"), "hand");
}

TEST(RerunCommand, OfSessionsOfEarlierVersionsGoesByTheirInput) {
  for (const char* name : {"session.h5", "session_0_1_0.h5"}) {
    const std::string path = std::string(UNDERACT_TEST_DATA) + "/golden/" + name;
    EXPECT_EQ(textAt(sameAgain(path), "made_from"), "recorded input") << name;
    EXPECT_TRUE(isNullAt(lines(runCli({"log", "info", path, "--json"}).out).at(0), "provenance")) << name;
  }
}

TEST(RemoveParticipant, DeletesTheSessionsAndWhatWasExportedFromThem) {
  const ScratchFolder folder;
  fs::create_directories(folder.file("below"));
  const std::vector<std::string> theirs{folder.file("a.h5"), folder.file("below/b.h5"), folder.file("a.csv"),
                                        folder.file("a.csv-metadata.json")};
  const std::vector<std::string> others{folder.file("c.h5"), folder.file("c.csv"), folder.file("c.csv-metadata.json"),
                                        folder.file("notes.csv")};
  const auto record = [](const std::string& path, const char* subject) {
    ASSERT_EQ(runAndRecord(path, {"run", shipped("02_sphere.json"), "--hand", "probe", "--seconds", "0.1", "--fast",
                                  "--subject", subject})
                  .exit,
              Exit::Success);
  };
  record(theirs[0], "S07");
  record(theirs[1], "S07");
  record(others[0], "S070");
  ASSERT_EQ(runCli({"log", "export", theirs[0], "--out", theirs[2]}).exit, Exit::Success);
  ASSERT_EQ(runCli({"log", "export", others[0], "--out", others[1]}).exit, Exit::Success);
  folder.write("notes.csv", "S07\n");
  const Outcome listed = runCli({"log", "remove", "--participant", "S07", folder.path()});
  EXPECT_EQ(listed.exit, Exit::Success) << listed.err;
  for (const std::string& path : theirs) {
    EXPECT_NE(listed.out.find(path + "\n"), std::string::npos) << path;
    EXPECT_TRUE(fs::exists(path)) << path;
  }
  EXPECT_NE(listed.err.find("Nothing was deleted"), std::string::npos) << listed.err;
  const Outcome removed = runCli({"log", "remove", "--participant", "S07", folder.path(), "--yes"});
  EXPECT_EQ(removed.exit, Exit::Success) << removed.err;
  for (const std::string& path : theirs) EXPECT_FALSE(fs::exists(path)) << path;
  for (const std::string& path : others) EXPECT_TRUE(fs::exists(path)) << path;
  EXPECT_EQ(runCli({"log", "remove", "--participant", "S07", folder.path()}).out, "");
  EXPECT_EQ(runCli({"log", "remove", "--participant", "", folder.path()}).exit, Exit::Usage);
}

TEST(RemoveParticipant, SaysWhichFilesItCannotRead) {
  const ScratchFolder folder;
  folder.write("damaged.h5", "no session");
  const Outcome outcome = runCli({"log", "remove", "--participant", "S07", folder.path(), "--yes"});
  EXPECT_EQ(outcome.exit, Exit::BadInput);
  EXPECT_NE(outcome.err.find("damaged.h5"), std::string::npos) << outcome.err;
  EXPECT_TRUE(fs::exists(folder.file("damaged.h5")));
}

}  // namespace
}  // namespace underact::test
