// What a session says of the run that made it: enough to tell two runs apart, and to make one again.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "core/record/session.h"
#include "tests/cli/session.h"
#include "tests/core/mesh_file/some_meshes.h"

namespace underact::test {
namespace {

using cli::Exit;

constexpr const char* kHandFile = R"({"underact_hand": 1,
  "hand": {"mass_kg": 0.05, "damping_N_s_per_m": 3, "stiffness_N_per_m": 250},
  "path": [{"t_s": 0, "p_mm": [0, 0, 60]}, {"t_s": 0.3, "p_mm": [5, 3, 45.123456789]}]})";

/// Records a run of a shipped scene; more: further options.
Outcome recordRun(const std::string& path, const std::vector<std::string>& more,
                  const std::string& scene = "02_sphere") {
  std::vector<std::string> words{"run", shipped(scene + ".json"), "--seconds", "0.3", "--fast", "--record", path};
  words.insert(words.end(), more.begin(), more.end());
  return runCli(words);
}

json::Value infoOf(const std::string& path) {
  const Outcome outcome = runCli({"log", "info", path, "--json"});
  EXPECT_EQ(outcome.exit, Exit::Success) << outcome.err;
  return lines(outcome.out).at(0);
}

/// The value behind a path of keys; a null value where there is none.
const json::Value& at(const json::Value& object, const std::vector<std::string>& keys) {
  static const json::Value kNothing;
  const json::Value* found = &object;
  for (const std::string& key : keys) {
    found = found->find(key);
    if (found == nullptr) return kNothing;
  }
  return *found;
}

TEST(Provenance, WithNotesSeedHandAndArmModelStay) {
  const ScratchPath session("s.h5");
  ASSERT_EQ(
      recordRun(session.path(), {"--hand", "tremor", "--seed", "42", "--arm-model", "ideal", "--notes", "mine"}).exit,
      Exit::Success);
  const json::Value info = infoOf(session.path());
  EXPECT_EQ(textAt(info, "notes"), "mine");
  const json::Value& run = at(info, {"provenance", "run"});
  EXPECT_EQ(at(run, {"seed"}).number, 42);
  EXPECT_EQ(at(run, {"hand", "name"}).text, "tremor");
  EXPECT_EQ(at(run, {"hand", "mass_kg"}).number, 0.1);
  EXPECT_EQ(at(run, {"hand", "tremor_m"}).number, 0.5e-3);
  EXPECT_EQ(at(run, {"arm_model", "name"}).text, "ideal");
  EXPECT_EQ(at(run, {"arm_model", "friction_N"}).number, 0.0);
  const Outcome table = runCli({"log", "info", session.path()});
  EXPECT_NE(table.out.find("seed          42"), std::string::npos) << table.out;
}

TEST(Provenance, NamesProgramMachineArmServoGainsAndClocks) {
  const ScratchPath session("s.h5");
  ASSERT_EQ(recordRun(session.path(), {"--hand", "probe", "--subject", "S07", "--consent", "form 2"}).exit,
            Exit::Success);
  const json::Value info = infoOf(session.path());
  const json::Value& all = at(info, {"provenance"});
  EXPECT_EQ(at(all, {"underact_provenance"}).number, 1);
  EXPECT_EQ(at(all, {"session"}).text.size(), 32U);
  EXPECT_EQ(at(all, {"session"}).text, textAt(info, "session_id"));
  for (const std::vector<std::string>& keys : std::vector<std::vector<std::string>>{{"program", "version"},
                                                                                    {"program", "build_id"},
                                                                                    {"program", "compiler"},
                                                                                    {"machine", "kernel"},
                                                                                    {"machine", "architecture"},
                                                                                    {"arm", "name"},
                                                                                    {"arm", "file"},
                                                                                    {"device", "title"},
                                                                                    {"servo", "scheduling", "wanted"},
                                                                                    {"servo", "scheduling", "granted"}})
    EXPECT_FALSE(at(all, keys).text.empty()) << keys.back();
  EXPECT_GT(at(all, {"program", "libraries"}).items.size(), 5U);
  EXPECT_EQ(at(all, {"servo", "rate_hz"}).number, 1000);
  EXPECT_EQ(at(all, {"servo", "force_share"}).number, 1);
  ASSERT_EQ(at(all, {"gains"}).items.size(), 1U);  // those that the scene leaves out, too
  const json::Value& gains = at(all, {"gains"}).items[0];
  EXPECT_EQ(vectorAt(gains, "kp_N_per_mm").size(), 3);
  EXPECT_EQ(vectorAt(gains, "ki_N_per_mm_s"), Vec3::Zero());
  EXPECT_EQ(textAt(gains, "law"), "P");
  EXPECT_EQ(textAt(info, "subject"), "S07");
  EXPECT_EQ(textAt(info, "consent"), "form 2");
  const json::Value& clock = at(info, {"clock"});
  ASSERT_GE(clock.items.size(), 1U);
  EXPECT_EQ(at(clock.items.back(), {"tick"}).number, 300);
  EXPECT_GT(at(clock.items.back(), {"unix_ns"}).number, 1.5e18);
  EXPECT_GT(at(clock.items.back(), {"monotonic_ns"}).number, 0.0);
}

