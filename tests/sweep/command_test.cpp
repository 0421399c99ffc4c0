#include "app/sweeper/command.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <sstream>

#include "app/sweeper/progress.h"
#include "tests/cli/session.h"
#include "tests/sweep/rig.h"

namespace underact::test {
namespace {

using cli::Exit;

std::vector<std::string> smallSweep(const std::string& out, std::vector<std::string> more = {}) {
  std::vector<std::string> all{"hands", "--scene", scene("02_sphere.json"), "--draws", "6", "--seconds", "0.05",
                               "--out", out};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

void writeTo(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

TEST(SweepCommand, SaysItsVersionAndWhetherItHasMpi) {
  const Given given = sweepHere({"--version"});
  EXPECT_EQ(given.exit, Exit::Success);
#ifdef UNDERACT_MPIRUN
  EXPECT_NE(given.out.find("(MPI: Open MPI v"), std::string::npos) << given.out;
#else
  EXPECT_NE(given.out.find("(MPI: "), std::string::npos) << given.out;
#endif
}

TEST(SweepCommand, ListsTheKinds) {
  EXPECT_NE(sweepHere({"list"}).out.find("hands: What does the arm do"), std::string::npos);
  EXPECT_EQ(textAt(lines(sweepHere({"list", "--json"}).out).at(0), "kind"), "hands");
}

TEST(Programs, SayByTheirNamesThatTheirResultsCouldNotBeWritten) {
  std::istringstream in;
  std::ostringstream out, err;
  out.setstate(std::ios::badbit);  // as a pipe that nobody reads
  const cli::Streams streams{in, out, err};
  EXPECT_EQ(sweep::execute({"list"}, streams, nullptr), Exit::File);
  EXPECT_EQ(err.str(), "underact-sweep: the results could not be written.\n");
  err.str("");
  EXPECT_EQ(cli::execute({"--version"}, streams), Exit::File);
  EXPECT_EQ(err.str(), "underact-cli: the results could not be written.\n");
}

TEST(SweepCommand, NeedsAKindAndAPlaceForTheResult) {
  EXPECT_EQ(sweepHere({}).exit, Exit::Usage);
  EXPECT_EQ(sweepHere({"feet"}).exit, Exit::Usage);
  EXPECT_EQ(sweepHere({"hands", "--scene", scene("02_sphere.json")}).exit, Exit::Usage);
  EXPECT_EQ(sweepHere(smallSweep("x.csv", {"--dry-run"})).exit, Exit::Usage);
  EXPECT_EQ(sweepHere(smallSweep("x.csv", {"--draws", "0"})).exit, Exit::Usage);
  EXPECT_EQ(sweepHere({"hands", "--draws", "0", "--scene", scene("02_sphere.json"), "--out", "x.csv"}).exit,
            Exit::Usage);
}

TEST(SweepCommand, GivesTheSameBytesOnOneThreadAndOnMany) {
  const ScratchFolder folder;
  const std::string one = folder.file("1.csv"), four = folder.file("4.csv");
  EXPECT_EQ(sweepHere(smallSweep(one, {"--threads", "1"})).exit, Exit::Success);
  EXPECT_EQ(sweepHere(smallSweep(four, {"--threads", "4"})).exit, Exit::Success);
  EXPECT_EQ(textOf(one), textOf(four));
  EXPECT_FALSE(std::filesystem::exists(one + ".part"));
}

TEST(SweepCommand, GivenTwiceRunsNothingTwice) {
  const ScratchFolder folder;
  const std::string out = folder.file("r.csv");
  EXPECT_EQ(sweepHere(smallSweep(out)).err, out + ": 6 cells, 6 of them run now.\n");
  const std::string text = textOf(out);
  EXPECT_EQ(sweepHere(smallSweep(out)).err, out + ": 6 cells, 0 of them run now.\n");
  EXPECT_EQ(textOf(out), text);
  EXPECT_FALSE(std::filesystem::exists(out + ".part"));
}

TEST(SweepCommand, OverwritesNoOtherResult) {
  const ScratchFolder folder;
  const std::string out = folder.file("r.csv");
  EXPECT_EQ(sweepHere(smallSweep(out)).exit, Exit::Success);
  const std::string text = textOf(out);
  const Given given = sweepHere(smallSweep(out, {"--seed", "2"}));
  EXPECT_EQ(given.exit, Exit::File);
  EXPECT_NE(given.err.find("is not overwritten"), std::string::npos);
  EXPECT_EQ(textOf(out), text);
}

TEST(SweepCommand, IsAnotherOneWhereASceneHasChanged) {
  const ScratchFolder folder;
  const std::string here = folder.file("s.json"), out = folder.file("r.csv");
  writeTo(here, textOf(scene("02_sphere.json")));
  const std::vector<std::string> command{"hands", "--scene", here, "--draws", "1", "--seconds", "0.01", "--out", out};
  EXPECT_EQ(sweepHere(command).exit, Exit::Success);
  writeTo(here, textOf(scene("02_sphere.json")) + "\n");
  EXPECT_EQ(sweepHere(command).exit, Exit::File);
}

TEST(SweepCommand, TellsAFolderThatCannotBeWritten) {
  const Given given = sweepHere(smallSweep("/dev/null/r.csv"));
  EXPECT_EQ(given.exit, Exit::File);
  EXPECT_NE(given.err.find("/dev/null/r.csv.part"), std::string::npos) << given.err;
  EXPECT_EQ(sweepHere(smallSweep("/dev/null")).exit, Exit::File);
}

TEST(SweepCommand, MeasuresWithoutAResult) {
  const Given given = sweepHere({"hands", "--scene", scene("02_sphere.json"), "--draws", "1000", "--seconds", "0.5",
                                 "--threads", "2", "--dry-run"});
  EXPECT_EQ(given.exit, Exit::Success);
  EXPECT_TRUE(given.out.starts_with("1000 cells. 8 of them, measured one by one, took 0.0")) << given.out;
  EXPECT_NE(given.out.find("on 2 threads"), std::string::npos);
}

TEST(SweepCommand, IsReadFromAFileToTheSameBytes) {
  const ScratchFolder folder;
  const std::string file = folder.file("sweep.json"), one = folder.file("1.csv"), two = folder.file("2.csv");
  writeTo(file, R"({"underact_sweep": 1, "kind": "hands", "seed": 3,
                    "options": {"scene": [")" +
                    scene("02_sphere.json") +
                    R"("], "rate_hz": [500, 1000], "draws": 2, "seconds": 0.05, "mass_kg": "0.1:0.2"}})");
  const Given given = sweepHere({"from", file, "--out", one});
  EXPECT_EQ(given.exit, Exit::Success) << given.err;
  EXPECT_EQ(sweepHere({"hands", "--scene", scene("02_sphere.json"), "--rate_hz", "500", "1000", "--draws", "2",
                       "--seconds", "0.05", "--mass_kg", "0.1:0.2", "--seed", "3", "--out", two})
                .exit,
            Exit::Success);
  EXPECT_EQ(textOf(one), textOf(two));
}

TEST(SweepCommand, TellsWhatIsWrongWithItsFile) {
  const ScratchFolder folder;
  const std::string file = folder.file("sweep.json");
  const auto expectSentence = [&](const std::string& text) {
    writeTo(file, text);
    return sweepHere({"from", file, "--out", folder.file("r.csv")});
  };
  const Given many = expectSentence(R"({"underact_sweep": 2, "kind": "feet", "seed": 1.5,
    "options": {"draws": true, "draws": 1}, "more": 1})");
  EXPECT_EQ(many.exit, Exit::BadInput);
  for (const char* words : {"must be 1", "must be \"hands\"", "from 0 to 2^53", "options.draws", "twice", "more"})
    EXPECT_NE(many.err.find(words), std::string::npos) << words << " in\n" << many.err;
  EXPECT_EQ(expectSentence("{").exit, Exit::BadInput);
  EXPECT_EQ(expectSentence("[]").exit, Exit::BadInput);
  EXPECT_EQ(expectSentence(R"({"underact_sweep": 1})").exit, Exit::BadInput);
  EXPECT_EQ(expectSentence(R"({"underact_sweep": 1, "kind": "hands", "options": {}})").exit, Exit::Usage);
  EXPECT_EQ(sweepHere({"from", folder.file("none.json"), "--out", "x"}).exit, Exit::File);
}

TEST(SweepProgress, SaysHowFarItIsAndHowLongItTakes) {
  using std::chrono::seconds;
  std::ostringstream err;
  sweep::Progress progress(err, false, false, 10, 110);
  const auto begin = std::chrono::steady_clock::now();
  progress.show(20, begin + seconds(1));
  EXPECT_EQ(err.str(), "") << "a line in 10 s";
  progress.show(30, begin + seconds(20));  // 20 cells in 20 s, 80 to go
  EXPECT_EQ(err.str(), "30 of 110 cells, 27 %, about 80 s left\n");
  progress.show(40, begin + seconds(21));
  EXPECT_EQ(err.str(), "30 of 110 cells, 27 %, about 80 s left\n");
}

TEST(SweepProgress, OnATerminalStaysInItsLineAndQuietSaysNothing) {
  using std::chrono::seconds;
  std::ostringstream err, nothing;
  sweep::Progress progress(err, true, false, 0, 10);
  const auto begin = std::chrono::steady_clock::now();
  progress.show(0, begin + seconds(2));
  progress.show(5, begin + seconds(4));
  progress.end();
  EXPECT_TRUE(err.str().starts_with("\r0 of 10 cells, 0 %")) << err.str();
  EXPECT_NE(err.str().find("\r5 of 10 cells, 50 %, about 4 s left"), std::string::npos) << err.str();
  const std::string text = err.str();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
  sweep::Progress quiet(nothing, false, true, 0, 10);
  quiet.show(5, begin + seconds(100));
  EXPECT_EQ(nothing.str(), "");
}

TEST(SweepProgress, SaysTimesAsPeopleDo) {
  EXPECT_EQ(sweep::inWords(0.4), "less than a second");
  EXPECT_EQ(sweep::inWords(99.0), "99 s");
  EXPECT_EQ(sweep::inWords(120.0), "2 min");
  EXPECT_EQ(sweep::inWords(7800.0), "2 h 10 min");
}

}  // namespace
}  // namespace underact::test
