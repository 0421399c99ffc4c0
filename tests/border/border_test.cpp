#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <thread>

#include "app/guard/watch.h"
#include "tests/border/wire_port.h"

namespace underact {
namespace {

using test::WirePort;
using namespace std::chrono_literals;

// No test here asks how fast: the machine may be busy. What must come is waited for this long.
constexpr auto kPatience = 20s;

/// The arm's side of the wire: it stands still, answers each force with where it is, and keeps what it was told.
class Arm {
 public:
  explicit Arm(int fd) : fd_(fd), thread_(&Arm::run, this) {}
  ~Arm() {
    ends_ = true;
    thread_.join();
    ::close(fd_);
  }
  double last_N() const { return last_N_; }
  std::int64_t frames() const { return frames_; }
  std::int64_t pushes() const { return pushes_; }  // frames with a force

 private:
  void run() {
    const WirePort::Frame tip_m{0.0, 0.0, 0.05};
    while (!ends_) {
      (void)::send(fd_, tip_m.data(), sizeof(tip_m), MSG_NOSIGNAL | MSG_DONTWAIT);
      pollfd ready{fd_, POLLIN, 0};
      WirePort::Frame force_N{};
      while (::poll(&ready, 1, 1) > 0 && ::recv(fd_, force_N.data(), sizeof(force_N), MSG_DONTWAIT) > 0) {
        last_N_ = Vec3(force_N[0], force_N[1], force_N[2]).norm();
        ++frames_;
        pushes_ += last_N_ > 0.0 ? 1 : 0;
      }
    }
  }
  int fd_;
  std::atomic<bool> ends_{false};
  std::atomic<double> last_N_{0.0};
  std::atomic<std::int64_t> frames_{0}, pushes_{0};
  std::thread thread_;
};

template <class Condition>
bool comes(const Condition& condition) {
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(2ms);
  }
  return true;
}

/// The program with the arm at the other end of a wire.
class Program {
 public:
  explicit Program(const std::string& way, const std::string& guard_program = UNDERACT_GUARD) {
    int wire[2], out[2];
    EXPECT_EQ(::socketpair(AF_UNIX, SOCK_SEQPACKET, 0, wire), 0);
    EXPECT_EQ(::pipe2(out, O_CLOEXEC), 0);
    ::fcntl(wire[0], F_SETFD, FD_CLOEXEC);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, out[1], STDOUT_FILENO);
    std::string name = UNDERACT_DYING_PROGRAM, fd = std::to_string(wire[1]), guard = guard_program, how = way;
    char* arguments[] = {name.data(), fd.data(), guard.data(), how.data(), nullptr};
    EXPECT_EQ(posix_spawn(&pid_, name.c_str(), &actions, nullptr, arguments, environ), 0);
    posix_spawn_file_actions_destroy(&actions);
    ::close(wire[1]);
    ::close(out[1]);
    out_ = out[0];
    arm_ = std::make_unique<Arm>(wire[0]);
  }
  ~Program() {
    ::kill(pid_, SIGCONT);
    ::kill(pid_, SIGKILL);
    while (!gone_ && ::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
    }
    ::close(out_);
  }
  Arm& arm() { return *arm_; }
  void send(int signal) { ::kill(pid_, signal); }
  /// Its next line, or what came until its patience or its life ended.
  std::string line() {
    std::string text;
    pollfd ready{out_, POLLIN, 0};
    for (char letter = 0; ::poll(&ready, 1, 20'000) > 0 && ::read(out_, &letter, 1) == 1 && letter != '\n';)
      text += letter;
    return text;
  }
  void waitUntilGone() {
    while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
    }
    gone_ = true;
  }

 private:
  pid_t pid_ = -1;
  int out_ = -1;
  bool gone_ = false;
  std::unique_ptr<Arm> arm_;
};

void expectZeroAfterDeath(const std::string& way, int signal) {
  Program program(way);
  ASSERT_EQ(program.line(), "pushing");
  ASSERT_GT(program.arm().pushes(), 0) << "else there is nothing to end";
  if (signal != 0) program.send(signal);
  program.waitUntilGone();
  EXPECT_TRUE(comes([&] { return program.arm().last_N() == 0.0; })) << program.arm().last_N() << " N for good";
  const std::int64_t pushes = program.arm().pushes();
  std::this_thread::sleep_for(50ms);
  EXPECT_EQ(program.arm().pushes(), pushes);
}

}  // namespace

TEST(Border, ASegmentationFaultLeavesZeroForce) {
  expectZeroAfterDeath("segv", 0);
}
TEST(Border, AnAbortLeavesZeroForce) {
  expectZeroAfterDeath("abort", 0);
}
TEST(Border, AnExitWithoutCleaningUpLeavesZeroForce) {
  expectZeroAfterDeath("exit", 0);
}
TEST(Border, AKillLeavesZeroForce) {
  expectZeroAfterDeath("wait", SIGKILL);
}
TEST(Border, ATerminationLeavesZeroForce) {
  expectZeroAfterDeath("wait", SIGTERM);
}
TEST(Border, AnOrderlyEndLeavesZeroForceToo) {
  expectZeroAfterDeath("return", 0);
}

TEST(Border, WithoutAGuardAKillLeavesTheForce) {  // what the tests above would see if there were none
  Program program("wait", "/there/is/none");
  ASSERT_EQ(program.line(), "pushing");
  program.send(SIGKILL);
  program.waitUntilGone();
  std::this_thread::sleep_for(300ms);
  EXPECT_GT(program.arm().last_N(), 0.1);
}

TEST(Border, AProgramThatStandsStillPushesNoMoreAndSaysSoWhenItGoesOn) {
  Program program("wait");
  ASSERT_EQ(program.line(), "pushing");
  program.send(SIGSTOP);
  ASSERT_TRUE(comes([&] { return program.arm().last_N() == 0.0; }));
  std::this_thread::sleep_for(1s);
  EXPECT_EQ(program.arm().last_N(), 0.0);
  const std::int64_t pushes = program.arm().pushes();
  program.send(SIGCONT);
  EXPECT_EQ(program.line(), "fault stood_still");
  // A tick that was at work when it was stopped may still write what it had found, one frame; the arm may read that
  // frame after the line was read here. The tick after it is the fault's.
  const std::int64_t frames = program.arm().frames();
  ASSERT_TRUE(comes([&] { return program.arm().frames() > frames + 200; }));
  EXPECT_LE(program.arm().pushes(), pushes + 1);
  EXPECT_EQ(program.arm().last_N(), 0.0);
}

TEST(GuardDuty, IsReadFromItsTwoArgumentsAndNothingElse) {
  const auto read = [](std::vector<const char*> arguments) {
    arguments.insert(arguments.begin(), "underact-guard");
    return guard::readDuty(static_cast<int>(arguments.size()), arguments.data());
  };
  ASSERT_TRUE(read({"100", "00ff4a"}));
  EXPECT_EQ(read({"100", "00ff4a"})->word, std::string("\0\xff\x4a", 3));
  EXPECT_EQ(read({"100", "00"})->limit_ns, 100);
  EXPECT_FALSE(read({}));
  EXPECT_FALSE(read({"100"}));
  EXPECT_FALSE(read({"0", "00"}));
  EXPECT_FALSE(read({"-5", "00"}));
  EXPECT_FALSE(read({"100x", "00"}));
  EXPECT_FALSE(read({"100", ""}));
  EXPECT_FALSE(read({"100", "0"}));
  EXPECT_FALSE(read({"100", "0g"}));
}

}  // namespace underact
