#include "core/system/sandbox.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <new>

namespace underact::system {
namespace {

/// What waitpid() says of a sealed process that did this; what it gives is its exit status.
int sealed(const std::function<int()>& work) {
  const pid_t pid = ::fork();
  if (pid == 0) {
    if (!enterSandbox(std::uint64_t{256} << 20, 1.0)) _exit(99);
    _exit(work());
  }
  int status = 0;
  while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

void expectKilledBy(int signal, int status) {
  ASSERT_TRUE(WIFSIGNALED(status)) << status;
  EXPECT_EQ(WTERMSIG(status), signal);
}

#if defined(__linux__) && (defined(__x86_64__) || defined(__aarch64__))

TEST(Seal, LeavesMemoryAndTheEnd) {
  const int status = sealed([] {
    std::string text(1 << 20, 'x');
    return text.back() == 'x' ? 7 : 8;
  });
  ASSERT_TRUE(WIFEXITED(status)) << status;
  EXPECT_EQ(WEXITSTATUS(status), 7);
}

TEST(Seal, NoFileIsOpened) {
  const int status = sealed([] {
    const bool is_opened = ::open("/etc/passwd", O_RDONLY) >= 0;
    return !is_opened && errno == EACCES ? 7 : 8;  // by the filter: that no more may be open is said in other words
  });
  ASSERT_TRUE(WIFEXITED(status)) << status;
  EXPECT_EQ(WEXITSTATUS(status), 7);
}

TEST(Seal, NoSocketNoProcessNoProgram) {
  expectKilledBy(SIGSYS, sealed([] { return ::socket(AF_INET, SOCK_STREAM, 0); }));
  expectKilledBy(SIGSYS, sealed([] { return static_cast<int>(::fork()); }));
  expectKilledBy(SIGSYS, sealed([] { return ::execl("/bin/true", "true", nullptr); }));
  expectKilledBy(SIGSYS, sealed([] { return ::unlink("/dev/null/nowhere"); }));
  expectKilledBy(SIGSYS, sealed([] { return ::kill(1, 0); }));
}

#endif

#if !defined(__SANITIZE_ADDRESS__)
TEST(Seal, NoMoreMemoryThanGiven) {
  const int status = sealed([] { return ::operator new (std::size_t{512} << 20, std::nothrow) == nullptr ? 7 : 8; });
  ASSERT_TRUE(WIFEXITED(status)) << status;
  EXPECT_EQ(WEXITSTATUS(status), 7);
}
#endif

TEST(Seal, NoMoreTimeThanGiven) {
  const int status = sealed([] {
    volatile bool goes_on = true;
    while (goes_on) {
    }
    return 0;
  });
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_TRUE(WTERMSIG(status) == SIGKILL || WTERMSIG(status) == SIGXCPU) << WTERMSIG(status);
}

}  // namespace
}  // namespace underact::system
