// Where the system lets no process be shut off, no file of a stranger's is read.
#include <gtest/gtest.h>

#if defined(__linux__) && (defined(__x86_64__) || defined(__aarch64__)) && !defined(__SANITIZE_THREAD__)
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <functional>
#include <string>

#include "core/mesh_file/read_file.h"
#include "core/record/session.h"
#include "core/record/session_writer.h"
#include "tests/support/scratch_folder.h"

namespace underact {
namespace {

/// From here on nobody who is started from this process may filter its system calls: as in some containers.
bool forbidFilters() {
  std::array filter{
      sock_filter BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
      sock_filter BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_prctl, 0, 3),
      sock_filter BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, args)),
      sock_filter BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, PR_SET_SECCOMP, 0, 1),
      sock_filter BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EPERM),
      sock_filter BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
  };
  const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
  return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

/// What is said there, of a process of its own.
std::string givenThere(const std::function<Problems()>& work) {
  std::array<int, 2> pipe{-1, -1};
  EXPECT_EQ(::pipe(pipe.data()), 0);
  const pid_t pid = ::fork();
  if (pid == 0) {
    const Problems problems = forbidFilters() ? work() : Problems{{"no filter", {}}};
    const std::string words = problems.empty() ? "it was read" : std::string(problems.front().sentence);
    (void)!::write(pipe[1], words.data(), words.size());
    _exit(0);
  }
  ::close(pipe[1]);
  std::string words(4096, '\0');
  const ssize_t count = ::read(pipe[0], words.data(), words.size());
  ::close(pipe[0]);
  int status = 0;
  while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  words.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
  return words;
}

std::string refusalOf(const std::string& reader) {
  return "The file was not opened: " + reader + " could not be isolated from the rest of this computer";
}

}  // namespace

TEST(NotSandboxed, AMeshIsNotRead) {
  const test::ScratchFolder folder;
  const std::string path = folder.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_TRUE(mesh_file::readFile(path)) << "where it is shut off, it reads";
  const std::string words = givenThere([&] {
    const Result<mesh_file::RawMesh> raw = mesh_file::readFile(path);
    return raw ? Problems{} : raw.problems();
  });
  EXPECT_EQ(words.substr(0, words.find(',')), refusalOf("underact-mesh-reader"));
}

TEST(NotSandboxed, ASessionIsNotRead) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("s.h5");
  ASSERT_TRUE(record::SessionWriter::create(path, {}));
  EXPECT_TRUE(record::Session::open(path)) << "where it is shut off, it reads";
  const std::string words = givenThere([&] {
    const Result<record::Session> session = record::Session::open(path);
    return session ? Problems{} : session.problems();
  });
  EXPECT_EQ(words.substr(0, words.find(',')), refusalOf("underact-session-reader"));
}

}  // namespace underact
#endif
