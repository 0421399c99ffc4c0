// The only file of the drivers that includes Boost.Beast, which takes the compiler longer than the rest of the room.
#include "device/haply/line.h"

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <deque>
#include <optional>
#include <utility>

#include "core/base/translate.h"

namespace underact::device::haply {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using asio::ip::tcp;
using boost::system::error_code;
using std::chrono::milliseconds;

constexpr std::size_t kMostKept = 16;               // frames that nobody took
constexpr std::size_t kLongestMessage = 1U << 20U;  // bytes
constexpr int kGoodbye_ms = 100;

tcp::resolver::results_type resolved(asio::io_context& context, const Place& place) {
  error_code error;
  tcp::resolver::results_type found =
      tcp::resolver(context).resolve(place.host, std::to_string(place.port), tcp::resolver::numeric_service, error);
  return error ? tcp::resolver::results_type() : found;
}

/// Runs until the answer is there or the time is over. false: no answer, or an error.
bool cameIn(asio::io_context& context, const std::optional<error_code>& answer, int time_ms) {
  const auto end = std::chrono::steady_clock::now() + milliseconds(time_ms);
  context.restart();
  while (!answer && context.run_one_until(end) > 0) continue;
  return answer && !*answer;
}

}  // namespace

struct Line::Impl {
  void read() {
    stream.async_read(buffer, [this](error_code error, std::size_t) {
      if (error) {
        is_open = false;
        return;
      }
      if (stream.got_text()) kept.push_back(beast::buffers_to_string(buffer.data()));
      if (kept.size() > kMostKept) kept.pop_front();
      buffer.consume(buffer.size());
      read();
    });
  }
  void watch(int number) {
#ifdef BOOST_ASIO_HAS_POSIX_STREAM_DESCRIPTOR
    if (!bell.is_open()) {
      error_code ignored;
      bell.assign(number, ignored);
    }
    if (std::exchange(is_watching, true)) return;
    bell.async_wait(asio::posix::stream_descriptor::wait_read, [this](error_code) { is_watching = false; });
#endif
  }

  asio::io_context context{1};
  beast::websocket::stream<beast::tcp_stream> stream{context};
#ifdef BOOST_ASIO_HAS_POSIX_STREAM_DESCRIPTOR
  asio::posix::stream_descriptor bell{context};  // somebody else's: given back in the end
#endif
  beast::flat_buffer buffer;
  std::deque<std::string> kept;
  std::string sent;
  bool is_open = true, is_sending = false, is_watching = false;
};

Line::Line(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

Line::~Line() {
  const auto end = std::chrono::steady_clock::now() + milliseconds(kGoodbye_ms);
  impl_->context.restart();
  while (impl_->is_open && impl_->is_sending && impl_->context.run_one_until(end) > 0) continue;
#ifdef BOOST_ASIO_HAS_POSIX_STREAM_DESCRIPTOR
  if (impl_->bell.is_open()) impl_->bell.release();
#endif
  if (impl_->is_open && !impl_->is_sending) {
    std::optional<error_code> answer;
    impl_->stream.async_close(beast::websocket::close_code::normal, [&](error_code error) { answer = error; });
    cameIn(impl_->context, answer, kGoodbye_ms);
    error_code ignored;
    beast::get_lowest_layer(impl_->stream).socket().close(ignored);
    cameIn(impl_->context, answer, kGoodbye_ms);  // its answer is on the stack here
  }
}

Result<std::unique_ptr<Line>> Line::open(const Place& place, int time_ms) {
  auto impl = std::make_unique<Impl>();
  std::optional<error_code> answer;
  const auto took = [&answer](error_code error, const auto&...) { answer = error; };
  const tcp::resolver::results_type found = resolved(impl->context, place);
  if (!found.empty()) beast::get_lowest_layer(impl->stream).async_connect(found, took);
  if (found.empty() || !cameIn(impl->context, answer, time_ms))
    return Problems{{said(TRANSLATE_NOOP("problem",
                                         "No service of Haply answers at %1. Is it running there? Another address is "
                                         "given as haply:HOST:PORT."),
                          {place.text()}),
                     {}}};
  error_code ignored;
  beast::get_lowest_layer(impl->stream).socket().set_option(tcp::no_delay(true), ignored);
  impl->stream.read_message_max(kLongestMessage);
  impl->stream.auto_fragment(false);
  impl->stream.text(true);
  answer.reset();
  impl->stream.async_handshake(place.text(), "/", took);
  if (!cameIn(impl->context, answer, time_ms))
    return Problems{{said(TRANSLATE_NOOP("problem",
                                         "What answers at %1 is not Haply's service. Another address is given as "
                                         "haply:HOST:PORT."),
                          {place.text()}),
                     {}}};
  impl->read();
  return std::unique_ptr<Line>(new Line(std::move(impl)));
}

void Line::wait(int bell, int time_ms) {
  if (bell >= 0) impl_->watch(bell);
#ifndef BOOST_ASIO_HAS_POSIX_STREAM_DESCRIPTOR
  bell = -1;
#endif
  impl_->context.restart();
  impl_->context.run_one_for(milliseconds(bell < 0 ? std::min(time_ms, 1) : time_ms));
  impl_->context.poll();
}

bool Line::receive(std::string& text) {
  if (impl_->kept.empty()) return false;
  text = std::move(impl_->kept.front());
  impl_->kept.pop_front();
  return true;
}

bool Line::send(std::string text) {
  if (impl_->is_sending || !impl_->is_open) return false;
  impl_->is_sending = true;
  impl_->sent = std::move(text);
  impl_->stream.async_write(asio::buffer(impl_->sent), [impl = impl_.get()](error_code error, std::size_t) {
    impl->is_sending = false;
    if (error) impl->is_open = false;
  });
  return true;
}

bool Line::isSending() const {
  return impl_->is_sending;
}

bool Line::isOpen() const {
  return impl_->is_open;
}

std::string getOverHttp(const Place& place, const std::string& target, int time_ms) {
  asio::io_context context{1};
  beast::tcp_stream stream(context);
  std::optional<error_code> answer;
  const auto took = [&answer](error_code error, const auto&...) { answer = error; };
  const tcp::resolver::results_type found = resolved(context, place);
  if (found.empty()) return {};
  stream.async_connect(found, took);
  if (!cameIn(context, answer, time_ms)) return {};
  http::request<http::empty_body> request{http::verb::get, target, 11};
  request.set(http::field::host, place.text());
  request.set(http::field::connection, "close");
  answer.reset();
  http::async_write(stream, request, took);
  if (!cameIn(context, answer, time_ms)) return {};
  beast::flat_buffer buffer;
  http::response_parser<http::string_body> parser;
  parser.body_limit(kLongestMessage);
  answer.reset();
  http::async_read(stream, buffer, parser, took);
  if (!cameIn(context, answer, time_ms) || parser.get().result() != http::status::ok) return {};
  return parser.get().body();
}

}  // namespace underact::device::haply
