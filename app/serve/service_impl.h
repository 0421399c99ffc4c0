#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/serve/clients.h"
#include "app/serve/request.h"
#include "app/serve/service.h"
#include "app/serve/worker.h"

namespace underact::serve {

// Inside the room: the service's parts, which answer its requests.

constexpr std::size_t kLongestWords = 4096;  // of a key that is a name or a path, bytes

/// "running", "stopped" or "fault".
const char* modeWord(servo::Mode mode);

/// What a worker has read for a client.
struct Opened {
  std::optional<scene::Description> scene = {};
  std::optional<scene::Constraint> constraint = {};
  bool is_named = false;
};

/// An answer that waits for the tick in which its request comes into effect.
struct Waiting {
  int client = 0;
  std::string id;
  std::uint64_t orders = 0, revision = 0;
  bool has_mode = false;
  bool stops = false;  // the tick must not be one that still runs, or there was another order since
  double since_s = 0.0;
};

/// Who edited, and by which request.
struct Edit {
  std::string by, what;
};

/// A service, and who is connected to it.
struct Service::Impl {
  Impl(Steered& scene, ServiceOptions wanted) : steered(scene), host(scene.host()), options(std::move(wanted)) {}

  struct Command {
    const char* name;
    bool steers;
    void (Impl::*perform)(Client&, const Request&);
  };
  static const std::array<Command, 19> kCommands;

  /// Null: it has gone.
  Client* find(int number) {
    const auto found = clients.find(number);
    return found == clients.end() ? nullptr : &found->second;
  }

  // Requests.
  void hello(Client& client, const Request& request);
  void challenge(Client& client, const Request& request);
  void tellScene(Client& client, const Request& request);
  void load(Client& client, const Request& request);
  void tellSettings(Client& client, const Request& request);
  void get(Client& client, const Request& request);
  void set(Client& client, const Request& request);
  void start(Client& client, const Request& request);
  void stop(Client& client, const Request& request);
  void force(Client& client, const Request& request);
  void mark(Client& client, const Request& request);
  void record(Client& client, const Request& request);
  void subscribe(Client& client, const Request& request);
  void unsubscribe(Client& client, const Request& request);
  void tellStatus(Client& client, const Request& request);
  void lease(Client& client, const Request& request);
  void add(Client& client, const Request& request);
  void remove(Client& client, const Request& request);
  void move(Client& client, const Request& request);

  /// A frame, at once or once the worker has read it or what was before it.
  void receive(Client& client, Frame frame);
  void readLong(const Client& client, Frame frame);
  void holdBack(Client& client, Frame frame);
  void take(Client& client, const Result<Request>& request);
  void perform(Client& client, const Request& request);
  void refuse(Client& client, const Request& request, const Problems& problems) {
    client.send(problemAnswer(request.id, problems));
  }
  void waitForTick(const Client& client, const std::string& id, bool has_mode = false) {
    waiting.push_back({client.number, id, host.orders(), 0, has_mode, false, now_s});
  }
  /// Edits or loads, and answers once it is in effect.
  void edit(Client& client, const Request& request, const scene::Description& edited, std::int64_t over_ticks = 0);
  /// Has a worker read. root: of the problems' paths.
  void open(const Client& client, const Request& request, const std::string& root,
            std::function<Result<Opened>()> read);
  void finish(Client& client, const Request& request, const std::string& root, const Result<Opened>& opened);
  /// Sends what a worker makes of the scene as it is now.
  void reckon(const Client& client, std::function<std::string(const scene::Description&)> answer);
  bool isAtWork(int client) const { return reading.has(client) || reckoning.has(client); }
  /// What workers have done, and what had to wait for it.
  void takeWork();

  // The lease.
  bool maySteer(const Client& client) const { return whyNotSteer(client).empty(); }
  /// Why this client may not steer now, in a sentence; empty: it may.
  std::string whyNotSteer(const Client& client) const;
  /// Who steers; empty: nobody.
  std::string holderName() const;
  void take(const Client& client);
  void giveBack();
  void push(const Vec3& f_T_W, double for_s) {
    host.push(f_T_W, std::max<std::int64_t>(1, std::llround(for_s * host.rateHz())));
    pushed = true;
  }
  void endForce() {
    if (std::exchange(pushed, false)) host.push(Vec3::Zero(), 0);
  }

  // Ticks and events.
  void tick(const servo::TickRecord& record);
  void tellEdit(std::int64_t tick, std::uint64_t revision, const Edit& edit);
  void answerWaiting(const servo::TickRecord& record);
  json::ObjectText event(const char* name, std::int64_t at_tick) const {
    json::ObjectText text;
    text.addText("event", name);
    text.addInteger("tick", at_tick);
    return text;
  }
  void tell(const json::ObjectText& text) {
    for (auto& [number, client] : clients) {
      if (client.is_known && !client.closes) client.tell(text.text());
    }
  }

  Steered& steered;
  servo::Host& host;
  ServiceOptions options;
  std::map<int, Client> clients;
  int next_number = 1;
  std::optional<int> holder;
  bool is_taken_back = false;  // by the person at the program itself
  bool pushed = false;
  std::deque<Waiting> waiting;
  std::map<std::uint64_t, Edit> edits;  // that are not in effect yet
  servo::TickRecord last;
  double now_s = 0.0;
  Worker reading, reckoning;  // of files; of long requests and answers
};

}  // namespace underact::serve
