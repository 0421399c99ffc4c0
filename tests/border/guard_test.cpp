// The guard itself is killed, stopped or gone: it is missed, it is replaced, and the one that came in its place guards.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <csignal>
#include <fstream>

#include "tests/border/own_guard.h"
#include "tests/border/wired_program.h"
#include "tests/support/comes.h"
#include "tests/support/processes.h"

namespace underact {
namespace {

using test::comes;
using test::OwnGuard;

class GuardedProgram : public test::WiredProgram {
 public:
  explicit GuardedProgram(const std::string& guard = UNDERACT_GUARD, const std::string& way = "wait")
      : WiredProgram(UNDERACT_DYING_PROGRAM, {guard, way}) {}
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

}  // namespace

TEST(Guard, KilledItIsMissedAndReplacedAndTheNewOneSaysTheLastWord) {
  const OwnGuard own;
  GuardedProgram program(own.path());
  ASSERT_EQ(program.line(), "pushing");
  const pid_t first = program.guardBut();
  ASSERT_GT(first, 0);
  own.hide();  // so that the gap lasts
  ASSERT_EQ(::kill(first, SIGKILL), 0);
  EXPECT_NE(program.lineWith("Nothing guards the arm: the guard has ended").find("stop the force"), std::string::npos);
  const std::int64_t pushes = program.arm().pushes();
  EXPECT_TRUE(comes([&] { return program.arm().pushes() > pushes + 20; })) << "the force goes on meanwhile";
  own.bringBack();
  EXPECT_EQ(program.lineWith("guarded by"), "guarded by a process of its own (replaced so far: 1)");
  const pid_t second = program.guardBut(first);
  ASSERT_GT(second, 0);
  EXPECT_NE(second, first);
  ASSERT_GT(program.arm().last_N(), 0.1);
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
  EXPECT_GT(program.arm().last_N(), 0.1);
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
