// The only file that includes Boost.Beast, which takes the compiler longer than the rest of the room.
#include "app/serve/server.h"

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <map>
#include <optional>
#include <utility>

namespace underact::serve {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using asio::ip::tcp;
using boost::system::error_code;

constexpr std::chrono::milliseconds kBusy{1}, kIdle{10};
constexpr std::chrono::seconds kHandshake{5};
constexpr std::chrono::seconds kSilence{30};  // a client that does not answer a ping for so long is taken for dead
constexpr std::uint32_t kLongestHeader = 16384;
constexpr std::uint64_t kLongestBody = 65536;

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
  Connection(tcp::socket socket, Shared& shared, int number)
      : stream_(std::move(socket)), shared_(shared), number_(number) {}
  void begin() {
    parser_.header_limit(kLongestHeader);
    parser_.body_limit(kLongestBody);
    beast::get_lowest_layer(stream_).expires_after(kHandshake);
    http::async_read_header(beast::get_lowest_layer(stream_), buffer_, parser_,
                            [self = shared_from_this()](error_code error, std::size_t) { self->answer(error); });
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
    error_code ignored;
    beast::get_lowest_layer(stream_).socket().close(ignored);
  }

 private:
  void answer(error_code error) {
    if (error || is_over_) return end();
    const http::request<http::string_body>& request = parser_.get();
    const auto origin = request.find(http::field::origin);
    const bool is_refused = origin != request.end() && std::find(shared_.origins.begin(), shared_.origins.end(),
                                                                 std::string(origin->value())) == shared_.origins.end();
    if (is_refused)
      return respond(http::status::forbidden, "Pages of this origin may not connect. See --allow-origin.\n");
    if (!websocket::is_upgrade(request))
      return http::async_read(
          beast::get_lowest_layer(stream_), buffer_, parser_,
          [self = shared_from_this()](error_code unread, std::size_t) { self->answerHttp(unread); });
    beast::get_lowest_layer(stream_).expires_never();
    stream_.set_option(websocket::stream_base::timeout{kHandshake, kSilence, true});
    stream_.read_message_max(kLongestFrame);
    stream_.auto_fragment(false);  // a message is one frame: simple clients read no others
    error_code ignored;
    beast::get_lowest_layer(stream_).socket().set_option(tcp::no_delay(true), ignored);
    stream_.async_accept(request, [self = shared_from_this()](error_code refused) {
      if (refused || self->is_over_) return self->end();
      self->is_open_ = true;
      self->shared_.endpoint.open(self->number_);
      self->pump();
    });
  }
  void answerHttp(error_code error) {
    if (error || is_over_) return end();
    const http::request<http::string_body>& request = parser_.get();
    const std::optional<HttpAnswer> answer =
        shared_.endpoint.answer({std::string(request.method_string()), std::string(request.target()), request.body()});
    if (!answer) return respond(http::status::upgrade_required, "This is a WebSocket service.\n");
    response_.set(http::field::content_type, "application/json");
    respond(static_cast<http::status>(answer->status), answer->body);
  }
  void respond(http::status status, std::string body) {
    response_.result(status);
    response_.version(parser_.get().version());
    response_.body() = std::move(body);
    response_.keep_alive(false);
    response_.prepare_payload();
    http::async_write(beast::get_lowest_layer(stream_), response_,
                      [self = shared_from_this()](error_code, std::size_t) { self->end(); });
  }
  void read() {
    is_reading_ = true;
    stream_.async_read(buffer_, [self = shared_from_this()](error_code error, std::size_t) {
      self->is_reading_ = false;
      if (error || self->is_over_) return self->end();
      const auto data = self->buffer_.data();
      self->shared_.endpoint.receive(self->number_, {static_cast<const char*>(data.data()), data.size()},
                                     self->stream_.got_text(), nowSeconds());
      self->buffer_.consume(self->buffer_.size());
      if (self->shared_.endpoint.isBusy()) self->shared_.hurry();
      self->pump();
    });
  }
  void write() {
    is_writing_ = true;
    message_ = shared_.endpoint.takeMessage(number_);
    stream_.binary(message_.is_binary);
    stream_.async_write(asio::buffer(message_.bytes), [self = shared_from_this()](error_code error, std::size_t) {
      self->is_writing_ = false;
      if (error || self->is_over_) return self->end();
      self->pump();
    });
  }
  void close() {
    is_writing_ = true;  // nothing more is written
    stream_.async_close(websocket::close_code::policy_error, [self = shared_from_this()](error_code) { self->end(); });
  }

