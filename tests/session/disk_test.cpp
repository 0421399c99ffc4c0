#include <gtest/gtest.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <limits>
#include <thread>

#include "core/record/replay.h"
#include "tests/session/rig.h"
#include "tests/support/full_disk.h"

namespace underact::record {
namespace {

using namespace std::chrono_literals;

bool waitForEnd(const Recorder& recorder) {
  for (int waited = 0; waited < 20'000 && recorder.status().recording; ++waited) std::this_thread::sleep_for(1ms);
  return !recorder.status().recording;
}

}  // namespace

TEST(Disk, ThatTakesNoMoreEndsTheRecordingWithASentenceAndAWholeFileAndTheServoGoesOn) {
  const test::ScratchFolder folder;
  const auto host = test::makeHost(servo::Clock::Thread, "probe");
  ASSERT_TRUE(host->load(test::sphereScene()).empty());
  host->start();
  host->begin();
  std::int64_t ticks = 0;
  {
    const test::FullDisk small(600'000);
    const auto recorder = Recorder::start(*host, folder.file("s.h5"), {});
    ASSERT_TRUE(recorder);
    ASSERT_TRUE(waitForEnd(*recorder.value()));
    ticks = host->snapshot().ticks;
    const RecorderStatus status = recorder.value()->status();
    ASSERT_FALSE(status.problems.empty());
    EXPECT_NE(status.problems.front().sentence.find("The recording stopped"), std::string::npos)
        << status.problems.front().sentence;
    EXPECT_FALSE(recorder.value()->stop().empty()) << "the sentence stays";
  }
  std::this_thread::sleep_for(50ms);
  EXPECT_EQ(host->snapshot().mode, servo::Mode::Running);
  EXPECT_GT(host->snapshot().ticks, ticks);
  const Result<std::int64_t> recovered = recover(folder.file("s.h5"));
  ASSERT_TRUE(recovered) << recovered.problems().front().sentence;
  Result<Session> session = Session::open(folder.file("s.h5"));
  ASSERT_TRUE(session) << session.problems().front().sentence;
  EXPECT_TRUE(session.value().info().isComplete());
  EXPECT_GT(session.value().info().ticks, 300);
  const Result<Verified> verified = verifyReplay(session.value());
  ASSERT_TRUE(verified);
  EXPECT_EQ(verified.value().ticks, session.value().info().ticks);
}

#if !defined(__SANITIZE_THREAD__)  // a forked child of TSan's runtime starts no threads
// What the child found, as its exit status.
enum SmallDisk : int { kOk = 0, kNoSentence, kNotWhole, kNotTheSame, kNoSmallDisk };

/// In a name space of its own, so that the small disk is gone with the process.
void makeSmallDisk(const std::string& folder) {
  const int alone = geteuid() == 0 ? CLONE_NEWNS : CLONE_NEWUSER | CLONE_NEWNS;
  if (unshare(alone) != 0 || mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
      mount("tmpfs", folder.c_str(), "tmpfs", 0, "size=16m") != 0)
    _exit(kNoSmallDisk);
}

/// reserve_bytes: of the recorder; min_ticks: that fit before it.
[[noreturn]] void recordOnDiskOf16MB(const std::string& folder, std::optional<std::int64_t> reserve_bytes,
                                     const char* word, std::int64_t min_ticks) {
  makeSmallDisk(folder);
  const std::string path = folder + "/s.h5";
  const auto host = test::makeHost(servo::Clock::Manual, "probe");
  if (!host->load(test::sphereScene()).empty()) _exit(kNotWhole);
  host->start();
  {
    const auto recorder = Recorder::start(*host, path, {}, {.reserve_bytes = reserve_bytes});
    if (!recorder) _exit(kNotWhole);
    host->run(100'000);  // twice what fits
    const Problems problems = recorder.value()->stop();
    if (problems.empty() || problems.front().sentence.find(word) == std::string::npos) _exit(kNoSentence);
  }
  Result<Session> session = Session::open(path);
  if (!session || !session.value().info().end || session.value().info().end->reason != EndReason::DiskFull)
    _exit(kNotWhole);
  const Result<Verified> verified = verifyReplay(session.value());
  const bool same =
      verified && verified.value().ticks == session.value().info().ticks && verified.value().ticks > min_ticks;
  _exit(same ? kOk : kNotTheSame);
}

[[noreturn]] void recordOnSmallDisk(const std::string& folder) {
  recordOnDiskOf16MB(folder, 0, "is full", 1000);
}

/// As a recording has it that nobody told how much is to be left: 40 % of 16 MB at least are used.
[[noreturn]] void recordByDefault(const std::string& folder) {
  recordOnDiskOf16MB(folder, {}, "full", 14'000);
}

/// A recorder that comes to its work seldom, as on a busy machine: all that fits is in the library's memory at once,
/// and the file's size says nothing of it.
[[noreturn]] void flushTooLate(const std::string& folder) {
  makeSmallDisk(folder);
  const std::string path = folder + "/s.h5";
  const auto host = test::makeHost(servo::Clock::Manual, "probe");
  Result<SessionWriter> writer = SessionWriter::create(path, {});
  if (!writer || !writer.value().begin(0, 0, {}, host->scene()).empty()) _exit(kNotWhole);
  servo::TickRecord record;
  Problems problems;
  for (record.tick = 0; record.tick < 100'000 && problems.empty(); ++record.tick) problems = writer.value().add(record);
  if (!writer.value().isFull()) _exit(kNoSentence);
  const bool ended = writer.value().end({0, 0, 0, EndReason::DiskFull}).empty();
  const Result<Session> session = Session::open(path);
  _exit(ended && session && session.value().info().end && session.value().info().ticks > 1000 ? kOk : kNotWhole);
}

void expectOk(void (*act)(const std::string& folder)) {
  const test::ScratchFolder folder;
  const pid_t child = fork();
  if (child == 0) act(folder.file(""));
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  if (WEXITSTATUS(status) == kNoSmallDisk) GTEST_SKIP() << "this system lets no program make a small disk";
  EXPECT_EQ(WEXITSTATUS(status), kOk);
}

/// A file that a full disk keeps from being closed, as there is no descriptor left for writing to nothing instead; then
/// the program exits.
[[noreturn]] void leaveWhatCannotBeClosed(const std::string& folder) {
  const test::FullDisk small(400'000);
  rlimit before{};
  ::getrlimit(RLIMIT_NOFILE, &before);
  {
    const auto host = test::makeHost(servo::Clock::Manual, "probe");
    Result<SessionWriter> writer = SessionWriter::create(folder + "/s.h5", {});
    if (!writer || !writer.value().begin(0, 0, {}, host->scene()).empty()) _exit(kNotWhole);
    const rlimit none{0, before.rlim_max};
    ::setrlimit(RLIMIT_NOFILE, &none);
    servo::TickRecord record;
    Problems problems;
    for (record.tick = 0; record.tick < 5'000 && problems.empty(); ++record.tick) problems = writer.value().add(record);
    if (problems.empty()) problems = writer.value().flush();
    if (problems.empty()) _exit(kNoSentence);
  }
  ::setrlimit(RLIMIT_NOFILE, &before);  // sanitizers open files at the exit
  std::exit(kOk);
}

TEST(Disk, ThatIsFullLeavesASessionThatWasEndedInOrder) {
  expectOk(recordOnSmallDisk);
}

TEST(Disk, OfFewMegabytesIsUsedUntilItIsNearlyFull) {
  expectOk(recordByDefault);
}

TEST(Disk, ThatIsFullIsMetBeforeTheLibraryMeetsItHoweverLateItWrites) {
  expectOk(flushTooLate);
}

TEST(Disk, ThatIsFullLetsTheProgramExitInOrder) {
  expectOk(leaveWhatCannotBeClosed);
}
#endif

TEST(Disk, ThatIsNearlyFullEndsTheRecordingInOrder) {
  const test::ScratchFolder folder;
  const auto host = test::makeHost(servo::Clock::Thread, "probe");
  ASSERT_TRUE(host->load(test::sphereScene()).empty());
  host->begin();
  const auto recorder =
      Recorder::start(*host, folder.file("s.h5"), {}, {.reserve_bytes = std::numeric_limits<std::int64_t>::max()});
  ASSERT_TRUE(recorder);
  ASSERT_TRUE(waitForEnd(*recorder.value()));
  EXPECT_NE(recorder.value()->status().problems.at(0).sentence.find("disk is nearly full"), std::string::npos);
  Result<Session> session = Session::open(folder.file("s.h5"));
  ASSERT_TRUE(session);
  ASSERT_TRUE(session.value().info().isComplete());
  EXPECT_EQ(session.value().info().end->reason, EndReason::DiskFull);
}

TEST(Disk, ThatLostTheFileEndsTheRecordingWithASentence) {
  const test::ScratchFolder folder;
  const auto host = test::makeHost(servo::Clock::Thread, "probe");
  ASSERT_TRUE(host->load(test::sphereScene()).empty());
  host->begin();
  const auto recorder = Recorder::start(*host, folder.file("s.h5"), {});
  ASSERT_TRUE(recorder);
  std::filesystem::remove(folder.file("s.h5"));
  ASSERT_TRUE(waitForEnd(*recorder.value()));
  EXPECT_NE(recorder.value()->status().problems.at(0).sentence.find("moved or deleted"), std::string::npos);
}

TEST(Disk, RefusesARecordingAtOnceWhereNoFileCanBeMade) {
  const auto host = test::makeHost(servo::Clock::Manual, "probe");
  ASSERT_TRUE(host->load(test::sphereScene()).empty());
  const auto recorder = Recorder::start(*host, "/dev/null/nowhere/all/s.h5", {});
  ASSERT_FALSE(recorder);
  EXPECT_EQ(recorder.problems().front().sentence, "The recording cannot be started: Not a directory.");
}

}  // namespace underact::record
