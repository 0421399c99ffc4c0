#pragma once
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace underact::test {

/// A network between two programs of this machine: who connects to its port is led to another one. It can be pulled, as
/// a plug is (nobody is told, and nothing comes any more), cut, as when a program dies (both ends are told), held up,
/// and slow.
class Cable {
 public:
  explicit Cable(int to_port);
  ~Cable();
  Cable(const Cable&) = delete;
  Cable& operator=(const Cable&) = delete;
  int port() const { return port_; }

  /// Nothing passes any more, not even what is under way; nobody can connect. Has happened when it returns.
  void pull();
  /// Both ends of every connection are closed; others may connect.
  void cut();
  /// Who connects from now on gets through; what was connected before the plug was pulled is gone.
  void plug();
  /// What comes is kept until it is let go.
  void hold(bool on) { held_ = on; }
  /// Each byte takes so long, and up to jitter_ms more, by a seed; the order stays.
  void delay(double delay_ms, double jitter_ms) {
    delay_ns_ = static_cast<std::int64_t>(1e6 * delay_ms);
    jitter_ns_ = static_cast<std::int64_t>(1e6 * jitter_ms);
  }

 private:
  struct Lane;
  struct Line;
  void run();
  void listen();
  void accept();
  bool carry(Line& line);

  const int to_port_;
  int port_ = 0, listener_ = -1;
  std::mutex mutex_;  // of all below
  std::vector<std::unique_ptr<Line>> lines_;
  bool is_pulled_ = false;
  std::uint64_t seed_ = 1;
  std::atomic<bool> ends_{false}, held_{false};
  std::atomic<std::int64_t> delay_ns_{0}, jitter_ns_{0};
  std::thread thread_;
};

}  // namespace underact::test
