#include "core/system/rtkit.h"

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>

#include "core/system/thread.h"
#include "tests/core/servo/fake_rtkit.h"

namespace underact::servo {
namespace {

using test::FakeRtkit;
using test::PrivateBus;
using test::Rtkit;
using test::SystemBusAt;

/// What a thread got, and what it is afterwards.
struct Got {
  system::RtkitAnswer answer;
  system::Scheduling scheduling;
  std::uint64_t thread = 0;
  int policy = 0;
  int priority = 0;
};

/// In a thread of its own, so that the test stays what it was.
template <class Ask>
Got inThread(const Ask& ask) {
  Got got;
  std::thread([&] {
    ask(got);
    got.thread = static_cast<std::uint64_t>(syscall(SYS_gettid));
    got.policy = sched_getscheduler(0) & ~SCHED_RESET_ON_FORK;
    sched_param now{};
    sched_getparam(0, &now);
    got.priority = now.sched_priority;
  }).join();
  return got;
}

Got askInThread() {
  return inThread([](Got& got) { got.answer = system::askRtkit(); });
}

class RtkitAtItsBorder : public testing::Test {
 protected:
  void SetUp() override {
    if (!PrivateBus::isPossible()) {
      GTEST_SKIP() << "SKIPPED: dbus-daemon is not installed, so what is said to rtkit was not checked.";
    }
    bus_.emplace();
    ASSERT_FALSE(bus_->address().empty()) << "dbus-daemon is there and does not start";
    system_.emplace(bus_->address());
  }
  std::optional<PrivateBus> bus_;
  std::optional<SystemBusAt> system_;
};

TEST_F(RtkitAtItsBorder, AsksForTheCallingThreadWithTheLimitSetFirst) {
  const FakeRtkit rtkit(bus_->address(), Rtkit{});
  const Got got = askInThread();
  EXPECT_EQ(rtkit.asked().calls, 1);
  EXPECT_EQ(rtkit.asked().thread, got.thread);
  EXPECT_EQ(rtkit.asked().priority, 20U);
  EXPECT_LE(rtkit.asked().rest.rlim_max, 200'000U);
  EXPECT_EQ(rtkit.asked().rest.rlim_cur, rtkit.asked().rest.rlim_max);
  // Where this login may make no thread real-time, the service's yes changes nothing, and must not be believed.
  const bool is_held = rtkit.asked().is_held;
  EXPECT_EQ(got.answer.priority, is_held ? 0 : 20);
  EXPECT_EQ(got.answer.refusal.empty(), !is_held);
  EXPECT_EQ(got.policy, is_held ? SCHED_OTHER : SCHED_RR);
  EXPECT_EQ(got.priority, is_held ? 0 : 20);
}

TEST_F(RtkitAtItsBorder, AsksForNoMoreThanTheServiceGrants) {
  const FakeRtkit rtkit(bus_->address(), {.max_priority = 7, .longest_us = 150'000});
  askInThread();
  EXPECT_EQ(rtkit.asked().priority, 7U);
  EXPECT_LE(rtkit.asked().rest.rlim_max, 150'000U);
}

TEST_F(RtkitAtItsBorder, AServiceThatGrantsNoPriorityIsNotAsked) {
  const FakeRtkit rtkit(bus_->address(), {.max_priority = 0});
  EXPECT_EQ(askInThread().answer.refusal, "it grants no priority");
  EXPECT_EQ(rtkit.asked().calls, 0);
}

TEST_F(RtkitAtItsBorder, ARefusalIsToldInTheServicesWords) {
  const FakeRtkit rtkit(bus_->address(), {.refuses = true});
  const Got got = askInThread();
  EXPECT_EQ(got.answer.priority, 0);
  EXPECT_EQ(got.answer.refusal, "Too many threads already");
  EXPECT_EQ(got.policy, SCHED_OTHER);
}

TEST_F(RtkitAtItsBorder, AYesThatChangesNothingIsNotBelieved) {
  const FakeRtkit rtkit(bus_->address(), {.acts = false});
  const Got got = askInThread();
  EXPECT_EQ(got.answer.priority, 0);
  EXPECT_NE(got.answer.refusal, "");
}

TEST_F(RtkitAtItsBorder, AServiceThatNeverAnswersIsGivenUp) {
  const FakeRtkit rtkit(bus_->address(), {.answers = false});
  const Got got = askInThread();
  EXPECT_EQ(rtkit.asked().calls, 1);
  EXPECT_EQ(got.answer.priority, 0);
  EXPECT_NE(got.answer.refusal, "");
}

TEST_F(RtkitAtItsBorder, ABusWithoutTheServiceSaysSo) {
  EXPECT_TRUE(askInThread().answer.refusal.starts_with("it does not answer: ")) << askInThread().answer.refusal;
}

TEST_F(RtkitAtItsBorder, IsTheWayThatIsNamedWhereItIsWanted) {
  const FakeRtkit rtkit(bus_->address(), Rtkit{});
  const Got got = inThread([](Got& into) {
    into.scheduling = system::askForRealTime({.method = system::SchedulingMethod::Rtkit, .lock_memory = false}, 1000);
  });
  EXPECT_EQ(got.scheduling.name, rtkit.asked().is_held ? "normal" : "rtkit 20");
  EXPECT_NE(got.scheduling.hint.find("rtprio"), std::string::npos) << got.scheduling.hint;
}

TEST_F(RtkitAtItsBorder, ItsRefusalLeavesTheThreadNormalWithAHintAndTheReason) {
  const FakeRtkit rtkit(bus_->address(), {.refuses = true});
  const Got got = inThread([](Got& into) {
    into.scheduling = system::askForRealTime({.method = system::SchedulingMethod::Rtkit, .lock_memory = false}, 1000);
  });
  EXPECT_EQ(got.scheduling.name, "normal");
  EXPECT_NE(got.scheduling.hint.find("real_time.md"), std::string::npos) << got.scheduling.hint;
  const std::vector<Sentence>& also = got.scheduling.also;
  EXPECT_NE(std::find(also.begin(), also.end(), "rtkit: Too many threads already"), also.end());
}

TEST(RtkitWithoutABus, IsRefusedAtOnce) {
  const SystemBusAt nowhere("unix:path=/nonexistent/underact");
  const Got got = askInThread();
  EXPECT_EQ(got.answer.priority, 0);
  EXPECT_FALSE(got.answer.refusal.empty());
  EXPECT_EQ(got.policy, SCHED_OTHER);
}

}  // namespace
}  // namespace underact::servo
