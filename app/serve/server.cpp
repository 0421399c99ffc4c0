#include "app/serve/server.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <optional>
#include <utility>

#include "core/web_socket/connection.h"

namespace underact::serve {
namespace {

using web_socket::Milliseconds;

constexpr Milliseconds kBusy{1}, kIdle{10};
constexpr Milliseconds kHandshake{5000};
constexpr Milliseconds kSilence{30000};  // a client that does not answer a ping for so long is taken for dead
constexpr std::uint32_t kLongestHeader = 16384;
constexpr std::uint64_t kLongestBody = 65536;

constexpr int kForbidden = 403, kUpgradeRequired = 426;  // of HTTP

double nowSeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// What the connections of an endpoint share between begin() and end().
struct Shared {
  Endpoint& endpoint;
  const std::vector<std::string>& origins;
  std::function<void()> hurry;  // a request waits for a tick: look soon
};

/// One connection; it lives as long as an operation of it is under way.
class Connection : public std::enable_shared_from_this<Connection> {
 public:
  Connection(web_socket::Connection line, Shared& shared, int number)
      : line_(std::move(line)), shared_(shared), number_(number) {}
  void begin() {
    line_.limit({kLongestHeader, kLongestBody, kLongestFrame, kHandshake, kSilence});
    line_.readHeader([self = shared_from_this()](bool is_read) { self->answer(is_read); });
  }
  /// Sends what waits, reads on where that was put off, and closes what is to be closed.
  void pump() {
    if (!is_open_) {
      if (shared_.endpoint.closes(number_)) end();
      return;
    }
    if (!is_writing_ && shared_.endpoint.hasMessage(number_)) {
      write();
    } else if (!is_writing_ && shared_.endpoint.closes(number_)) {
      close();
    }
    if (!is_reading_ && shared_.endpoint.mayBeRead(number_)) read();
  }
  bool isOver() const { return is_over_; }
  void end() {
    is_over_ = true;
    line_.end();
  }

 private:
  void answer(bool is_read) {
    if (!is_read || is_over_) return end();
    const web_socket::Request request = line_.request();
    const bool is_refused = request.origin && std::find(shared_.origins.begin(), shared_.origins.end(),
                                                        *request.origin) == shared_.origins.end();
    if (is_refused) return respond(kForbidden, "", "Pages of this origin may not connect. See --allow-origin.\n");
    if (!request.is_upgrade)
      return line_.readBody([self = shared_from_this()](bool is_whole) { self->answerHttp(is_whole); });
    line_.accept([self = shared_from_this()](bool is_accepted) {
      if (!is_accepted || self->is_over_) return self->end();
      self->is_open_ = true;
      self->shared_.endpoint.open(self->number_);
      self->pump();
    });
  }
  void answerHttp(bool is_read) {
    if (!is_read || is_over_) return end();
    const web_socket::Request request = line_.request();
    const std::optional<HttpAnswer> answer = shared_.endpoint.answer({request.method, request.target, request.body});
    if (!answer) return respond(kUpgradeRequired, "", "This is a WebSocket service.\n");
    respond(answer->status, "application/json", answer->body);
  }
  void respond(int status, const std::string& type, const std::string& body) {
    line_.respond(status, type, body, [self = shared_from_this()](bool) { self->end(); });
  }
  void read() {
    is_reading_ = true;
    line_.read([self = shared_from_this()](bool is_read, std::string_view message, bool is_text) {
      self->is_reading_ = false;
      if (!is_read || self->is_over_) return self->end();
      self->shared_.endpoint.receive(self->number_, message, is_text, nowSeconds());
      if (self->shared_.endpoint.isBusy()) self->shared_.hurry();
      self->pump();
    });
  }
  void write() {
    is_writing_ = true;
    message_ = shared_.endpoint.takeMessage(number_);
    line_.write(message_.bytes, message_.is_binary, [self = shared_from_this()](bool is_written) {
      self->is_writing_ = false;
      if (!is_written || self->is_over_) return self->end();
      self->pump();
    });
  }
  void close() {
    is_writing_ = true;  // nothing more is written
    line_.close(web_socket::kPolicyError, [self = shared_from_this()](bool) { self->end(); });
  }

  web_socket::Connection line_;
  Shared& shared_;
  int number_;
  Message message_;
  bool is_open_ = false, is_reading_ = false, is_writing_ = false, is_over_ = false;
};

/// A port, and the endpoint behind it.
struct Listener {
  Listener(web_socket::Loop& loop, std::vector<std::string> allowed) : origins(std::move(allowed)), door(loop) {}

