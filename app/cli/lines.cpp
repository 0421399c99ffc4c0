#include "app/cli/lines.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <ostream>
#include <utility>

#include "core/base/printed.h"
#include "core/system/channel.h"

namespace underact::cli {
namespace {

constexpr std::chrono::milliseconds kFarewell{1000};
constexpr int kPoll_ms = 50;
// A pipe with any room accepts this many bytes without blocking.
constexpr std::size_t kAtOnce = 512;

}  // namespace

struct Lines::State {
  std::ostream* out = nullptr;
  int fd = -1;
  std::mutex mutex;
  std::condition_variable changed;
  std::deque<std::string> waiting;
  std::size_t left_out = 0;
  bool ends = false, ended = false;
  std::chrono::steady_clock::time_point give_up{};

  void run();
  bool isOver();
  bool write(std::string_view text);
};

/// The reader is not waited for any longer.
bool Lines::State::isOver() {
  const std::scoped_lock lock(mutex);
  return ends && std::chrono::steady_clock::now() >= give_up;
}

/// false: it is not read any more, or not in time.
bool Lines::State::write(std::string_view text) {
  if (fd < 0) {
    *out << text << std::flush;
    return true;
  }
  while (!text.empty()) {
    if (!system::waitToWrite(fd, kPoll_ms)) {
      if (isOver()) return false;
      continue;
    }
    const std::ptrdiff_t written = system::writeSome(fd, text.substr(0, kAtOnce));
    if (written < 0 && errno != EAGAIN) return false;
    if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

void Lines::State::run() {
  std::unique_lock lock(mutex);
  for (bool is_read = true;;) {
    changed.wait(lock, [this] { return ends || !waiting.empty(); });
    if (waiting.empty()) break;
    std::string text = std::exchange(waiting.front(), {}) + '\n';
    waiting.pop_front();
    if (waiting.empty() && left_out > 0)
      text += "(" + std::to_string(std::exchange(left_out, 0)) + " lines were left out, because nobody read them.)\n";
    if (!is_read) continue;
    lock.unlock();
    is_read = write(text);
    lock.lock();
  }
  ended = true;
  changed.notify_all();
}

Lines::Lines(std::ostream& out, int fd) : state_(std::make_shared<State>()) {
  state_->out = &out;
  state_->fd = fd;
  thread_ = std::thread([state = state_] { state->run(); });
}

Lines::~Lines() {
  bool has_ended = false;
  {
    std::unique_lock lock(state_->mutex);
    state_->ends = true;
    state_->give_up = std::chrono::steady_clock::now() + kFarewell;
    state_->changed.notify_all();
    // A terminal may accept part of a line and then block: that write never returns, and ends with the program.
    has_ended = state_->changed.wait_for(lock, 2 * kFarewell, [this] { return state_->ended; });
  }
  has_ended ? thread_.join() : thread_.detach();
}

void Lines::operator()(const std::string& line) {
  const std::scoped_lock lock(state_->mutex);
  if (state_->waiting.size() >= kMax) {
    ++state_->left_out;
    return;
  }
  state_->waiting.push_back(printed(line));
  state_->changed.notify_all();
}

}  // namespace underact::cli
