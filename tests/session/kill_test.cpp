#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <thread>

#include "core/record/replay.h"
#include "tests/session/rig.h"
#include "tests/support/property.h"

#if !defined(__SANITIZE_THREAD__)  // a forked child of TSan's runtime starts no threads
namespace underact::record {
namespace {

using namespace std::chrono_literals;

constexpr double kMaxLost_s = 0.25;  // the promise
constexpr int kRate_hz = 1000;

/// What the child tells the parent until it dies.
struct Shared {
  std::atomic<std::int64_t> first{0};
  std::atomic<std::int64_t> ticks{0};
  std::atomic<bool> records{false};
};

/// Records until it is killed, or for good if it never is.
[[noreturn]] void recordUntilKilled(const std::string& path, Shared& shared) {
  const auto host = test::makeHost(servo::Clock::Thread, "probe", kRate_hz);
  if (!host->load(test::sphereScene()).empty()) _exit(3);
  host->start();
  host->begin();
  const auto recorder = Recorder::start(*host, path, {.name = "killed"}, {.existing = system::Existing::Replace});
  if (!recorder) _exit(4);
  shared.first = host->snapshot().ticks;
  const auto end = std::chrono::steady_clock::now() + 60s;
  for (int round = 0; std::chrono::steady_clock::now() < end; ++round) {
    shared.ticks = host->snapshot().ticks;
    shared.records = recorder.value()->status().ticks > 0;
    host->drain([](const servo::TickRecord&) {});
    if (round % 50 == 10) {
      scene::Description scene = host->scene();
      scene.control.gains.kp_N_per_mm *= round % 100 == 10 ? 1.1 : 1.0 / 1.1;
      if (!host->edit(scene).empty()) _exit(5);
      recorder.value()->mark("round " + std::to_string(round));
    }
    std::this_thread::sleep_for(1ms);
  }
  _exit(6);
}

}  // namespace

TEST(Killed, AtAnyMomentLosesAQuarterOfASecondAtMostAndOpensAtOnceAndAfterRecover) {
  const test::ScratchFolder folder;
  test::Random random(test::Seed{7});
  auto* const shared =
      static_cast<Shared*>(mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
  double max_lost_s = 0.0;
  const int kills = test::sweep(6, 200);
  for (int kill_number = 0; kill_number < kills; ++kill_number) {
    const std::string path = folder.file("k.h5");
    new (shared) Shared;
    const pid_t child = fork();
    if (child == 0) recordUntilKilled(path, *shared);
    for (int waited = 0; waited < 20'000 && !shared->records; ++waited) std::this_thread::sleep_for(1ms);
    ASSERT_TRUE(shared->records) << "the child did not begin to record";
    std::this_thread::sleep_for(std::chrono::microseconds(static_cast<int>(random.between(0.0, 1e6))));
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status)) << "it ended by itself: " << status;

    std::int64_t ticks = 0, whole = 0;
    {
      Result<Session> session = Session::open(path);
      ASSERT_TRUE(session) << session.problems().front().sentence;
      EXPECT_FALSE(session.value().info().isComplete());
      EXPECT_TRUE(session.value().info().damage.empty());
      ticks = session.value().info().ticks;
      std::int64_t last_tick = shared->first;
      if (ticks > 0) {
        const Block last = session.value().readTicks(session.value().blocks() - 1, 1).value().back();
        ASSERT_FALSE(last.bytes.empty()) << "the last block is damaged";
        last_tick = unpackTicks(last).back().tick;
      }
      const std::int64_t lost = shared->ticks - last_tick;
      max_lost_s = std::max(max_lost_s, static_cast<double>(lost) / kRate_hz);
      if (ticks == 0) continue;
      const Result<Verified> verified = verifyReplay(session.value());
      ASSERT_TRUE(verified) << verified.problems().front().sentence;
      EXPECT_FALSE(verified.value().differs.has_value());
      EXPECT_TRUE(!verified.value().unknown.empty() || verified.value().ticks == ticks);
      whole = verified.value().ticks;
    }
    const Result<std::int64_t> recovered = recover(path);
    ASSERT_TRUE(recovered) << recovered.problems().front().sentence;
    EXPECT_EQ(recovered.value(), ticks);
    Result<Session> session = Session::open(path);
    ASSERT_TRUE(session);
    ASSERT_TRUE(session.value().info().isComplete());
    EXPECT_EQ(session.value().info().end->reason, EndReason::Recovered);
    EXPECT_EQ(session.value().info().ticks, ticks);
    EXPECT_FALSE(session.value().isOpenElsewhere()) << "it opens plainly";
    if (ticks == 0) continue;
    const Result<Verified> verified = verifyReplay(session.value());
    ASSERT_TRUE(verified) << verified.problems().front().sentence;
    EXPECT_EQ(verified.value().ticks, whole) << "what was there is still there";
  }
  munmap(shared, sizeof(Shared));
  EXPECT_LE(max_lost_s, kMaxLost_s);
  RecordProperty("most_lost_ms", static_cast<int>(1e3 * max_lost_s));
  std::printf("%d kills, at most %.0f ms lost\n", kills, 1e3 * max_lost_s);
}

TEST(Killed, IsNotRecoveredWhileItStillRecords) {
  const test::ScratchFolder folder;
  const auto host = test::makeHost(servo::Clock::Manual, "probe");
  ASSERT_TRUE(host->load(test::sphereScene()).empty());
  const auto recorder = Recorder::start(*host, folder.file("s.h5"), {});
  ASSERT_TRUE(recorder);
  host->run(500);
  std::this_thread::sleep_for(100ms);
  // Another process: within one, HDF5 knows that the file is open.
  const std::string command = "'" UNDERACT_CLI "' log recover '" + folder.file("s.h5") + "' 2>&1";
  std::FILE* const pipe = popen(command.c_str(), "r");
  std::array<char, 400> given{};
  ASSERT_GT(std::fread(given.data(), 1, given.size() - 1, pipe), 0U);
  EXPECT_EQ(WEXITSTATUS(pclose(pipe)), 4);
  EXPECT_NE(std::string(given.data()).find("Another program has this file open"), std::string::npos) << given.data();
  EXPECT_TRUE(recorder.value()->stop().empty());
  EXPECT_EQ(Session::open(folder.file("s.h5")).value().info().ticks, 500);
}

}  // namespace underact::record
#endif
