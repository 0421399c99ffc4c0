// Strangers at the port of an arm that is shared: what they may keep busy, and how they are told of.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/socket.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "core/system/thread_priority.h"
#include "device/remote/connection_limit.h"
#include "device/remote/remote_arm.h"
#include "tests/support/comes.h"
#include "tests/support/pattern.h"
#include "tests/support/shared_arm.h"

namespace underact::device::remote {
namespace {

using test::comes;
using test::SharedArm;

/// How the thread of that name is scheduled; below 0: there is none.
int policyOf(const std::string& thread) {
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    std::ifstream file(task.path() / "comm");
    std::string name;
    std::getline(file, name);
    if (!test::matchesOf("^" + thread + "$", name).empty())
      return sched_getscheduler(std::stoi(task.path().filename()));
  }
  return -1;
}

/// Of what carries messages at the arm's side.
int policyOfHub() {
  return policyOf("[0-9]+/ZMQbg/IO/0");
}

/// Connects so many times, and goes at once: every other time without a goodbye, so that who listens finds nobody.
void knock(int port, int times) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  for (int time = 0; time < times; ++time) {
    const int fd = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    ASSERT_EQ(::connect(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    const linger none{1, 0};
    if (time % 2 == 0) ::setsockopt(fd, SOL_SOCKET, SO_LINGER, &none, sizeof none);
    ::close(fd);
  }
}

/// A program that has the arm and says so all the while: its network thread does.
std::unique_ptr<RemoteArm> seatAt(const SharedArm& far) {
  auto opened = far.open(nullptr, 1000, true);
  EXPECT_TRUE(opened) << opened.problems().front().sentence;
  return opened ? std::move(opened).value() : nullptr;
}

std::vector<std::string> linesWith(const std::string& text, const std::string& words) {
  std::vector<std::string> found;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (line.find(words) != std::string::npos) found.push_back(line);
  }
  return found;
}

}  // namespace

TEST(RemoteKnocks, AClassMayLookAndAStormIsTooMuchUntilItHasRested) {
  constexpr std::int64_t kStep_ns = 50'000'000;
  ConnectionLimit connections;
  std::int64_t now_ns = 1;
  for (int step = 0; step < 200; ++step, now_ns += kStep_ns) {
    connections.count(2, now_ns);  // 40 a second
    ASSERT_FALSE(connections.areTooMany()) << step;
  }
  for (int step = 0; step < 20; ++step, now_ns += kStep_ns) connections.count(10, now_ns);  // 200 a second
  EXPECT_TRUE(connections.areTooMany());
  connections.count(0, now_ns);
  EXPECT_TRUE(connections.areTooMany());
  connections.count(0, now_ns + 1'000'000'000);
  EXPECT_FALSE(connections.areTooMany());
}

TEST(RemoteStrangers, GetRealTimeNeitherWithoutASeatNorByAStorm) {
  SharedArm far;
  const int port = far.endpoint(true).address.port;
  const int urgent = system::grantedPriority() ? SCHED_FIFO : SCHED_OTHER;  // where nothing is granted, nobody gets it
  EXPECT_TRUE(comes([] { return policyOfHub() == SCHED_OTHER; }))
      << policyOfHub();  // its thread has its name in a while
  knock(port, 200);
  EXPECT_EQ(policyOfHub(), SCHED_OTHER);
  std::unique_ptr<RemoteArm> seat = seatAt(far);
  ASSERT_TRUE(seat);
  EXPECT_TRUE(comes([&] { return policyOfHub() == urgent; }));
  for (int storm = 0; storm < 40 && policyOfHub() != SCHED_OTHER; ++storm) knock(port, 200);
  EXPECT_TRUE(comes([] { return policyOfHub() == SCHED_OTHER; })) << "they are too many";
  EXPECT_EQ(policyOf("underact-share"), SCHED_OTHER) << "who turns them away";
  EXPECT_TRUE(comes([&] { return policyOfHub() == urgent; })) << "it is quiet again";
  EXPECT_TRUE(comes([&] { return policyOf("underact-share") == urgent; }));
  seat.reset();
  EXPECT_TRUE(comes([] { return policyOfHub() == SCHED_OTHER; })) << "nobody has the arm";
}

TEST(RemoteStrangers, AreToldOfOnceASecondHoweverManyTheyAre) {
  SharedArm far;
  Endpoint endpoint = far.endpoint(true);
  endpoint.own = far.stranger();
  constexpr int kTimes = 12;
  const auto begin = std::chrono::steady_clock::now();
  for (int time = 0; time < kTimes; ++time) EXPECT_FALSE(RemoteArm::open(endpoint, far.arm.preset(), 1000));
  const auto count = [&] {
    int sum = 0;
    for (const std::string& line : linesWith(far.told(), "was refused")) {
      const std::vector<test::PatternMatch> found = test::matchesOf("([0-9]+) times", line);
      sum += found.empty() ? 1 : std::stoi(found[0].groups[1]);
    }
    return sum;
  };
  EXPECT_TRUE(comes([&] { return count() == kTimes; })) << far.told();
  const double took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  EXPECT_LE(static_cast<double>(linesWith(far.told(), "was refused").size()), 1.0 + took_s);
}

TEST(RemoteRate, BeyondWhatAServoTicksIsRefusedInWords) {
  SharedArm far;
  for (const int rate_hz : {1, 99, 10'001, 1'000'000}) {
    const auto opened = far.open(nullptr, rate_hz, true);
    ASSERT_FALSE(opened) << rate_hz;
    EXPECT_NE(opened.problems().front().sentence.find(
                  "ticks 100 to 10000 times a second, but the program that asks wants " + std::to_string(rate_hz)),
              std::string::npos)
        << opened.problems().front().sentence;
  }
  EXPECT_TRUE(seatAt(far)) << "it is free, and ticks as it did";
}

TEST(RemoteRate, IsPutBackWhenTheSeatLeavesAndWhenItIsCutOff) {
  SharedArm far;
  const auto rate_hz = [&] {
    const Result<Welcome> welcome = queryArm(far.endpoint(true), 3000);
    return welcome ? welcome.value().rate_hz : -1;
  };
  {
    auto seat = far.open(nullptr, 2000, true);
    ASSERT_TRUE(seat);
    EXPECT_EQ(rate_hz(), 2000);
  }
  EXPECT_TRUE(comes([&] { return rate_hz() == 1000; })) << "it has let go";
  auto seat = far.open(nullptr, 500);
  ASSERT_TRUE(seat);
  EXPECT_EQ(rate_hz(), 500);
  far.cable().pull();
  EXPECT_TRUE(comes([&] { return rate_hz() == 1000; })) << "nothing comes from it any more";
}

}  // namespace underact::device::remote
