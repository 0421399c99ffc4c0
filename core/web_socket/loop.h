#pragma once
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace underact::web_socket {

class Connection;

using Milliseconds = std::chrono::milliseconds;  // all times of this room

/// Waits for sockets and times, and calls what was asked for. One thread at a time; post() and stop() from any. What is
/// made with it must not outlive it; what it was asked to call and has not, it never calls once it is gone.
class EventLoop {
 public:
  struct Impl;
  EventLoop();  // nothing to wait for yet
  ~EventLoop();
  EventLoop(const EventLoop&) = delete;
  EventLoop& operator=(const EventLoop&) = delete;

  /// Until stop(), which may come first.
  void run();
  /// Ends run(), soon.
  void stop();
  /// Waits for one call, until then. false: none came, or there is nothing left to wait for.
  bool runOneUntil(std::chrono::steady_clock::time_point end);
  /// Calls all that can be without waiting.
  void poll();
  /// Calls it from the thread that runs the loop.
  void post(std::function<void()> what);

  Impl& impl() const { return *impl_; }  // for this room alone

 private:
  std::unique_ptr<Impl> impl_;
};

/// Calls something once, later.
class Timer {
 public:
  /// loop: outlives it.
  explicit Timer(EventLoop& loop);
  ~Timer();
  /// Calls it after so much time, instead of what an earlier start() was for.
  void start(Milliseconds time, std::function<void()> then);
  /// When it is over, or was.
  std::chrono::steady_clock::time_point end() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Ends a wait of the loop. Its descriptor is somebody else's, and stays open.
class Bell {
 public:
  /// loop: outlives it.
  explicit Bell(EventLoop& loop);
  ~Bell();
  /// The next wait ends as soon as the descriptor is readable. It is the same one at each call until forget(). false:
  /// not on this system.
  bool watch(int descriptor);
  /// Gives the descriptor back: the next watch() may be of another.
  void forget();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// A port of this computer's own address alone.
class Listener {
 public:
  /// Not open yet. loop: outlives it.
  explicit Listener(EventLoop& loop);
  ~Listener();
  Listener(Listener&&) noexcept;  // the other one can only be destroyed
  /// port: 0: a free one. Why it is not possible; empty: it is.
  std::string open(int port);
  /// That of open(), or what was free.
  int port() const;
  /// Calls it with the next one who connects; with none, if no descriptors are left. Not called after close().
  void accept(std::function<void(std::optional<Connection>)> then);
  /// Takes nobody any more.
  void close();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace underact::web_socket
