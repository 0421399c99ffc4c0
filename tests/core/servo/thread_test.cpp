#include "core/servo/thread.h"

#include <gtest/gtest.h>
#include <linux/capability.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <limits>
#include <memory>
#include <set>

#include "core/base/denormals.h"
#include "core/servo/host.h"
#include "core/system/thread.h"
#include "tests/core/servo/fake_rtkit.h"
#include "tests/core/servo/scripted_port.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kLocksMemory = false;  // the sanitizers make mlockall() do nothing
#else
constexpr bool kLocksMemory = true;
#endif

namespace underact::servo {
namespace {

using test::ScriptedPort;

constexpr system::SchedulingRequest kPlain{.method = system::SchedulingMethod::Normal, .lock_memory = false};

/// What a thread of its own is granted.
template <class Before>
system::Scheduling granted(const system::SchedulingRequest& wanted, const Before& before) {
  system::Scheduling scheduling;
  std::thread([&] {
    before();
    scheduling = system::askForRealTime(wanted, 1000);
  }).join();
  return scheduling;
}

bool tells(const system::Scheduling& scheduling, const std::string& phrase) {
  return std::find(scheduling.also.begin(), scheduling.also.end(), phrase) != scheduling.also.end();
}

/// The calling thread may no longer lock memory or be real-time beyond its limits, even where root runs the test.
void dropPrivileges() {
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  __user_cap_data_struct data[2]{};
  if (syscall(SYS_capget, &header, data) != 0) return;
  for (const unsigned bit : std::initializer_list<unsigned>{CAP_IPC_LOCK, CAP_SYS_NICE})
    data[0].effective &= ~(1U << bit);
  syscall(SYS_capset, &header, data);
}

int firstAllowedCore() {
  cpu_set_t cores;
  sched_getaffinity(0, sizeof cores, &cores);
  int core = 0;
  while (!CPU_ISSET(static_cast<std::size_t>(core), &cores)) ++core;
  return core;
}

/// Runs the servo until `done` says so of its last tick.
void runUntil(Host& host, const std::function<bool(const TickRecord&)>& done) {
  bool is_done = false;
  host.begin();
  while (!is_done) {
    host.drain([&](const TickRecord& record) { is_done = is_done || done(record); });
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

double halfOf(double value) {
  const volatile double operand = value;
  return 0.5 * operand;
}

}  // namespace

TEST(AskForRealTime, NormalIsNormalEvenWhereTheMakerIsNot) {
  int policy = -1;
  system::Scheduling scheduling;
  std::thread([&] {
    const sched_param high{50};
    sched_setscheduler(0, SCHED_FIFO, &high);  // where it is allowed
    scheduling = system::askForRealTime(kPlain, 1000);
    policy = sched_getscheduler(0);
  }).join();
  EXPECT_EQ(policy, SCHED_OTHER);
  EXPECT_EQ(scheduling.name, "normal");
  EXPECT_NE(scheduling.hint, "");
}

TEST(AskForRealTime, ReducesTheTimerSlackTo1ns) {
  int slack_ns = 0;
  std::thread([&] {
    system::askForRealTime(kPlain, 1000);
    slack_ns = prctl(PR_GET_TIMERSLACK);
  }).join();
  EXPECT_EQ(slack_ns, 1);
}

TEST(AskForRealTime, FifoIs80OrWhatTheLimitOfTheLoginAllows) {
  const test::SystemBusAt nowhere("unix:path=/nonexistent/underact");
  rlimit limit{};
  getrlimit(RLIMIT_RTPRIO, &limit);
  const auto allowed = static_cast<int>(std::min<rlim_t>(limit.rlim_cur, 80));
  const system::Scheduling scheduling =
      granted({.method = system::SchedulingMethod::Fifo, .lock_memory = false}, dropPrivileges);
  EXPECT_EQ(scheduling.name, allowed > 0 ? "FIFO " + std::to_string(allowed) : "normal");
  EXPECT_EQ(scheduling.hint.find("rtprio") != std::string::npos, allowed < 80) << scheduling.hint;
  EXPECT_NE(scheduling.hint.find("real_time.md"), std::string::npos);
}

TEST(AskForRealTime, AutoTriesFifoThenRtkitThenNothing) {
  const test::SystemBusAt nowhere("unix:path=/nonexistent/underact");
  rlimit before{};
  getrlimit(RLIMIT_RTPRIO, &before);
  const rlimit none{0, before.rlim_max};  // so that FIFO is refused, whatever this login is allowed
  setrlimit(RLIMIT_RTPRIO, &none);
  const system::Scheduling scheduling =
      granted({.method = system::SchedulingMethod::Auto, .lock_memory = false}, dropPrivileges);
  setrlimit(RLIMIT_RTPRIO, &before);
  EXPECT_EQ(scheduling.name, "normal");
  EXPECT_TRUE(std::any_of(scheduling.also.begin(), scheduling.also.end(),
                          [](const std::string& phrase) { return phrase.starts_with("rtkit: "); }));
}

TEST(AskForRealTime, RunsOnTheCoreThatIsAskedForAndNoOther) {
  const int core = firstAllowedCore();
  cpu_set_t cores;
  CPU_ZERO(&cores);
  system::SchedulingRequest wanted = kPlain;
  wanted.core = core;
  system::Scheduling scheduling;
  std::thread([&] {
    scheduling = system::askForRealTime(wanted, 1000);
    sched_getaffinity(0, sizeof cores, &cores);
  }).join();
  EXPECT_EQ(CPU_COUNT(&cores), 1);
  EXPECT_TRUE(CPU_ISSET(static_cast<std::size_t>(core), &cores));
  EXPECT_TRUE(tells(scheduling, "core " + std::to_string(core)));
}

TEST(AskForRealTime, ACoreThatIsNotThereIsRefusedAndSaidSo) {
  system::SchedulingRequest wanted = kPlain;
  wanted.core = 1023;
  const system::Scheduling scheduling = granted(wanted, [] {});
  EXPECT_TRUE(tells(scheduling, "core 1023 refused"));
  EXPECT_NE(scheduling.hint.find("core"), std::string::npos);
}

TEST(AskForRealTime, LeavesMemoryAloneUnderALimitSoThatNoAllocationFailsLater) {
  if (!kLocksMemory) GTEST_SKIP() << "SKIPPED: a sanitizer stands in for locking.";
  rlimit before{};
  getrlimit(RLIMIT_MEMLOCK, &before);
  const rlimit limit{std::min<rlim_t>(before.rlim_max, rlim_t{8} << 20U), before.rlim_max};  // as most logins have it
  setrlimit(RLIMIT_MEMLOCK, &limit);
  const std::size_t beyond_bytes = 2 * limit.rlim_cur + (std::size_t{64} << 20U);
  void* memory = MAP_FAILED;
  munlockall();  // what a test before this one may have locked, as root
  system::Scheduling scheduling;
  std::thread([&] {
    dropPrivileges();
    scheduling = system::askForRealTime({.method = system::SchedulingMethod::Normal}, 1000);
    memory = mmap(nullptr, beyond_bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  }).join();
  setrlimit(RLIMIT_MEMLOCK, &before);
  EXPECT_TRUE(tells(scheduling, "memory not locked"));
  ASSERT_NE(memory, MAP_FAILED);
  munmap(memory, beyond_bytes);
}

TEST(AskForRealTime, LocksMemoryWhereThatIsAllowedAndLeavesItWhereItIsNotWanted) {
  EXPECT_TRUE(tells(granted(kPlain, [] {}), "memory not locked"));
  const system::Scheduling scheduling = granted({.method = system::SchedulingMethod::Normal}, [] {});
  if (!tells(scheduling, "memory locked") || !kLocksMemory) {
    GTEST_SKIP() << "SKIPPED: memory may not be locked here (or a sanitizer keeps it from being).";
  }
  std::ifstream status("/proc/self/status");
  std::string line;
  while (std::getline(status, line) && !line.starts_with("VmLck:")) {
  }
  EXPECT_GT(std::stol(line.substr(6)), 0) << line;
  munlockall();
}

TEST(ServoThread, TicksTenThousandTimesAt10kHz) {
  ScriptedPort::Seen seen;
  Host host(std::make_unique<ScriptedPort>(seen), {.rate_hz = 10'000, .clock = Clock::Thread});
  std::int64_t ticks = 0;
  runUntil(host, [&](const TickRecord& record) {
    EXPECT_EQ(record.tick, ++ticks);
    return ticks == 10'000;
  });
  EXPECT_GE(seen.writes, 10'000);
}

TEST(ServoThread, FlushesDenormalsAndSoDoTicksByHand) {
  for (const Clock clock : {Clock::Thread, Clock::Manual}) {
    std::atomic<int> flushed{-1};
    ScriptedPort::Seen seen;
    auto port = std::make_unique<ScriptedPort>(seen);
    port->spoil = [&flushed](std::int64_t, arm::Sample&) {
      flushed = halfOf(std::numeric_limits<double>::min()) == 0.0 ? 1 : 0;
      return true;
    };
    Host host(std::move(port), {.clock = clock});
    if (clock == Clock::Manual) {
      host.run(1);
    } else {
      runUntil(host, [](const TickRecord&) { return true; });
      EXPECT_TRUE(tells(host.scheduling(), FlushDenormals::isKnown() ? "denormals flushed" : "denormals kept"));
    }
    EXPECT_EQ(flushed, FlushDenormals::isKnown() ? 1 : 0);
  }
  EXPECT_GT(halfOf(std::numeric_limits<double>::min()), 0.0);  // here they are as they were
}

TEST(ServoThread, AnArmThatHoldsTheTickUpIsTheCauseAndNoBurstMakesUpForIt) {
  constexpr std::int64_t kHeldUp = 20;  // the read that sleeps
  constexpr auto kPause = std::chrono::milliseconds(30);
  std::vector<std::int64_t> reads_ns;  // written by the servo thread, read once it has ended
  reads_ns.reserve(100'000);
  LateTicks late;
  ScriptedPort::Seen seen;
  {
    auto port = std::make_unique<ScriptedPort>(seen);
    port->spoil = [&](std::int64_t read, arm::Sample&) {
      if (read == kHeldUp) std::this_thread::sleep_for(kPause);
      if (reads_ns.size() < reads_ns.capacity()) reads_ns.push_back(system::monotonicNow_ns());
      return true;
    };
    Host host(std::move(port), {.rate_hz = 1000, .clock = Clock::Thread});
    runUntil(host, [](const TickRecord& record) { return record.tick >= kHeldUp + 20; });
    late = host.snapshot().late;
  }
  EXPECT_GE(late.by_cause[static_cast<std::size_t>(LateCause::Device)], 1);
  EXPECT_GE(late.left_out, 28);
  ASSERT_GE(reads_ns.size(), static_cast<std::size_t>(kHeldUp) + 15);
  // From the end of the pause on: one tick at once, and then none before its own deadline.
  const std::int64_t held_up_ns = reads_ns[kHeldUp - 1];
  for (std::size_t later = 2; later < 15; ++later) {
    EXPECT_GE(reads_ns[kHeldUp - 1 + later] - held_up_ns, (static_cast<std::int64_t>(later) - 2) * 1'000'000);
  }
}

TEST(ServoThread, RestsWithoutATickAtZeroForceUntilItIsToldToGoOn) {
  ScriptedPort::Seen seen;
  ScriptedPort port(seen);
  ServoLoop loop(port, 1'000'000, 0);
  Thread thread(loop, 1000, kPlain);
  while (loop.beats() < 5) std::this_thread::yield();
  thread.rest();
  const std::int64_t max = loop.beats() + 1;  // one may be under way
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_LE(loop.beats(), max);
  EXPECT_EQ(seen.last_size_N, 0.0);
  const std::int64_t rested = loop.beats();
  thread.resume();
  while (loop.beats() < rested + 5) std::this_thread::yield();
}

}  // namespace underact::servo
