// The guard itself is killed, stopped or gone: it is missed, it is replaced, and the one that came in its place guards.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <new>

#include "app/guard/watch.h"
#include "core/servo/guard_line.h"
#include "tests/process/own_guard.h"
#include "tests/process/wired_program.h"
#include "tests/support/comes.h"
#include "tests/support/processes.h"

namespace underact {
namespace {

using test::comes;
using test::OwnGuard;

class GuardedProgram : public test::WiredProgram {
 public:
  explicit GuardedProgram(const std::string& guard = UNDERACT_GUARD)
      : WiredProgram(UNDERACT_DYING_PROGRAM, {guard, "go on"}) {}
  /// The guard beside it that is none of these; below 0: none came.
  pid_t guardBut(pid_t other = -1) {
    pid_t found = -1;
    comes([&] {
      for (const pid_t guard : test::childrenOf(pid(), "underact-guard")) found = guard == other ? found : guard;
      return found > 0;
    });
    return found;
  }
};

/// A guard in a process of its own, over memory and pipes of the test's; ended with it.
class BareGuard {
 public:
  explicit BareGuard(const guard::Duty& duty) {
    void* memory = ::mmap(nullptr, sizeof(servo::GuardLine), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) std::abort();
    line_ = new (memory) servo::GuardLine;
    int life[2], arm[2];
    if (::pipe2(life, O_CLOEXEC) != 0 || ::pipe2(arm, O_CLOEXEC | O_NONBLOCK) != 0) std::abort();
    life_ = life[1];
    arm_ = arm[0];
    child_ = ::fork();
    if (child_ < 0) std::abort();  // nobody to be killed later
    if (child_ == 0) {
      ::close(life_);  // so that it ends with the test
      ::_exit(guard::watch(duty, *line_, life[0], arm[1]));
    }
    ::close(life[0]);
    ::close(arm[1]);
  }
  ~BareGuard() {
    ::kill(child_, SIGKILL);
    ::waitpid(child_, nullptr, 0);
    ::close(life_);
    ::close(arm_);
    ::munmap(line_, sizeof(servo::GuardLine));
  }
  void beat() { line_->beats.fetch_add(1); }
  /// What the arm was told since it was asked last.
  std::string told() {
    char text[64];
    const ssize_t count = ::read(arm_, text, sizeof text);
    return {text, static_cast<std::size_t>(std::max<ssize_t>(count, 0))};
  }

 private:
  servo::GuardLine* line_;
  int life_ = -1, arm_ = -1;
  pid_t child_ = -1;
};

}  // namespace

TEST(Guard, AProgramThatTicksSlowlyButInTimeIsLeftAlone) {
  BareGuard guard({1'000'000'000, "zero"});
  for (int beat = 0; beat < 6; ++beat) {  // 2.7 s, with two looks of the guard between two
    guard.beat();
    std::this_thread::sleep_for(std::chrono::milliseconds(450));
    ASSERT_EQ(guard.told(), "") << beat;
  }
  EXPECT_TRUE(comes([&] { return guard.told().starts_with("zero"); })) << "it stands still";
}

TEST(Guard, KilledItIsMissedAndReplacedAndTheNewOneSaysTheLastWord) {
  const OwnGuard own;
  GuardedProgram program(own.path());
  ASSERT_EQ(program.line(), "pushing");
  const pid_t first = program.guardBut();
  ASSERT_GT(first, 0);
  own.hide();  // so that the gap lasts
  ASSERT_EQ(::kill(first, SIGKILL), 0);
  EXPECT_NE(program.lineWith("Nothing guards the arm: the guard has ended").find("switch the force off"),
            std::string::npos);
  const std::int64_t pushes = program.arm().pushes();
  EXPECT_TRUE(comes([&] { return program.arm().pushes() > pushes + 20; })) << "the force goes on meanwhile";
  own.bringBack();
  EXPECT_EQ(program.lineWith("guarded by"), "guarded by a separate process (replaced so far: 1)");
  const pid_t second = program.guardBut(first);
  ASSERT_GT(second, 0);
  EXPECT_NE(second, first);
  ASSERT_TRUE(comes([&] { return program.arm().last_N() > 0.1; })) << program.arm().last_N() << " N";
  program.send(SIGKILL);
  program.waitUntilGone();
  EXPECT_TRUE(comes([&] { return program.arm().last_N() == 0.0; })) << program.arm().last_N() << " N for good";
}

TEST(Guard, OneThatStandsStillIsReplaced) {
  GuardedProgram program;
  ASSERT_EQ(program.line(), "pushing");
  const pid_t first = program.guardBut();
  ASSERT_EQ(::kill(first, SIGSTOP), 0);
  EXPECT_GT(program.guardBut(first), 0);
  EXPECT_TRUE(comes([&] { return ::kill(first, 0) != 0; })) << "it is gone, not left behind";
  program.send(SIGKILL);
  program.waitUntilGone();
  EXPECT_TRUE(comes([&] { return program.arm().last_N() == 0.0; }));
}

TEST(Guard, OneThatStandsStillDoesNotHoldUpTheProgramsEnd) {
  GuardedProgram program;
  ASSERT_EQ(program.line(), "pushing");
  ASSERT_EQ(::kill(program.guardBut(), SIGSTOP), 0);
  program.send(SIGUSR1);
  int status = -1;
  ASSERT_TRUE(program.ends(status));
  EXPECT_EQ(status, 0);
  EXPECT_TRUE(comes([&] { return program.arm().last_N() == 0.0; }));
}

TEST(Guard, OneThatDiesAtOnceEachTimeIsNotStartedForEver) {
  const test::ScratchFolder scratch;
  const std::string list = scratch.file("starts");
  const std::string guard = scratch.write("underact-guard", "#!/bin/sh\necho >> '" + list + "'\nexit 1\n");
  ASSERT_EQ(::chmod(guard.c_str(), 0700), 0);
  const auto starts = [&list] { return std::filesystem::exists(list) ? std::filesystem::file_size(list) : 0; };
  GuardedProgram program(guard);
  ASSERT_EQ(program.line(), "pushing");
  EXPECT_TRUE(comes([&] { return starts() == 7; })) << starts();
  std::this_thread::sleep_for(std::chrono::seconds(2));
  EXPECT_EQ(starts(), 7U) << "the first and six more, then no other for the rest of the minute";
  // Not at once: a busy machine may just have ended the force, which rises again from zero.
  EXPECT_TRUE(comes([&] { return program.arm().last_N() > 0.1; })) << program.arm().last_N() << " N";
}

TEST(Guard, HoldsNeitherTheProgramsTerminalNorItsPipes) {
  GuardedProgram program;
  ASSERT_EQ(program.line(), "pushing");
  const std::string fds = "/proc/" + std::to_string(program.guardBut()) + "/fd/";
  for (const char* const fd : {"0", "1", "2"})
    EXPECT_TRUE(comes([&] {
      std::error_code ignored;
      return std::filesystem::read_symlink(fds + fd, ignored) == "/dev/null";
    })) << fd;
}

}  // namespace underact
