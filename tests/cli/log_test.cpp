#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <sstream>

#include "core/record/session.h"
#include "core/record/session_writer.h"
#include "tests/cli/session.h"

namespace underact::test {
namespace {

using cli::Exit;

/// Records two seconds of a shipped scene; more: further options.
void record(const std::string& file, const std::string& scene, std::vector<std::string> more = {}) {
  std::vector<std::string> arguments{"run", shipped(scene), "--hand",   "probe", "--seconds",
                                     "2",   "--fast",       "--record", file};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome outcome = runCli(arguments);
  ASSERT_EQ(outcome.exit, Exit::Success) << outcome.err;
}

/// The lines without the two columns that a clock measured.
std::vector<std::string> rowsWithoutClock(const std::string& csv) {
  std::istringstream lines(csv);
  std::vector<std::string> rows;
  std::string line;
  std::getline(lines, line);
  std::vector<bool> kept;
  std::istringstream names(line);
  for (std::string name; std::getline(names, name, ',');) kept.push_back(name != "lateness_us" && name != "tick_us");
  do {
    std::istringstream fields(line);
    std::string row, field;
    for (std::size_t index = 0; std::getline(fields, field, ','); ++index) {
      if (kept.at(index)) row += field + ",";
    }
    rows.push_back(row);
  } while (std::getline(lines, line));
  return rows;
}

}  // namespace

TEST(Log, InfoSaysWhatASessionHolds) {
  const ScratchPath session("s.h5");
  record(session.path(), "02_sphere.json", {"--name", "first", "--tags", "demo,sphere", "--subject", "S07"});
  const Outcome outcome = runCli({"log", "info", session.path(), "--json"});
  ASSERT_EQ(outcome.exit, Exit::Success) << outcome.err;
  const json::Value info = lines(outcome.out).at(0);
  EXPECT_EQ(numberAt(info, "ticks"), 2000);
  EXPECT_NEAR(numberAt(info, "duration_s"), 1.999, 1e-9);
  EXPECT_TRUE(info.find("complete")->boolean);
  EXPECT_EQ(textAt(info, "scene"), "Sphere");
  EXPECT_EQ(textAt(info, "arm"), "omni-thesis");
  EXPECT_EQ(textAt(info, "name"), "first");
  EXPECT_EQ(textAt(info, "tags"), "demo,sphere");
  EXPECT_EQ(textAt(info, "subject"), "S07");
  EXPECT_EQ(textAt(info, "ended"), "stopped");
  EXPECT_EQ(textAt(info, "notes"), "Hand probe, seed 1, arm model vendor-nominal.");
  EXPECT_FALSE(textAt(info, "version").empty());
  const Outcome table = runCli({"log", "info", session.path()});
  EXPECT_NE(table.out.find("2000 at 1000 Hz"), std::string::npos) << table.out;
}

TEST(Log, ExportGivesTheRowsOfACsvRecordingOfTheSameRun) {
  const ScratchPath session("s.h5"), csv("a.csv"), out("b.csv");
  record(session.path(), "14_circle_influence.json");
  record(csv.path(), "14_circle_influence.json");
  const Outcome outcome = runCli({"log", "export", session.path(), "--out", out.path()});
  ASSERT_EQ(outcome.exit, Exit::Success) << outcome.err;
  const std::vector<std::string> rows = rowsWithoutClock(fileContent(out.path()));
  EXPECT_EQ(rows.size(), 2001U);
  EXPECT_EQ(rows, rowsWithoutClock(fileContent(csv.path())));
  EXPECT_EQ(runCli({"log", "export", session.path(), "--format", "parquet"}).exit, Exit::Usage) << "it needs a name";
}

TEST(Log, VerifyFindsDamageAndSaysWhere) {
  const ScratchPath session("s.h5");
  record(session.path(), "02_sphere.json");
  const Outcome whole = runCli({"log", "verify", session.path()});
  EXPECT_EQ(whole.exit, Exit::Success) << whole.err;
  EXPECT_EQ(whole.out, "2000 ticks, all of them intact.\n");
  std::string bytes = fileContent(session.path());
  bytes[bytes.size() * 2 / 3] = static_cast<char>(bytes[bytes.size() * 2 / 3] ^ 4);
  std::ofstream(session.path(), std::ios::binary) << bytes;
  const Outcome damaged = runCli({"log", "verify", session.path()});
  EXPECT_EQ(damaged.exit, Exit::BadInput) << damaged.out;
  EXPECT_NE(damaged.err.find("damaged"), std::string::npos) << damaged.err;
  const ScratchPath csv("a.csv");
  const Outcome exported = runCli({"log", "export", session.path(), "--out", csv.path()});
  EXPECT_EQ(exported.exit, Exit::BadInput) << "what is left out is said";
}

TEST(Log, VerifySaysHowManyTicksAreMissingAndWhere) {
  const ScratchPath whole("s.h5"), gaps("t.h5");
  record(whole.path(), "02_sphere.json");
  Result<record::Session> session = record::Session::open(whole.path());
  Result<record::SessionWriter> writer = record::SessionWriter::create(gaps.path(), session.value().info().header);
  const record::ChangeRow& first = session.value().changes().front();
  ASSERT_TRUE(writer &&
              writer.value().begin(first.tick, first.revision, {}, session.value().scene(first).value()).empty());
  ASSERT_TRUE(session.value()
                  .eachBlock(
                      [&](const record::Block& block, std::int64_t) {
                        for (const servo::TickRecord& tick : record::unpackTicks(block)) {
                          const bool is_missing = tick.tick < 4 || (tick.tick > 500 && tick.tick <= 700);
                          if (!is_missing) EXPECT_TRUE(writer.value().add(tick).empty());
                        }
                        return true;
                      },
                      [](const record::Gap&) {})
                  .empty());
  ASSERT_TRUE(writer.value().end({0, 210, 0, record::EndReason::Stopped}).empty());
  const Outcome outcome = runCli({"log", "verify", gaps.path()});
  EXPECT_EQ(outcome.exit, Exit::BadInput) << outcome.out;
  EXPECT_NE(outcome.err.find("Ticks 1 to 3 are missing"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("Ticks 501 to 700 are missing"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("210 ticks or events are missing"), std::string::npos) << outcome.err;
}

TEST(Log, ExportAndPlotWriteOnlyTheNameThatTheyWereGiven) {
  const ScratchFolder folder;
  const std::string session = folder.file("s.h5"), mine = folder.write("mine.txt", "mine");
  record(session, "02_sphere.json");
  const std::string before = fileContent(session);
  for (const char* name : {"link.csv", "b.csv-metadata.json", "link.png"})
    std::filesystem::create_symlink(mine, folder.file(name));
  for (const char* name : {"pipe.csv", "c.csv-metadata.json", "pipe.png"})
    ASSERT_EQ(::mkfifo(folder.file(name).c_str(), 0600), 0);
  for (const char* name : {"link.csv", "b.csv", "pipe.csv", "c.csv", "s.h5"})
    EXPECT_EQ(runCli({"log", "export", session, "--out", folder.file(name)}).exit, Exit::File) << name;
  for (const char* name : {"link.png", "pipe.png"})
    EXPECT_EQ(runCli({"log", "plot", session, "--kind", "error", "--out", folder.file(name)}).exit, Exit::File) << name;
  EXPECT_EQ(fileContent(mine), "mine");
  EXPECT_EQ(fileContent(session), before);
  EXPECT_FALSE(std::filesystem::exists(folder.file("b.csv")) || std::filesystem::exists(folder.file("c.csv")));
}

TEST(Log, ExportTakesTheFormatOfTheNameInAnyCaseAndRefusesAnother) {
  const ScratchFolder folder;
  const std::string session = folder.file("s.h5");
  record(session, "02_sphere.json");
  EXPECT_EQ(runCli({"log", "export", session, "--out", folder.file("A.CSV")}).exit, Exit::Success);
  EXPECT_EQ(runCli({"log", "export", session, "--format", "csv", "--out", folder.file("a.txt")}).exit, Exit::Success);
  for (const auto& [format, name] :
       {std::pair{"csv", "a.Parquet"}, std::pair{"mcap", "a.csv"}, std::pair{"", "a.html"}}) {
    std::vector<std::string> words{"log", "export", session, "--out", folder.file(name)};
    if (*format != '\0') words.insert(words.end(), {"--format", format});
    EXPECT_EQ(runCli(words).exit, Exit::Usage) << name;
    EXPECT_FALSE(std::filesystem::exists(folder.file(name))) << name;
  }
}

TEST(Log, RecoverLeavesAClosedSessionAsItIs) {
  const ScratchPath session("s.h5");
  record(session.path(), "02_sphere.json");
  const std::string before = fileContent(session.path());
  const Outcome outcome = runCli({"log", "recover", session.path()});
  EXPECT_EQ(outcome.exit, Exit::Success) << outcome.err;
  EXPECT_EQ(fileContent(session.path()), before);
  EXPECT_EQ(runCli({"log", "recover", "/dev/null/nowhere/s.h5"}).exit, Exit::File);
}

TEST(Log, RefusesAFileThatIsNoSession) {
  const ScratchFile text("tick,time_s\n1,0.001\n", "s.h5");
  for (const char* command : {"info", "verify", "export"}) {
    const Outcome outcome = runCli({"log", command, text.path()});
    EXPECT_EQ(outcome.exit, Exit::File) << command;
    EXPECT_NE(outcome.err.find("This is not a session"), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
}

TEST(ReplayCommand, VerifiesToTheBitAndFindsAForgedForce) {
  const ScratchPath session("s.h5");
  record(session.path(), "20_scara.json");
  const Outcome outcome = runCli({"replay", session.path(), "--verify"});
  ASSERT_EQ(outcome.exit, Exit::Success) << outcome.err;
  const json::Value answer = lines(outcome.out).at(0);
  EXPECT_TRUE(answer.find("identical")->boolean);
  EXPECT_EQ(numberAt(answer, "identical_ticks"), 2000);
  EXPECT_EQ(runCli({"replay", session.path(), "--verify", "--kp", "1"}).exit, Exit::Usage);
}

TEST(ReplayCommand, NamesALawThatWasMendedSinceAndCountsTheTicksThatDiffer) {
  const std::string session = UNDERACT_TEST_DATA "/golden/session_friction_1.h5";
  for (const char* const command : {"replay", "rerun"}) {
    std::vector<std::string> words{command, session};
    if (words[0] == "replay") words.emplace_back("--verify");
    const Outcome outcome = runCli(words);
    EXPECT_EQ(outcome.exit, Exit::BadInput) << command;
    EXPECT_NE(outcome.err.find("The law of friction was mended"), std::string::npos) << outcome.err;
    const json::Value answer = lines(outcome.out).at(0);
    EXPECT_EQ(answer.find("mended_laws")->items.at(0).text, "friction");
    EXPECT_EQ(numberAt(answer, "first_difference_tick"), 226) << "the first slip";
    EXPECT_EQ(numberAt(answer, "different_ticks"), 225) << command;
  }
}

TEST(ReplayCommand, ComparesOtherGainsWithWhatWasRecorded) {
  const ScratchPath session("s.h5"), csv("now.csv");
  record(session.path(), "02_sphere.json");
  const Outcome same = runCli({"replay", session.path()});
  ASSERT_EQ(same.exit, Exit::Success) << same.err;
  EXPECT_EQ(numberAt(*lines(same.out).at(0).find("force_difference"), "max_N"), 0.0);
  const Outcome softer = runCli({"replay", session.path(), "--kp", "0.01", "--record", csv.path()});
  ASSERT_EQ(softer.exit, Exit::Success) << softer.err;
  const json::Value answer = lines(softer.out).at(0);
  const double recorded_N = numberAt(*answer.find("recorded"), "mean_force_N");
  const double now_N = numberAt(*answer.find("replayed"), "mean_force_N");
  EXPECT_LT(now_N, 0.5 * recorded_N);
  EXPECT_EQ(rowsWithoutClock(fileContent(csv.path())).size(), 2001U);
  const Outcome other = runCli({"replay", session.path(), "--scene", shipped("04_plane.json")});
  EXPECT_EQ(other.exit, Exit::Success) << other.err;
  EXPECT_GT(numberAt(*lines(other.out).at(0).find("force_difference"), "max_N"), 0.0);
  EXPECT_EQ(runCli({"replay", session.path(), "--kp", "-1"}).exit, Exit::Usage);
}

TEST(ReplayCommand, SetsAnySettingByItsPathOrItsKey) {
  const ScratchPath session("s.h5");
  record(session.path(), "02_sphere.json");
  const auto replayed = [&](const std::vector<std::string>& how) {
    std::vector<std::string> words{"replay", session.path()};
    words.insert(words.end(), how.begin(), how.end());
    return runCli(words);
  };
  const Outcome alias = replayed({"--kp", "0.01"});
  ASSERT_EQ(alias.exit, Exit::Success) << alias.err;
  EXPECT_EQ(replayed({"--set", "kp_N_per_mm=0.01"}).out, alias.out);
  EXPECT_EQ(replayed({"--set", "/constraints/*/control/kp_N_per_mm=0.01"}).out, alias.out);
  EXPECT_EQ(replayed({"--set", "/constraints/0/control/kp_N_per_mm=0.01", "--set", "passivity=off"}).exit,
            Exit::Success);
  const Outcome rough = replayed({"--set", "/constraints/0/friction/static=0.4"});
  ASSERT_EQ(rough.exit, Exit::Success) << rough.err;
  EXPECT_GT(numberAt(*lines(rough.out).at(0).find("force_difference"), "max_N"), 0.0);
  EXPECT_EQ(replayed({"--t", "0.5"}).exit, Exit::Success);  // nobody has an influence there
  const Outcome wrong = replayed({"--set", "/control/lawn=P"});
  EXPECT_EQ(wrong.exit, Exit::BadInput);
  EXPECT_NE(wrong.err.find("Did you mean \"/control/law\"?"), std::string::npos) << wrong.err;
  EXPECT_EQ(replayed({"--set", "kp_N_per_mm=-1"}).exit, Exit::BadInput);
  EXPECT_EQ(replayed({"--set", "kp_N_per_mm"}).exit, Exit::Usage);
  EXPECT_EQ(replayed({"--verify", "--set", "law=PD"}).exit, Exit::Usage);
}

}  // namespace underact::test