  void accept() {
    door.accept([this](std::optional<web_socket::Connection> line) {
      if (shared == nullptr) return;
      const bool is_here = line.has_value();
      if (is_here) take(std::move(*line));
      if (is_here || connections.size() < kMostClients + kMostUnknown) {
        accept();
      } else {
        pauses = true;  // no descriptors are left: the next one is taken with the next beat
      }
    });
  }
  void take(web_socket::Connection line) {
    const std::optional<int> number = shared->endpoint.connect(nowSeconds());
    if (!number) return;  // too many: the socket closes
    const auto connection = std::make_shared<Connection>(std::move(line), *shared, *number);
    connections[*number] = connection;
    connection->begin();
  }
  void poll() {
    shared->endpoint.poll(nowSeconds());
    for (auto one = connections.begin(); one != connections.end();) {
      one->second->pump();
      if (!one->second->isOver()) {
        ++one;
        continue;
      }
      shared->endpoint.disconnect(one->first);
      one = connections.erase(one);
    }
    if (std::exchange(pauses, false)) accept();
  }
  void end() {
    for (auto& [number, connection] : connections) {
      connection->end();
      shared->endpoint.disconnect(number);
    }
    connections.clear();
    door.close();
  }

  std::vector<std::string> origins;
  web_socket::Listener door;
  std::unique_ptr<Shared> shared;
  bool pauses = false;
  std::map<int, std::shared_ptr<Connection>> connections;
};

}  // namespace

struct Server::Impl {
  Problems listen(int port, std::vector<std::string> origins) {
    auto listener = std::make_unique<Listener>(loop, std::move(origins));
    if (const std::string why = listener->door.open(port); !why.empty())
      return Problems{{"The service cannot listen at port " + std::to_string(port) + ": " + why +
                       ". With port 0 it takes a free one."}};
    listeners.push_back(std::move(listener));
    return {};
  }
  bool isBusy() const {
    return std::any_of(listeners.begin(), listeners.end(),
                       [](const auto& one) { return one->shared && one->shared->endpoint.isBusy(); });
  }
  void poll() {
    for (const auto& one : listeners) {
      if (one->shared) one->poll();
    }
  }
  void beat() {
    poll();
    if (!goes_on()) return loop.stop();
    beatIn(isBusy() ? kBusy : kIdle);
  }
  void beatIn(Milliseconds time) {
    timer.start(time, [this] { beat(); });
  }
  void hurry() {
    if (goes_on && timer.end() > std::chrono::steady_clock::now() + kBusy) beatIn(kBusy);
  }

  web_socket::Loop loop;
  web_socket::Timer timer{loop};
  std::vector<std::unique_ptr<Listener>> listeners;
  std::function<bool()> goes_on;  // of run(); none: step() is called by another loop
};

Server::Server(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Server::~Server() = default;
Server::Server(Server&&) noexcept = default;
Server& Server::operator=(Server&&) noexcept = default;

Result<Server> Server::open(int port, std::vector<std::string> origins) {
  auto impl = std::make_unique<Impl>();
  if (Problems problems = impl->listen(port, std::move(origins)); !problems.empty()) return problems;
  return Server(std::move(impl));
}

Problems Server::alsoListen(int port) {
  return impl_->listen(port, {});
}

int Server::port(std::size_t listener) const {
  return impl_->listeners.at(listener)->door.port();
}

void Server::run(const std::vector<Endpoint*>& endpoints, const std::function<bool()>& goes_on) {
  begin(endpoints);
  impl_->goes_on = goes_on;
  impl_->beat();
  impl_->loop.run();
  impl_->goes_on = nullptr;
  end();
}

void Server::begin(const std::vector<Endpoint*>& endpoints) {
  for (std::size_t index = 0; index < endpoints.size(); ++index) {
    Listener& listener = *impl_->listeners.at(index);
    listener.shared =
        std::make_unique<Shared>(Shared{*endpoints[index], listener.origins, [impl = impl_.get()] { impl->hurry(); }});
    listener.accept();
  }
}

void Server::step() {
  impl_->loop.poll();
  impl_->poll();
  impl_->loop.poll();  // what was written, so that the next message can be
}

void Server::end() {
  for (const auto& one : impl_->listeners) one->end();
  impl_->loop.poll();  // what was under way ends
  for (const auto& one : impl_->listeners) one->shared.reset();
}

}  // namespace underact::serve
