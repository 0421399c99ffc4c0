#include "device/haply/line.h"

#include <algorithm>
#include <chrono>
#include <deque>
#include <optional>
#include <utility>

#include "core/base/translate.h"
#include "core/web_socket/connection.h"

namespace underact::device::haply {
namespace {

using Clock = std::chrono::steady_clock;
using web_socket::Milliseconds;

constexpr std::size_t kMaxKept = 16;                // frames that nobody took
constexpr std::size_t kLongestMessage = 1U << 20U;  // bytes
constexpr int kGoodbye_ms = 100;

/// Runs until the answer is there or the time is over. false: no answer, or it is that something failed.
bool cameIn(web_socket::EventLoop& loop, const std::optional<bool>& answer, int time_ms) {
  const Clock::time_point end = Clock::now() + Milliseconds(time_ms);
  while (!answer && loop.runOneUntil(end)) continue;
  return answer && *answer;
}

}  // namespace

struct Line::Impl {
  void read() {
    connection.read([this](bool is_read, std::string_view message, bool is_text) {
      if (!is_read) {
        is_open = false;
        return;
      }
      if (is_text) kept.emplace_back(message);
      if (kept.size() > kMaxKept) kept.pop_front();
      read();
    });
  }

  web_socket::EventLoop loop;
  web_socket::Connection connection{loop};
  web_socket::Bell bell{loop};
  std::deque<std::string> kept;
  std::string sent;
  bool is_open = true, is_sending = false;
};

Line::Line(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

Line::~Line() {
  const Clock::time_point end = Clock::now() + Milliseconds(kGoodbye_ms);
  while (impl_->is_open && impl_->is_sending && impl_->loop.runOneUntil(end)) continue;
  impl_->bell.forget();
  if (impl_->is_open && !impl_->is_sending) {
    std::optional<bool> answer;
    impl_->connection.close(web_socket::kNormalEnd, [&](bool is_done) { answer = is_done; });
    cameIn(impl_->loop, answer, kGoodbye_ms);
    impl_->connection.end();
    cameIn(impl_->loop, answer, kGoodbye_ms);  // its answer is on the stack here
  }
}

Result<std::unique_ptr<Line>> Line::open(const Place& place, int time_ms) {
  auto impl = std::make_unique<Impl>();
  std::optional<bool> answer;
  const auto took = [&answer](bool is_done) { answer = is_done; };
  impl->connection.limit({.message_bytes = kLongestMessage});
  impl->connection.connect(place.host, place.port, took);
  if (!cameIn(impl->loop, answer, time_ms))
    return Problems{{phrase(TRANSLATE_NOOP("problem",
                                           "No service of Haply answers at %1. Is it running there? Another address is "
                                           "given as haply:HOST:PORT."),
                            {place.text()}),
                     {}}};
  answer.reset();
  impl->connection.handshake(place.text(), took);
  if (!cameIn(impl->loop, answer, time_ms))
    return Problems{{phrase(TRANSLATE_NOOP("problem",
                                           "What answers at %1 is not Haply's service. Another address is given as "
                                           "haply:HOST:PORT."),
                            {place.text()}),
                     {}}};
  impl->read();
  return std::unique_ptr<Line>(new Line(std::move(impl)));
}

void Line::wait(int bell, int time_ms) {
  const bool rings = bell >= 0 && impl_->bell.watch(bell);
  impl_->loop.runOneUntil(Clock::now() + Milliseconds(rings ? time_ms : std::min(time_ms, 1)));
  impl_->loop.poll();
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
  impl_->connection.write(impl_->sent, false, [impl = impl_.get()](bool is_written) {
    impl->is_sending = false;
    if (!is_written) impl->is_open = false;
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
  web_socket::EventLoop loop;
  web_socket::Connection connection(loop);
  std::optional<bool> answer;
  connection.connect(place.host, place.port, [&answer](bool is_done) { answer = is_done; });
  if (!cameIn(loop, answer, time_ms)) return {};
  answer.reset();
  std::string body;
  connection.get(place.text(), target, [&](std::optional<std::string> came) {
    answer = came.has_value();
    body = std::move(came).value_or("");
  });
  return cameIn(loop, answer, time_ms) ? body : "";
}

}  // namespace underact::device::haply