TEST(Provenance, OfARunInRealTimeSaysTheSchedulingThatWasGranted) {
  const ScratchPath session("s.h5");
  ASSERT_EQ(runCli({"run", shipped("02_sphere.json"), "--hand", "probe", "--seconds", "0.3", "--scheduling", "normal",
                    "--record", session.path()})
                .exit,
            Exit::Success);
  EXPECT_EQ(textAt(infoOf(session.path()), "scheduling"), "normal");
}

TEST(Provenance, HasTheHandsFileAndTheMeshsChecksum) {
  const ScratchFolder folder;
  folder.write("patella.obj", obj(cube(20.0F)));
  folder.write("walk.txt", "0 0 0\n10 0 0\n20 5 0\n30 0 5\n");
  const std::string hand = folder.write("mine.json", kHandFile);
  const std::string scene = folder.write("knee.json", R"({"underact_scene": 1, "title": "Knee", "constraints": [
      {"name": "patella", "type": "mesh", "file": "patella.obj"},
      {"name": "walk", "type": "curve", "file": "walk.txt"}]})");
  const std::string session = folder.file("s.h5");
  ASSERT_EQ(runCli({"run", scene, "--hand", hand, "--seconds", "0.2", "--fast", "--record", session}).exit,
            Exit::Success);
  const json::Value info = infoOf(session);
  const json::Value& kept = at(info, {"provenance", "run", "hand"});
  EXPECT_EQ(at(kept, {"file"}).text, kHandFile);
  EXPECT_EQ(at(kept, {"name"}).text, "mine.json");
  ASSERT_EQ(at(kept, {"path"}).items.size(), 2U);
  EXPECT_EQ(vectorAt(at(kept, {"path"}).items[1], "p_m").z(), 1e-3 * 45.123456789);
  const json::Value& files = at(info, {"provenance", "files"});
  ASSERT_EQ(files.items.size(), 2U);
  EXPECT_EQ(textAt(files.items[0], "file"), "patella.obj");
  EXPECT_EQ(textAt(files.items[0], "xxh3_128").size(), 32U);
  EXPECT_EQ(textAt(files.items[1], "file"), "walk.txt");
  EXPECT_EQ(textAt(files.items[1], "xxh3_128").size(), 32U);
  EXPECT_EQ(fileContent(session).find(folder.file("")), std::string::npos);
  folder.write("walk.txt", "0 0 0\n10 0 0\n20 5 0\n30 0 6\n");  // another curve of that name
  EXPECT_NE(runCli({"rerun", session}).err.find("its checksum differs"), std::string::npos);
}

TEST(Difference, IsEmptyForARunComparedWithItself) {
  const ScratchPath a("a.h5"), b("b.h5");
  for (const ScratchPath* path : {&a, &b})
    ASSERT_EQ(recordRun(path->path(), {"--hand", "tremor", "--notes", path->path()}).exit, Exit::Success);
  const Outcome outcome = runCli({"log", "info", "--diff", a.path(), b.path()});
  EXPECT_EQ(outcome.exit, Exit::Success) << outcome.out;
  EXPECT_EQ(outcome.out, "Nothing that was run differs.\n");
}

