// The only file that includes Boost.Beast. Of what is asked of it, Beast makes hundreds of functions for each type of
// handler, of buffers and of stream anew. So it sees one type of each here, and the compiler takes a third of the time.
#include "core/web_socket/connection.h"

#include <algorithm>
#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <utility>

#include "core/web_socket/loop_impl.h"

namespace underact::web_socket {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using asio::ip::tcp;
using boost::system::error_code;

constexpr std::uint64_t kLongestAnswer = 1U << 20U;  // bytes

/// What is to be done next, of whatever type. Beast's can only be moved, and std::function takes what can be copied.
class Next {
 public:
  template <class Step>
  requires(!std::is_same_v<Step, Next>) explicit Next(Step step)
      : step_(std::make_unique<Held<Step>>(std::move(step))) {}
  void operator()(error_code error, std::size_t bytes = 0) { std::exchange(step_, nullptr)->run(error, bytes); }

 private:
  struct Any {
    virtual ~Any() = default;
    virtual void run(error_code error, std::size_t bytes) = 0;
  };
  template <class Step>
  struct Held final : Any {
    explicit Held(Step its_step) : step(std::move(its_step)) {}
    void run(error_code error, std::size_t bytes) override { step(error, bytes); }
    Step step;
  };
  std::unique_ptr<Any> step_;
};

/// The first buffers of any sequence of them. Who reads or writes some bytes goes on with the others afterwards.
template <class Buffer>
class Buffers {
 public:
  using value_type = Buffer;
  using const_iterator = const Buffer*;
  template <class Sequence>
  explicit Buffers(const Sequence& sequence) {
    const auto end = asio::buffer_sequence_end(sequence);
    for (auto one = asio::buffer_sequence_begin(sequence); one != end && count_ < buffers_.size(); ++one)
      buffers_[count_++] = *one;
  }
  const Buffer* begin() const { return buffers_.data(); }
  const Buffer* end() const { return buffers_.data() + count_; }

 private:
  std::array<Buffer, 16> buffers_;
  std::size_t count_ = 0;
};

/// A tcp_stream that sees one type of handler and one of buffers.
class Transport {
 public:
  using next_layer_type = beast::tcp_stream;
  using executor_type = beast::tcp_stream::executor_type;
  explicit Transport(beast::tcp_stream tcp) : tcp_(std::move(tcp)) {}
  beast::tcp_stream& next_layer() { return tcp_; }
  const beast::tcp_stream& next_layer() const { return tcp_; }
  executor_type get_executor() { return tcp_.get_executor(); }
  template <class Sequence, class Step>
  void async_read_some(const Sequence& sequence, Step&& step) {
    read(Buffers<asio::mutable_buffer>(sequence), Next(std::forward<Step>(step)));
  }
  template <class Sequence, class Step>
  void async_write_some(const Sequence& sequence, Step&& step) {
    write(Buffers<asio::const_buffer>(sequence), Next(std::forward<Step>(step)));
  }
  /// Beast calls it, by this name, when a WebSocket has ended.
  template <class Step>
  friend void async_teardown(beast::role_type role, Transport& transport, Step&& step) {
    transport.tearDown(role, Next(std::forward<Step>(step)));
  }

 private:
  void read(const Buffers<asio::mutable_buffer>& buffers, Next next) { tcp_.async_read_some(buffers, std::move(next)); }
  void write(const Buffers<asio::const_buffer>& buffers, Next next) { tcp_.async_write_some(buffers, std::move(next)); }
  void tearDown(beast::role_type role, Next next) { websocket::async_teardown(role, tcp_.socket(), std::move(next)); }

  beast::tcp_stream tcp_;
};

/// The one kind of handler: it keeps the connection until it has been called.
struct Done {
  std::shared_ptr<Connection::Impl> connection;
  Then then;
  template <class... Ignored>
  void operator()(error_code error, const Ignored&...) const {
    then(!error);
  }
};

}  // namespace

struct Connection::Impl {
  explicit Impl(beast::tcp_stream tcp) : stream(Transport(std::move(tcp))) {}
  Transport& transport() { return stream.next_layer(); }
  beast::tcp_stream& tcp() { return beast::get_lowest_layer(stream); }
  void hurryUp() {  // else small messages wait for one another
    error_code ignored;
    tcp().socket().set_option(tcp::no_delay(true), ignored);
  }
  void writeText(std::string text, Done done) {
    written = std::move(text);
    asio::async_write(transport(), asio::buffer(written), std::move(done));
  }
  void prepare() {
    stream.read_message_max(limits.message_bytes);
    stream.auto_fragment(false);
  }

  // false: compression is not even compiled. By itself Beast neither offers nor accepts it.
  websocket::stream<Transport, false> stream;
  Limits limits;
  beast::flat_buffer buffer;
  std::size_t taken = 0;  // bytes of it, which the last message was
  http::request_parser<http::string_body> asked;
  std::string written;                              // over plain HTTP
  http::response_parser<http::string_body> answer;  // of get()
};

Connection connectionOf(tcp::socket socket) {
  return Connection(std::make_shared<Connection::Impl>(beast::tcp_stream(std::move(socket))));
}