  websocket::stream<beast::tcp_stream> stream_;
  Shared& shared_;
  int number_;
  beast::flat_buffer buffer_;
  http::request_parser<http::string_body> parser_;
  http::response<http::string_body> response_;
  Message message_;
  bool is_open_ = false, is_reading_ = false, is_writing_ = false, is_over_ = false;
};

/// A port, and the endpoint behind it.
struct Listener {
  Listener(asio::io_context& context, std::vector<std::string> allowed)
      : origins(std::move(allowed)), acceptor(context) {}

  void accept() {
    acceptor.async_accept([this](error_code error, tcp::socket socket) {
      if (error == asio::error::operation_aborted || shared == nullptr) return;
      if (!error) take(std::move(socket));
      if (!error || connections.size() < kMostClients + kMostUnknown) {
        accept();
      } else {
        pauses = true;  // no descriptors are left: the next one is taken with the next beat
      }
    });
  }
  void take(tcp::socket socket) {
    const std::optional<int> number = shared->endpoint.connect(nowSeconds());
    if (!number) return;  // too many: the socket closes
    const auto connection = std::make_shared<Connection>(std::move(socket), *shared, *number);
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
    error_code ignored;
    acceptor.close(ignored);
  }

  std::vector<std::string> origins;
  tcp::acceptor acceptor;
  std::unique_ptr<Shared> shared;
  bool pauses = false;
  std::map<int, std::shared_ptr<Connection>> connections;
};

}  // namespace

struct Server::Impl {
  Problems listen(int port, std::vector<std::string> origins) {
    auto listener = std::make_unique<Listener>(context, std::move(origins));
    tcp::acceptor& acceptor = listener->acceptor;
    const tcp::endpoint here(asio::ip::address_v4::loopback(), static_cast<std::uint16_t>(port));
    error_code error;
    acceptor.open(here.protocol(), error);
    if (!error) acceptor.set_option(tcp::acceptor::reuse_address(true), error);
    if (!error) acceptor.bind(here, error);
    if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
    if (error)
      return Problems{{"The service cannot listen at port " + std::to_string(port) + ": " + error.message() +
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
    if (!goes_on()) return context.stop();
    beatIn(isBusy() ? kBusy : kIdle);
  }
  void beatIn(std::chrono::milliseconds time) {
    timer.expires_after(time);  // instead of an earlier wait
    timer.async_wait([this](error_code error) {
      if (!error) beat();
    });
  }
  void hurry() {
    if (goes_on && timer.expiry() > std::chrono::steady_clock::now() + kBusy) beatIn(kBusy);
  }

  asio::io_context context{1};
  asio::steady_timer timer{context};
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
  error_code error;
  return impl_->listeners.at(listener)->acceptor.local_endpoint(error).port();
}

void Server::run(const std::vector<Endpoint*>& endpoints, const std::function<bool()>& goes_on) {
  begin(endpoints);
  impl_->goes_on = goes_on;
  impl_->beat();
  impl_->context.run();
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
  impl_->context.restart();  // where all was done at the last step, it has stopped
  impl_->context.poll();
  impl_->poll();
  impl_->context.poll();  // what was written, so that the next message can be
}

void Server::end() {
  for (const auto& one : impl_->listeners) one->end();
  impl_->context.restart();
  impl_->context.poll();  // what was under way ends
  for (const auto& one : impl_->listeners) one->shared.reset();
}

}  // namespace underact::serve
