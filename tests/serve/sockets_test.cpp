// The service behind its sockets, whose thread goes on while that of the service does nothing.
#include <algorithm>

#include "app/serve/rate.h"
#include "app/serve/server.h"
#include "core/web_socket/connection.h"
#include "tests/serve/desk.h"
#include "tests/support/comes.h"

namespace underact::test {
namespace {

constexpr const char* kStart = R"({"id": "start", "do": "start"})";
constexpr const char* kStop = R"({"id": "stop", "do": "stop"})";
constexpr const char* kForce = R"({"id": "force", "do": "force", "f_N": [0.3, 0, 0], "for_ms": 1000})";

/// A client, in the test's own thread.
class Caller {
 public:
  explicit Caller(int port) : connection_(loop_) {
    connection_.limit({});
    connection_.connect("127.0.0.1", port, [this, port](bool is_connected) {
      if (is_connected)
        connection_.handshake("localhost:" + std::to_string(port), [this](bool is_done) {
          is_open_ = is_done;
          read();
        });
    });
  }
  void send(const std::string& text) { waiting_.push_back(text); }
  void poll() {
    if (is_open_ && !is_writing_) write();
    loop_.poll();
  }
  bool hasSent() const { return waiting_.empty(); }
  /// The answers to this id, as it is in JSON.
  std::size_t answers(const std::string& id, const std::string& words = "") const {
    return static_cast<std::size_t>(std::count_if(heard_.begin(), heard_.end(), [&](const std::string& one) {
      return one.starts_with("{\"id\": " + id + ",") && one.find(words) != std::string::npos;
    }));
  }

 private:
  void write() {
    is_writing_ = !waiting_.empty();
    if (!is_writing_) return;
    connection_.write(waiting_.front(), false, [this](bool) {
      waiting_.pop_front();
      write();
    });
  }
  void read() {
    connection_.read([this](bool is_read, std::string_view text, bool) {
      if (!is_read) return;
      heard_.emplace_back(text);
      read();
    });
  }

  web_socket::EventLoop loop_;
  web_socket::Connection connection_;
  bool is_open_ = false, is_writing_ = false;
  std::deque<std::string> waiting_;
  std::vector<std::string> heard_;
};

/// A service whose thread is the test's: it works in serve() alone.
struct ServedDesk {
  ServedDesk() {
    host->load(sphereScene());
    server.begin({&service});
    host->begin();
  }
  ~ServedDesk() { server.end(); }
  /// Until that is so; the service does nothing.
  template <class Condition>
  bool wait(const Condition& condition, bool serves = false) {
    return comes([&] {
      if (serves) server.step();
      for (const auto& caller : callers) caller->poll();
      return condition();
    });
  }
  /// The same; the service works meanwhile.
  template <class Condition>
  bool serve(const Condition& condition) {
    return wait(condition, true);
  }
  Caller& connect() { return *callers.emplace_back(std::make_unique<Caller>(server.port())); }
  Caller& join() {
    Caller& caller = connect();
    caller.send(R"({"id": 0, "do": "hello", "token": ")" + std::string(kToken) + R"(", "name": "one"})");
    EXPECT_TRUE(serve([&] { return caller.answers("0", "true") == 1; }));
    return caller;
  }
  bool runs() { return host->snapshot().mode == servo::Mode::Running; }
  bool stands() { return host->snapshot().mode == servo::Mode::Idle; }
  /// A client that pushes.
  Caller& push() {
    Caller& caller = join();
    caller.send(kStart);
    caller.send(kForce);
    EXPECT_TRUE(serve([&] { return caller.answers("\"force\"") == 1 && runs(); }));
    return caller;
  }

  ScratchFolder folder;
  std::unique_ptr<servo::Host> host = makeHost(servo::Clock::Thread, "still");
  serve::HostAlone alone{*host, serve::HostAloneOptions{folder.path() + "/sessions"}};
  serve::Service service{alone, serve::ServiceOptions{kToken}};
  serve::Server server = serve::Server::open(0, {}).value();
  std::vector<std::unique_ptr<Caller>> callers;
};

TEST(Sockets, AStopActsWhileTheServicesThreadDoesNothingAndVoidsStartsThatCameBeforeItAndNoneAfter) {
  ServedDesk desk;
  Caller& pusher = desk.push();
  Caller& other = desk.join();
  pusher.send(kStart);
  ASSERT_TRUE(desk.wait([&] { return pusher.hasSent(); }));
  other.send(kStop);
  ASSERT_TRUE(desk.wait([&] { return desk.stands(); }));
  EXPECT_EQ(other.answers("\"stop\""), 0U);
  ASSERT_TRUE(desk.serve([&] { return pusher.answers("\"start\"") == 2 && other.answers("\"stop\"") == 1; }));
  EXPECT_EQ(other.answers("\"stop\"", "\"mode\": \"stopped\""), 1U);
  EXPECT_EQ(pusher.answers("\"start\"", "was stopped after this request"), 1U);
  EXPECT_FALSE(desk.runs());
  for (const char* const text : {kStop, kStart}) pusher.send(text);
  ASSERT_TRUE(desk.serve([&] { return pusher.answers("\"start\"") == 3; }));
  EXPECT_TRUE(desk.runs()) << "a stop and a start one after the other";
}

TEST(Sockets, AStopBehindAFloodOfTheSameClientEndsTheForceAndEachRequestIsAnsweredOnce) {
  ServedDesk desk;
  Caller& pusher = desk.push();
  constexpr std::size_t kFlood = 4000;
  for (std::size_t index = 0; index < kFlood; ++index) pusher.send(kForce);
  pusher.send(kStop);
  EXPECT_TRUE(desk.wait([&] { return desk.stands(); }));
  EXPECT_TRUE(desk.serve([&] { return pusher.answers("\"force\"") == kFlood + 1 && pusher.answers("\"stop\"") == 1; }));
  EXPECT_GE(pusher.answers("\"force\"", "one request too many"), 1000U) << "2000 may wait";
  EXPECT_FALSE(desk.runs());
}

TEST(Sockets, AFloodOfStopsCostsNoMoreThanOtherRequestsAndIsNeverRefused) {
  ServedDesk desk;
  Caller& caller = desk.join();
  for (int index = 0; index < 3000; ++index) caller.send(kStop);
  EXPECT_TRUE(desk.serve([&] { return caller.answers("\"stop\"") == 3000; }));
  EXPECT_EQ(caller.answers("\"stop\"", "true"), 3000U);
}

TEST(Sockets, WhoHasNotSaidHelloStopsNothing) {
  ServedDesk desk;
  desk.push();
  Caller& stranger = desk.connect();
  stranger.send(kStop);
  EXPECT_TRUE(desk.serve([&] { return stranger.answers("\"stop\"", "must be \\\"hello\\\"") == 1; }));
  EXPECT_TRUE(desk.runs());
}

TEST(Rate, GivesABurstAndThenSoMuchASecondAndWhoTakesMoreWaitsASecondAtMost) {
  serve::Bucket bucket(100.0, 10.0);
  int taken = 0;
  for (int step = 0; step <= 1000; ++step) {
    for (; bucket.has(1.0, 5.0 + 0.001 * step); ++taken) bucket.take(1.0);
    if (step == 0) EXPECT_EQ(taken, 10);
  }
  EXPECT_NEAR(taken, 110, 1);
  bucket.take(1e6);
  EXPECT_NEAR(bucket.wait_s(), 1.0, 1e-9);
}

}  // namespace
}  // namespace underact::test
