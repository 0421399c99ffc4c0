#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/serve/endpoint.h"
#include "app/serve/steered.h"

namespace underact::serve {

inline constexpr int kProtocolVersion = 1;

/// How a service is to run.
struct ServiceOptions {
  std::string token;           // that a client has to know; never empty
  bool anyone_steers = false;  // a client that steers takes the lease from another
};

/// The live service without its sockets: JSON text in, messages out. Everything that the wire (the guide's page
/// live_service.md) says is here: requests, the lease, subscriptions, events, limits. Whatever it
/// steers takes effect between two ticks of the host, so a session of the host has every act at its tick. One thread:
/// that of the host; it never waits for the servo or for a client. What takes longer than some milliseconds, a thread
/// of its own does.
class Service final : public Endpoint {
 public:
  /// scene: loaded; it outlives the service.
  Service(Steered& scene, ServiceOptions options);
  ~Service() override;

  int connect() override;
  /// A lease ends, and its force.
  void disconnect(int connection) override;
  bool hasMessage(int connection) const override;
  Message takeMessage(int connection) override;
  bool mayBeRead(int connection) const override;
  bool closes(int connection) const override;
  void receive(int connection, Frame frame, double now_s) override;
  bool isKnown(int connection) const override;
  void heed(Frame& frame, bool is_known) override;
  std::optional<std::string> tooSoon(std::string_view text) const override;

  // From what is steered, in drain().
  void add(const servo::TickRecord& record);
  void add(const Fault& fault, std::int64_t tick);

  /// Takes the ticks since the last call to subscribers, answers what has come into effect, tells events.
  void poll(double now_s) override;
  /// Whether an answer waits for a tick, or somebody subscribed.
  bool isBusy() const override;

  // A client that speaks another language, in this program: it has no messages, and ends with disconnect().
  int join(const std::string& name);
  /// Adds a force, N in W, for so long. false: it may not steer now.
  bool push(int connection, const Vec3& f_T_W, double for_s);
  const servo::TickRecord& lastTick() const;
  const scene::Description& scene() const;

  bool hasClients() const;
  /// The clients that have said hello, in the order in which they connected.
  std::vector<std::string> clientNames() const;
  /// The client that steers; empty: none.
  std::string steeringClient() const;
  /// Takes the lease from all clients, or lets them have it again.
  void takeBack(bool on);
  bool isTakenBack() const;

  /// At the end: stops the servo, and the force of clients; poll() takes the ticks until it has come down.
  void letGo();
  /// Whether the servo may still push.
  bool pushes() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace underact::serve
