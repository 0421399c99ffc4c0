#pragma once
#include <cstddef>
#include <iosfwd>
#include <memory>
#include <string>
#include <thread>

namespace underact::cli {

/// Lines for people, from threads that must never wait for whoever reads them: a terminal that was paused, a pipe that
/// nobody empties. A thread of its own writes them, in order, whole and at once. Lines beyond kMax that wait are
/// dropped, and their number is printed once lines are read again.
class Lines {
 public:
  static constexpr std::size_t kMax = 64;

  /// fd: behind out, see Streams::out_fd. out outlives it.
  Lines(std::ostream& out, int fd);
  /// Writes what is waiting, as far as it is read within a second.
  ~Lines();
  Lines(const Lines&) = delete;
  Lines& operator=(const Lines&) = delete;

  /// Any thread. Never waits. line: as printed() shows it.
  void operator()(const std::string& line);

 private:
  struct State;
  std::shared_ptr<State> state_;  // of this and of the thread, which may outlast it in a write that never returns
  std::thread thread_;
};

}  // namespace underact::cli
