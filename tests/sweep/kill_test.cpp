#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "tests/support/comes.h"
#include "tests/sweep/rig.h"

// What only a process has: kills, signals, disks that fill up, and other ranks. No sanitizer knows what a fork of
// TSan's runtime may do.
#if !defined(__SANITIZE_THREAD__)
namespace underact::test {
namespace {

constexpr std::size_t kCells = 200;

/// What is run, whatever runs it.
std::string sweepTo(const std::string& out) {
  return gatedProgram() + " gated --out '" + out + "'";
}

class SweepProcess : public testing::Test {
 protected:
  /// All cells on one thread, without a break: once for all tests.
  static void SetUpTestSuite() {
    whole_ = new ScratchFolder;
    Process process(sweepTo(whole_->file("r.csv")) + " --threads 1", whole_->file("said"));
    ASSERT_EQ(process.wait(), 0) << textOf(whole_->file("said"));
  }
  static void TearDownTestSuite() { delete whole_; }
  static std::string expected() { return textOf(whole_->file("r.csv")); }

  std::string output() const { return contentOf(message_); }
  /// The command, in which cells from so many on wait until more are let in.
  std::string gated(std::size_t open, const std::string& command) const {
    admit(open);
    return "env UNDERACT_TEST_GATE='" + gate_ + "' " + command;
  }
  void admit(std::size_t open) const { std::ofstream(gate_) << open; }
  /// Lets in one after the other until the process ends; its exit status. For signals of which nobody sees when they
  /// have arrived: some 2 s pass before the last cell is let in.
  int letInUntilTheEnd(Process& process, std::size_t open) const {
    while (open < kCells && !process.hasEnded()) {
      admit(++open);
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return process.wait();
  }
  /// Runs to the end; the exit status.
  int run(const std::string& command) const { return Process(command, message_).wait(); }
  /// The same sweep to its end, which is the same to the byte, and what was done before is not done again. before: how
  /// many that is; one more, at most, for each thread that ran.
  void expectToGoOn(const std::string& command, std::size_t before, std::size_t ran = 0) const {
    EXPECT_TRUE(comes([&] { return isFree(out_); }));
    EXPECT_FALSE(std::filesystem::exists(out_));
    const std::size_t done = cellsIn(out_);
    EXPECT_GE(done, before);
    EXPECT_LE(done, before + ran);
    EXPECT_LT(done, kCells);
    EXPECT_EQ(run(command), 0) << output();
    EXPECT_EQ(runNow(message_), static_cast<int>(kCells - done)) << output();
    EXPECT_TRUE(textOf(out_) == expected());
    EXPECT_FALSE(std::filesystem::exists(out_ + ".part"));
  }

  ScratchFolder folder_;
  std::string out_ = folder_.file("r.csv"), message_ = folder_.file("said"), gate_ = folder_.file("gate");
  static inline ScratchFolder* whole_ = nullptr;
};

TEST_F(SweepProcess, KilledAndStartedAgainGivesTheSameBytes) {
  Process process(gated(4, sweepTo(out_) + " --threads 2"), message_);
  ASSERT_TRUE(waitForCells(out_, 4)) << output();
  kill(process.pid(), SIGKILL);
  EXPECT_EQ(process.wait(), -SIGKILL);
  expectToGoOn(sweepTo(out_) + " --threads 3", 4);
}

TEST_F(SweepProcess, AskedToEndEndsInOrderAndSaysHowToGoOn) {
  for (const int signal : {SIGTERM, SIGINT}) {
    Process process(gated(4, sweepTo(out_) + " --threads 2"), message_);
    ASSERT_TRUE(waitForCells(out_, 4)) << output();
    kill(process.pid(), signal);
    ASSERT_TRUE(comes([&] { return output().find("Ending after the running cells") != std::string::npos; }));
    EXPECT_FALSE(process.hasEnded());
    admit(kCells);
    EXPECT_EQ(process.wait(), 4) << output();
    EXPECT_NE(output().find("of 200 cells are done and saved in"), std::string::npos) << output();
    EXPECT_NE(output().find("The same command continues"), std::string::npos) << output();
    expectToGoOn(sweepTo(out_), 4, 2);
    std::filesystem::remove(out_);
  }
}

TEST_F(SweepProcess, AskedTwiceWaitsForNoCell) {
  Process process(gated(4, sweepTo(out_) + " --threads 2"), message_);
  ASSERT_TRUE(waitForCells(out_, 4)) << output();
  kill(process.pid(), SIGTERM);
  ASSERT_TRUE(comes([&] { return output().find("A second signal ends at once") != std::string::npos; }));
  kill(process.pid(), SIGTERM);
  EXPECT_EQ(process.wait(), -SIGTERM) << output();
  expectToGoOn(sweepTo(out_), 4);
}

TEST_F(SweepProcess, OnAFullDiskKeepsWhatItHasAndGoesOn) {
  EXPECT_EQ(run("sh -c 'ulimit -f 4; exec \"$@\"' sh " + sweepTo(out_)), 4);  // blocks of 512 bytes
  EXPECT_NE(output().find("cannot be extended: File too large"), std::string::npos) << output();
  expectToGoOn(sweepTo(out_), 1, kCells);
}

TEST_F(SweepProcess, OfTheSameResultIsRefusedASecondTime) {
  Process first(gated(1, sweepTo(out_) + " --threads 1"), message_);
  ASSERT_TRUE(waitForCells(out_, 1)) << output();
  const std::string second_given = folder_.file("said too");
  Process second(sweepTo(out_), second_given);
  EXPECT_EQ(second.wait(), 4);
  EXPECT_NE(textOf(second_given).find("Another underact-sweep is working"), std::string::npos);
  admit(kCells);
  EXPECT_EQ(first.wait(), 0);
  EXPECT_TRUE(textOf(out_) == expected());
}

TEST_F(SweepProcess, OverwritesNothingThatComesWhileItRuns) {
  Process process(gated(4, sweepTo(out_)), message_);
  ASSERT_TRUE(waitForCells(out_, 4)) << output();
  std::ofstream(out_) << "a letter";
  admit(kCells);
  EXPECT_EQ(process.wait(), 4);
  EXPECT_NE(output().find("is not overwritten"), std::string::npos) << output();
  EXPECT_EQ(textOf(out_), "a letter");
  std::filesystem::remove(out_);
  EXPECT_EQ(run(sweepTo(out_)), 0) << output();
  EXPECT_EQ(runNow(message_), 0) << output();
  EXPECT_TRUE(textOf(out_) == expected());
}

/// A copy of the program that is another build as its linker would say: a bit of its build id differs.
std::string otherBuild(const std::string& to) {
  std::string bytes = contentOf(UNDERACT_GATED_SWEEP);
  const std::string mark("\3\0\0\0GNU\0", 8);  // the kind of the note, and its owner
  const std::size_t at = bytes.find(mark);
  EXPECT_NE(at, std::string::npos);
  if (at != std::string::npos) bytes[at + mark.size()] = static_cast<char>(bytes[at + mark.size()] ^ 1);
  std::ofstream(to, std::ios::binary) << bytes;
  std::filesystem::permissions(to, std::filesystem::perms::owner_all);
  return "'" + to + "'";
}

TEST_F(SweepProcess, OfAnotherBuildOfTheSameVersionIsNotGoneOnWith) {
  Process process(gated(4, sweepTo(out_)), message_);
  ASSERT_TRUE(waitForCells(out_, 4)) << output();
  kill(process.pid(), SIGKILL);
  EXPECT_EQ(process.wait(), -SIGKILL);
  const std::string other = otherBuild(folder_.file("other"));
  EXPECT_EQ(run(other + " gated --out '" + out_ + "'"), 4);
  EXPECT_NE(output().find("or of another build"), std::string::npos) << output();
  expectToGoOn(sweepTo(out_), 4);
  EXPECT_EQ(run(other + " gated --out '" + out_ + "'"), 4) << "nor is its result taken for that of the other";
  EXPECT_NE(output().find("is not overwritten"), std::string::npos) << output();
}

/// Whether a process has loaded any of the parts with which Open MPI begins.
bool hasBegunMpi(pid_t pid) {
  const std::string maps = textOf("/proc/" + std::to_string(pid) + "/maps");
  // Open MPI 4 loads its components, 5 has them in its library and shares memory with those who started it.
  return maps.find("/mca_") != std::string::npos || maps.find("/pmix-") != std::string::npos;
}

TEST_F(SweepProcess, AloneBeginsNoMpi) {
  admit(1);
  Process process("env -i PATH=/nowhere UNDERACT_TEST_GATE='" + gate_ + "' " + sweepTo(out_), message_);
  ASSERT_TRUE(waitForCells(out_, 1)) << output();
  EXPECT_FALSE(hasBegunMpi(process.pid()));
  admit(kCells);
  EXPECT_EQ(process.wait(), 0) << output();
  EXPECT_TRUE(textOf(out_) == expected());
}

#ifdef UNDERACT_MPIRUN

/// Ranks of one machine. isolated: no ssh to others is looked for. none: containers that let no process read another's
/// memory. The interface lo is enough.
std::string mpirun(int ranks) {
  return std::string("'") + UNDERACT_MPIRUN +
         "' --allow-run-as-root --oversubscribe --mca plm isolated --mca btl self,vader"
         " --mca btl_vader_single_copy_mechanism none -n " +
         std::to_string(ranks) + " ";
}

class SweepRanks : public SweepProcess {};

TEST_F(SweepRanks, OneAndFourGiveTheSameBytes) {
  for (const int ranks : {1, 4}) {
    EXPECT_EQ(run(mpirun(ranks) + sweepTo(out_)), 0) << output();
    EXPECT_EQ(runNow(message_), static_cast<int>(kCells)) << output();
    EXPECT_TRUE(textOf(out_) == expected()) << ranks << " ranks";
    std::filesystem::remove(out_);
  }
}

TEST_F(SweepRanks, OfHandsGiveTheBytesOfThreads) {
  const std::string threads = folder_.file("threads.csv");
  const std::string command = sweepProgram() + " hands --scene '" + scene("02_sphere.json") + "' '" +
                              scene("12_line_pid.json") + "' --draws 6 --seconds 1 --out ";
  EXPECT_EQ(run(command + "'" + threads + "' --threads 2"), 0) << output();
  EXPECT_EQ(run(mpirun(3) + command + "'" + out_ + "'"), 0) << output();
  EXPECT_TRUE(textOf(out_) == textOf(threads));
}

TEST_F(SweepRanks, OneOfThemKilledAndStartedAgainWithAnotherNumberGiveTheSameBytes) {
  for (const int rank : {2, 0}) {
    Process process(gated(4, mpirun(3) + sweepTo(out_)), message_);
    ASSERT_TRUE(waitForCells(out_, 4)) << output();
    const pid_t pid = rankOf(process.pid(), rank);
    ASSERT_GT(pid, 0);
    EXPECT_TRUE(hasBegunMpi(pid));
    kill(pid, SIGKILL);
    EXPECT_NE(process.wait(), 0);
    expectToGoOn(mpirun(rank == 0 ? 2 : 4) + sweepTo(out_), 4);
    std::filesystem::remove(out_);
  }
}

TEST_F(SweepRanks, AllKilledAndGoneOnWithOnThreadsGiveTheSameBytes) {
  Process process(gated(4, mpirun(2) + sweepTo(out_)), message_);
  ASSERT_TRUE(waitForCells(out_, 4)) << output();
  std::vector<pid_t> ranks;
  for (const int rank : {0, 1}) ranks.push_back(rankOf(process.pid(), rank));
  kill(process.pid(), SIGKILL);
  for (const pid_t rank : ranks) kill(rank, SIGKILL);
  EXPECT_EQ(process.wait(), -SIGKILL);
  expectToGoOn(sweepTo(out_) + " --threads 2", 4);
}

TEST_F(SweepRanks, OneOfThemAskedToEndEndsAllInOrder) {
  Process process(gated(4, mpirun(3) + sweepTo(out_)), message_);
  ASSERT_TRUE(waitForCells(out_, 4)) << output();
  const pid_t pid = rankOf(process.pid(), 1);
  ASSERT_GT(pid, 0);
  kill(pid, SIGTERM);
  EXPECT_EQ(letInUntilTheEnd(process, 4), 4) << output();
  EXPECT_NE(output().find("The same command continues"), std::string::npos) << output();
  expectToGoOn(mpirun(2) + sweepTo(out_), 4, kCells);
}

TEST_F(SweepRanks, AllAskedToEndByMpirunKeepWhatIsDone) {  // it tells them a second later, and kills them another later
  Process process(gated(4, mpirun(2) + sweepTo(out_)), message_);
  ASSERT_TRUE(waitForCells(out_, 4)) << output();
  const pid_t ranks[] = {rankOf(process.pid(), 0), rankOf(process.pid(), 1)};
  kill(process.pid(), SIGTERM);
  for (const pid_t rank : ranks) EXPECT_TRUE(rank > 0 && waitForEnd(rank)) << output();
  kill(process.pid(), SIGKILL);  // Open MPI's own end: once in 40 times it waits for ever, though both have ended
  process.wait();
  expectToGoOn(sweepTo(out_), 4);
}

TEST_F(SweepRanks, OneWithoutTheFilesEndsAllWithASentence) {
  const std::string here = folder_.file("0"), elsewhere = folder_.file("1");  // called by their ranks
  std::filesystem::create_directories(elsewhere);
  std::filesystem::create_directories(here);
  std::filesystem::copy_file(scene("02_sphere.json"), here + "/s.json");
  const std::string command = sweepProgram() + " hands --scene s.json --draws 40 --seconds 0.1 --out '" + out_ + "'";
  // Two programs of one mpirun, with ":", would do, but the one of Debian 13 breaks down at that.
  const std::string all =
      mpirun(2) + "sh -c 'cd \"$0/$OMPI_COMM_WORLD_RANK\" && exec \"$@\"' '" + folder_.file("") + "' " + command;
  EXPECT_EQ(run(all), 1);
  EXPECT_NE(output().find("Rank 1: s.json: error: The file cannot be opened"), std::string::npos) << output();
  std::filesystem::copy_file(scene("12_line_pid.json"), elsewhere + "/s.json");
  EXPECT_EQ(run(all), 1);
  EXPECT_NE(output().find("Rank 1 runs another build of the program, or sees other files"), std::string::npos)
      << output();
}

TEST_F(SweepRanks, ThatCannotBeginSaySoOnce) {
  const auto expectOnce = [&](const std::string& arguments, int exit, const std::string& words) {
    EXPECT_EQ(run(mpirun(2) + sweepProgram() + arguments), exit);
    const std::string text = output();
    const std::size_t first = text.find(words);
    ASSERT_NE(first, std::string::npos) << text;
    EXPECT_EQ(text.find(words, first + 1), std::string::npos) << text;
  };
  expectOnce(" hands --scene none.json --out '" + out_ + "'", 4, "none.json: error");
  expectOnce(" hands --seen none.json --out '" + out_ + "'", 2, "Run with --help");
}

TEST_F(SweepRanks, FindAResultThatIsThere) {
  std::filesystem::copy_file(whole_->file("r.csv"), out_);
  EXPECT_EQ(run(mpirun(2) + sweepTo(out_)), 0) << output();
  EXPECT_EQ(runNow(message_), 0);
  EXPECT_EQ(run(mpirun(2) + sweepTo(out_) + " --seed 2"), 4);
  EXPECT_NE(output().find("is not overwritten"), std::string::npos) << output();
  EXPECT_TRUE(textOf(out_) == expected());
}

#endif  // UNDERACT_MPIRUN

}  // namespace
}  // namespace underact::test
#endif
