#pragma once
#include <sys/resource.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace underact::test {

/// A D-Bus of the test's own: a dbus-daemon that ends with it; the system's bus for this process meanwhile.
class PrivateBus {
 public:
  static bool isPossible();  // whether there is a dbus-daemon
  PrivateBus();
  ~PrivateBus();
  PrivateBus(const PrivateBus&) = delete;
  PrivateBus& operator=(const PrivateBus&) = delete;
  const std::string& address() const { return address_; }  // empty: it did not start

 private:
  int pid_ = -1;
  std::string address_;
};

/// Sets DBUS_SYSTEM_BUS_ADDRESS for as long as it lives.
class SystemBusAt {
 public:
  explicit SystemBusAt(const std::string& address);
  ~SystemBusAt();
  SystemBusAt(const SystemBusAt&) = delete;
  SystemBusAt& operator=(const SystemBusAt&) = delete;

 private:
  std::optional<std::string> before_;
};

/// What a stand-in of RealtimeKit says and does.
struct Rtkit {
  std::int32_t max_priority = 20;
  std::int64_t longest_us = 200'000;
  bool refuses = false;
  bool answers = true;  // MakeThreadRealtime
  bool acts = true;     // makes the thread real-time, where this process may
};

/// It, on a bus, in a thread of the test.
class FakeRtkit {
 public:
  struct Asked {
    int calls = 0;
    std::uint64_t thread = 0;
    std::uint32_t priority = 0;
    rlimit rest{};         // RLIMIT_RTTIME at that moment
    bool is_held = false;  // it was to act and may not
  };
  FakeRtkit(const std::string& address, const Rtkit& behaviour);
  ~FakeRtkit();
  FakeRtkit(const FakeRtkit&) = delete;
  FakeRtkit& operator=(const FakeRtkit&) = delete;
  Asked asked() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace underact::test
