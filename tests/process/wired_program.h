#pragma once
#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "tests/process/wire_port.h"
#include "tests/support/comes.h"

namespace underact::test {

/// The arm's side of a wire: it stands still, answers each force with where it is, and keeps what it was told.
class WiredArm {
 public:
  explicit WiredArm(int fd) : fd_(fd), thread_(&WiredArm::run, this) {}
  ~WiredArm() {
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

/// A program with the arm at the other end of a wire, whose descriptor is its first argument.
class WiredProgram {
 public:
  /// terminal: it has one of its own, which is read and closed in the place of a pipe.
  WiredProgram(std::string program, const std::vector<std::string>& arguments, bool terminal = false) {
    int wire[2], out[2];
    EXPECT_EQ(::socketpair(AF_UNIX, SOCK_SEQPACKET, 0, wire), 0);
    EXPECT_EQ(terminal ? openTerminal(out) : ::pipe2(out, O_CLOEXEC), 0);
    ::fcntl(wire[0], F_SETFD, FD_CLOEXEC);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, out[1], STDOUT_FILENO);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    if (terminal) {  // the first that the leader of a session opens is its own
      posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSID);
      posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, ::ptsname(out[0]), O_RDWR, 0);
    }
    std::vector<std::string> words{program, std::to_string(wire[1])};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    EXPECT_EQ(posix_spawn(&pid_, program.c_str(), &actions, &attributes, pointers.data(), environ), 0) << program;
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    ::close(wire[1]);
    ::close(out[1]);
    out_ = out[0];
    arm_ = std::make_unique<WiredArm>(wire[0]);
  }
  ~WiredProgram() {
    if (!gone_) {
      ::kill(pid_, SIGCONT);
      ::kill(pid_, SIGKILL);
      waitUntilGone();
    }
    if (out_ >= 0) ::close(out_);
  }
  WiredProgram(const WiredProgram&) = delete;
  WiredProgram& operator=(const WiredProgram&) = delete;
  WiredArm& arm() { return *arm_; }
  pid_t pid() const { return pid_; }
  void send(int signal) { ::kill(pid_, signal); }
  /// Its next line, or what came until its patience or its life ended.
  std::string line() {
    std::string text;
    pollfd ready{out_, POLLIN, 0};
    for (char letter = 0; ::poll(&ready, 1, 20'000) > 0 && ::read(out_, &letter, 1) == 1 && letter != '\n';)
      text += letter;
    return text;
  }
  /// The next line in which those words are; empty: it ended, or was silent for 20 s.
  std::string lineWith(const std::string& words) {
    for (std::string text = line(); !text.empty(); text = line()) {
      if (text.find(words) != std::string::npos) return text;
    }
    return {};
  }
  /// Nobody reads what it says any more.
  void closeOutput() { ::close(std::exchange(out_, -1)); }
  /// It has no room for another word, and nobody reads it: as when a pager stands. What is said waits.
  void fillOutput() {
    const std::string again = "/proc/self/fd/" + std::to_string(out_);
    const int fd = ::open(again.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);  // the end that is written to
    const std::string page(4096, '.');
    while (::write(fd, page.data(), page.size()) > 0) continue;
    while (::write(fd, page.data(), 1) > 0) continue;
    ::close(fd);
  }
  /// Whether it has ended by itself within 20 s; its exit status, or below 0 the signal that ended it.
  bool ends(int& status) {
    const bool is_gone = comes([&] { return ::waitpid(pid_, &status, WNOHANG) == pid_; });
    gone_ = gone_ || is_gone;
    status = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    return is_gone;
  }
  void waitUntilGone() {
    while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
    }
    gone_ = true;
  }

 private:
  static int openTerminal(int (&ends)[2]) {
    ends[0] = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (::grantpt(ends[0]) != 0 || ::unlockpt(ends[0]) != 0) return -1;
    ends[1] = ::open(::ptsname(ends[0]), O_RDWR | O_NOCTTY | O_CLOEXEC);
    return ends[1] < 0 ? -1 : 0;
  }

  pid_t pid_ = -1;
  int out_ = -1;
  bool gone_ = false;
  std::unique_ptr<WiredArm> arm_;
};

}  // namespace underact::test