Connection::Connection(EventLoop& loop) : impl_(std::make_shared<Impl>(beast::tcp_stream(loop.impl().context))) {}
Connection::Connection(std::shared_ptr<Impl> impl) : impl_(std::move(impl)) {}
Connection::~Connection() = default;
Connection::Connection(Connection&&) noexcept = default;
Connection& Connection::operator=(Connection&&) noexcept = default;

void Connection::limit(const Limits& limits) {
  impl_->limits = limits;
}

void Connection::readHeader(Then then) {
  impl_->asked.header_limit(impl_->limits.header_bytes);
  impl_->asked.body_limit(impl_->limits.body_bytes);
  if (impl_->limits.patience) impl_->tcp().expires_after(*impl_->limits.patience);
  http::async_read_header(impl_->transport(), impl_->buffer, impl_->asked, Done{impl_, std::move(then)});
}

void Connection::readBody(Then then) {
  http::async_read(impl_->transport(), impl_->buffer, impl_->asked, Done{impl_, std::move(then)});
}

Request Connection::request() const {
  const http::request<http::string_body>& asked = impl_->asked.get();
  const auto origin = asked.find(http::field::origin);
  Request request{std::string(asked.method_string()),
                  std::string(asked.target()),
                  asked.body(),
                  std::string(asked[http::field::host]),
                  {},
                  false};
  if (origin != asked.end()) request.origin = std::string(origin->value());
  request.is_upgrade = websocket::is_upgrade(asked);
  return request;
}

void Connection::respond(int status, const std::string& content_type, const std::string& body, Then then) {
  const bool is_new = impl_->asked.get().version() >= 11;
  std::string text = is_new ? "HTTP/1.1 " : "HTTP/1.0 ";
  text += std::to_string(status) + " " + std::string(http::obsolete_reason(static_cast<http::status>(status))) + "\r\n";
  if (!content_type.empty()) text += "Content-Type: " + content_type + "\r\n";
  if (is_new) text += "Connection: close\r\n";
  impl_->writeText(text + "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body,
                   Done{impl_, std::move(then)});
}

void Connection::accept(Then then) {
  impl_->tcp().expires_never();  // from now on the WebSocket's own
  const auto none = websocket::stream_base::none();
  const Limits& limits = impl_->limits;
  impl_->stream.set_option(websocket::stream_base::timeout{
      limits.patience ? *limits.patience : none, limits.silence ? *limits.silence : none, limits.silence.has_value()});
  impl_->prepare();
  impl_->hurryUp();
  impl_->stream.async_accept(impl_->asked.get(), Done{impl_, std::move(then)});
}

void Connection::connect(const std::string& host, int port, Then then) {
  error_code error;
  tcp::resolver resolver(impl_->stream.get_executor());
  const tcp::resolver::results_type found =
      resolver.resolve(host, std::to_string(port), tcp::resolver::numeric_service, error);
  if (error || found.empty()) return then(false);
  impl_->tcp().async_connect(found, Done{impl_, std::move(then)});
}

void Connection::handshake(const std::string& host, Then then) {
  impl_->hurryUp();
  impl_->prepare();
  impl_->stream.async_handshake(host, "/", Done{impl_, std::move(then)});
}

void Connection::get(const std::string& host, const std::string& target,
                     std::function<void(std::optional<std::string>)> then) {
  impl_->answer.body_limit(kLongestAnswer);
  const auto read = [impl = impl_.get(), then](bool is_read) {
    const bool is_answer = is_read && impl->answer.get().result() == http::status::ok;
    then(is_answer ? std::optional(impl->answer.get().body()) : std::nullopt);
  };
  const auto written = [impl = impl_, read, then](bool is_written) {
    if (!is_written) return then(std::nullopt);
    http::async_read(impl->transport(), impl->buffer, impl->answer, Done{impl, read});
  };
  impl_->writeText("GET " + target + " HTTP/1.1\r\nHost: " + host + "\r\nConnection: close\r\n\r\n",
                   Done{impl_, written});
}

void Connection::read(std::function<void(bool is_done, std::string_view message, bool is_text)> then) {
  impl_->buffer.consume(std::exchange(impl_->taken, 0));
  impl_->stream.async_read(
      impl_->buffer,
      Done{impl_, [impl = impl_.get(), then = std::move(then)](bool is_done) {
             const auto data = impl->buffer.data();
             impl->taken = is_done ? data.size() : 0;
             then(is_done, {static_cast<const char*>(data.data()), impl->taken}, impl->stream.got_text());
           }});
}

void Connection::write(std::string_view message, bool is_binary, Then then) {
  impl_->stream.binary(is_binary);
  impl_->stream.async_write(asio::buffer(message), Done{impl_, std::move(then)});
}

void Connection::close(std::uint16_t reason, Then then) {
  impl_->stream.async_close(static_cast<websocket::close_code>(reason), Done{impl_, std::move(then)});
}

void Connection::end() {
  error_code ignored;
  impl_->tcp().socket().close(ignored);
}

}  // namespace underact::web_socket