TEST(Difference, NamesWhateverWasRunOtherwise) {
  const ScratchFolder folder;
  const std::string hand = folder.write("mine.json", kHandFile);
  const std::string default_value = folder.file("usual.h5");
  ASSERT_EQ(recordRun(default_value, {"--hand", "tremor"}).exit, Exit::Success);
  struct Case {
    std::vector<std::string> options;
    std::string scene, named;
  };
  const std::vector<Case> cases{{{"--hand", "tremor", "--seed", "2"}, "02_sphere", "run.seed"},
                                {{"--hand", hand}, "02_sphere", "run.hand.name"},
                                {{"--hand", "tremor", "--arm-model", "ideal"}, "02_sphere", "run.arm_model.friction_N"},
                                {{"--hand", "tremor", "--rate", "2000"}, "02_sphere", "servo.rate_hz"},
                                {{"--hand", "tremor", "--max-late", "7"}, "02_sphere", "servo.max_late"},
                                {{"--hand", "tremor", "--space", "joint"}, "02_sphere", "gains[ball].space"},
                                {{"--hand", "tremor", "--subject", "S07"}, "02_sphere", "subject"},
                                {{"--hand", "tremor"}, "04_plane", "scene.title"}};
  for (const Case& one : cases) {
    const std::string other = folder.file("other.h5");
    std::vector<std::string> options = one.options;
    options.emplace_back("--overwrite");
    ASSERT_EQ(recordRun(other, options, one.scene).exit, Exit::Success) << one.named;
    const Outcome outcome = runCli({"log", "info", "--diff", default_value, other, "--json"});
    EXPECT_EQ(outcome.exit, Exit::BadInput) << one.named;
    EXPECT_NE(outcome.out.find("\"what\": \"" + one.named + "\""), std::string::npos) << one.named << outcome.out;
  }
  EXPECT_EQ(runCli({"log", "info"}).exit, Exit::Usage);
  EXPECT_EQ(runCli({"log", "info", default_value, "--diff", default_value, default_value}).exit, Exit::Usage);
}

TEST(Details, AreTheTrueTipTheHandsForceAndEachConstraintsShare) {
  const ScratchPath session("s.h5"), without("t.h5");
  ASSERT_EQ(recordRun(session.path(), {"--hand", "probe", "--record-details"}, "10_two_spheres_nearest").exit,
            Exit::Success);
  ASSERT_EQ(recordRun(without.path(), {"--hand", "probe"}).exit, Exit::Success);
  record::Session read = record::Session::open(session.path()).value();
  EXPECT_EQ(read.rows(record::kTruth), 300);
  const std::size_t constraints = read.scene(read.changes()[0]).value().constraints.size();
  EXPECT_EQ(read.rows(record::kConstraints), 300 * static_cast<std::int64_t>(constraints));
  std::vector<Vec3> sums(301, Vec3::Zero());
  const std::vector<record::Block> forces = read.readBlocks(record::kConstraints, 0, 1000).value();
  for (const record::Block& block : forces) {
    for (const servo::ConstraintRow& row : record::unpack<servo::ConstraintRow>(block))
      if (row.acts) sums[static_cast<std::size_t>(row.tick)] += row.f_T_W;
  }
  std::vector<Vec3> true_tips(301, Vec3::Zero());
  const std::vector<record::Block> truths = read.readBlocks(record::kTruth, 0, 1000).value();
  for (const record::Block& block : truths) {
    for (const servo::TruthRow& row : record::unpack<servo::TruthRow>(block)) {
      true_tips[static_cast<std::size_t>(row.tick)] = row.truth.p_WT;
      EXPECT_TRUE(row.truth.f_hand_T_W.allFinite());
    }
  }
  double max_apart_m = 0.0;
  const std::vector<record::Block> ticks = read.readTicks(0, 1000).value();
  for (const record::Block& block : ticks) {
    for (const servo::TickRecord& row : record::unpackTicks(block)) {
      EXPECT_LT((sums[static_cast<std::size_t>(row.tick)] - row.f_asked_T_W).norm(), 1e-12) << row.tick;
      max_apart_m = std::max(max_apart_m, (true_tips[static_cast<std::size_t>(row.tick)] - row.p_WT).norm());
    }
  }
  EXPECT_GT(max_apart_m, 0.0) << "encoders round";
  EXPECT_LT(max_apart_m, 0.2e-3);
  record::Session none = record::Session::open(without.path()).value();
  EXPECT_EQ(none.rows(record::kTruth), 0);
  EXPECT_EQ(runCli({"replay", session.path(), "--verify"}).exit, Exit::Success);
  EXPECT_EQ(runCli({"log", "verify", session.path()}).exit, Exit::Success);
}

}  // namespace
}  // namespace underact::test
