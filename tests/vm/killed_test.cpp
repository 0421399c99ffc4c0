// A process that pushes an arm behind the kernel's HID is killed. Run in the virtual machine only: see run.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>

#include "core/system/clock.h"
#include "device/catalogue.h"
#include "tests/support/comes.h"
#include "tests/support/uhid_board.h"

namespace underact::test {
namespace {

class InTheMachine : public testing::Test {
 protected:
  void SetUp() override {
    const char* const asked = std::getenv("UNDERACT_UHID");
    if (asked == nullptr || *asked != '1') GTEST_SKIP() << "tests/vm/run does this in a virtual machine";
    board_.plugIn();
    ASSERT_FALSE(board_.node().empty());
  }
  void TearDown() override {
    if (pid_ > 0) kill();
  }
  /// Starts the program, as another user where it says so, and gives its first line.
  std::string firstLine(const std::string& device, const std::string& guard, uid_t user = 0) {
    int out[2];
    EXPECT_EQ(::pipe2(out, O_CLOEXEC), 0);
    std::string name = UNDERACT_PUSHING_PROGRAM, arm = device, how = guard;
    char* arguments[] = {name.data(), arm.data(), how.data(), nullptr};
    pid_ = ::fork();
    if (pid_ == 0) {  // other threads may hold any lock: nothing but system calls from here on
      ::dup2(out[1], STDOUT_FILENO);
      if (::setgid(user) == 0 && ::setuid(user) == 0) ::execv(name.c_str(), arguments);
      ::_exit(3);
    }
    ::close(out[1]);
    std::string line;
    for (char letter = 0; ::read(out[0], &letter, 1) == 1 && letter != '\n';) line += letter;
    ::close(out[0]);
    return line;
  }
  /// Starts the program, and it pushes.
  void push(const std::string& guard) {
    ASSERT_EQ(firstLine("wooden", guard), "pushing");
    ASSERT_TRUE(comes([this] { return force_N() > 0.1; }));
  }
  void kill() {
    ::kill(pid_, SIGKILL);
    while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
    }
    pid_ = -1;
  }
  double force_N() const { return firmware_.force_N(system::monotonicNow_ns()).norm(); }
  bool hasCurrent() const { return firmware_.currents_mA(system::monotonicNow_ns()) != std::array<int, 3>{}; }

  WoodenFirmware firmware_{{}};
  UhidBoard board_{firmware_};
  pid_t pid_ = -1;
};

TEST_F(InTheMachine, AKilledProgramLeavesZeroByTheGuardsWord) {
  push(UNDERACT_GUARD);
  kill();
  std::this_thread::sleep_for(std::chrono::milliseconds(2));
  const std::int64_t pushes = firmware_.pushes(), taken = firmware_.currentsTaken();
  EXPECT_TRUE(comes([&] { return !hasCurrent(); }));
  EXPECT_TRUE(comes([&] { return firmware_.currentsTaken() - taken > firmware_.pushes() - pushes; }))
      << "it was the board's own watchdog, and no zero came";
}

TEST_F(InTheMachine, WithoutAGuardTheBoardsOwnWatchdogEndsTheForce) {
  for (int round = 0; round < 5 && !hasCurrent(); ++round) {  // a busy machine may hold it up just then
    push("");
    kill();
  }
  ASSERT_TRUE(hasCurrent()) << "what the test above would see if there were no guard";
  std::this_thread::sleep_for(std::chrono::milliseconds(50));  // what was under way has come
  const std::int64_t taken = firmware_.currentsTaken();
  EXPECT_TRUE(comes([&] { return !hasCurrent(); }));
  EXPECT_EQ(firmware_.currentsTaken(), taken);
}

TEST_F(InTheMachine, WhoMayNotOpenItIsToldTheCommand) {
  ASSERT_EQ(::chmod(board_.node().c_str(), 0600), 0);
  const std::string line = firstLine("wooden", "", 65534);
  EXPECT_EQ(line.find("You do not have permission to open /dev/hidraw"), 0U) << line;
  EXPECT_NE(line.find("sudo tee /etc/udev/rules.d/70-underact-1234-0006.rules"), std::string::npos) << line;
}

TEST_F(InTheMachine, LookFindsItBySerialNumber) {
  const std::vector<device::Found> found = device::findDevice("wooden")->search();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].address, "0042");
  EXPECT_EQ(found[0].title, "WoodenHaptics, serial 0042");
  EXPECT_TRUE(found[0].missing.empty());
  board_.unplug();
  EXPECT_TRUE(device::findDevice("wooden")->search().empty());
}

}  // namespace
}  // namespace underact::test
