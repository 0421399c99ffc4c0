#include "app/serve/server.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

#include "app/serve/sockets.h"

namespace underact::serve {
namespace {

constexpr std::chrono::milliseconds kBusy{1}, kIdle{10};
constexpr double kStep_s = 0.005;  // of requests, between two looks at the ticks
constexpr std::size_t kMaxSent = 64, kMaxSentBytes = std::size_t{1} << 20;  // given to the sockets, and not gone yet

double nowSeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// An endpoint, and its connections.
struct Served {
  explicit Served(Endpoint& its_endpoint) : endpoint(its_endpoint) {}

  /// Whether there is anything new for the sockets.
  bool take(const std::vector<std::shared_ptr<Line>>& fresh) {
    bool is_news = false;
    for (const std::shared_ptr<Line>& line : fresh) {
      if (line->question) {
        HttpAnswer answer = endpoint.answer(*line->question);
        const std::lock_guard<std::mutex> lock(line->mutex);
        line->answer = std::move(answer);
        is_news = true;
      } else {
        lines[endpoint.connect()] = line;
      }
    }
    return is_news;
  }
  /// Gives the endpoint the next frame of a connection. false: there is none, or it has to wait.
  bool receive(int number, Line& line) {
    const bool is_read = endpoint.mayBeRead(number);
    std::unique_lock<std::mutex> lock(line.mutex);
    if (line.frames.empty() || !(is_read || line.frames.front().has_stopped)) return false;
    Frame frame = std::move(line.frames.front());
    lock.unlock();
    const std::size_t bytes = frame.text.size();
    endpoint.receive(number, std::move(frame), nowSeconds());
    const bool is_known = endpoint.isKnown(number);
    lock.lock();
    line.frames.pop_front();
    line.frame_bytes -= bytes;
    line.leave.is_known = is_known;
    return true;
  }
  /// Tells the sockets what the endpoint has for them. Whether there is anything new.
  bool send(int number, Line& line) {
    std::unique_lock<std::mutex> lock(line.mutex);
    std::size_t count = line.messages.size(), bytes = line.message_bytes;
    lock.unlock();
    std::vector<Message> messages;
    for (; count < kMaxSent && bytes < kMaxSentBytes && endpoint.hasMessage(number); ++count) {
      messages.push_back(endpoint.takeMessage(number));
      bytes += messages.back().bytes.size();
    }
    const Leave leave{endpoint.isKnown(number), endpoint.mayBeRead(number),
                      !endpoint.hasMessage(number) && endpoint.closes(number)};
    lock.lock();
    const bool is_news = std::exchange(line.leave, leave) != leave || !messages.empty();
    for (Message& message : messages) {
      line.message_bytes += message.bytes.size();
      line.messages.push_back(std::move(message));
    }
    return is_news;
  }
  /// Whether nothing more comes of it.
  bool isOver(int number, Line& line) const {
    const std::lock_guard<std::mutex> lock(line.mutex);
    return line.is_gone && (line.frames.empty() || !endpoint.mayBeRead(number));
  }

  Endpoint& endpoint;
  std::map<int, std::shared_ptr<Line>> lines;  // by the numbers of their connections
};

}  // namespace

struct Server::Impl {
  Problems listen(int port, std::vector<std::string> origins) {
    const std::string why = sockets.listen(port, std::move(origins));
    if (why.empty()) return {};
    return Problems{{"The service cannot listen at port " + std::to_string(port) + ": " + why +
                     ". With port 0 it takes a free one."}};
  }
  void ring() {
    const std::lock_guard<std::mutex> lock(mutex);
    is_rung = true;
    wakes.notify_one();
  }
  void wait() {
    const bool is_busy =
        std::any_of(served.begin(), served.end(), [](const Served& one) { return one.endpoint.isBusy(); });
    std::unique_lock<std::mutex> lock(mutex);
    wakes.wait_for(lock, is_busy ? kBusy : kIdle, [this] { return is_rung; });
    is_rung = false;
  }
  /// One request of each connection in turn, as nobody is to wait for another's hundreds. Whether there was any: then
  /// the sockets have room for more.
  bool receive() {
    const double end_s = nowSeconds() + kStep_s;
    bool was_any = false;
    for (bool has_more = true; has_more; was_any = was_any || has_more) {
      if (goes_on && !goes_on()) return was_any;
      has_more = false;
      for (Served& one : served) {
        for (auto& [number, line] : one.lines) has_more = one.receive(number, *line) || has_more;
      }
      if (has_more && nowSeconds() > end_s) {
        ring();
        return true;
      }
    }
    for (Served& one : served) {
      std::erase_if(one.lines, [&](const auto& each) {
        const bool is_over = one.isOver(each.first, *each.second);
        if (is_over) one.endpoint.disconnect(each.first);
        return is_over;
      });
    }
    return was_any;
  }
  void step() {
    bool is_news = false;
    for (std::size_t door = 0; door < served.size(); ++door)
      is_news = served[door].take(sockets.takeNew(door)) || is_news;
    is_news = receive() || is_news;
    for (Served& one : served) {
      one.endpoint.poll(nowSeconds());
      for (auto& [number, line] : one.lines) is_news = one.send(number, *line) || is_news;
    }
    if (is_news) sockets.look();
  }

  std::mutex mutex;  // of:
  bool is_rung = false;
  std::condition_variable wakes;
  std::vector<Served> served;
  std::function<bool()> goes_on;  // of run(); none: step() is called by another loop
  Sockets sockets{[this] { ring(); }};
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

Problems Server::alsoListen(int port, std::vector<std::string> origins) {
  return impl_->listen(port, std::move(origins));
}

int Server::port(std::size_t listener) const {
  return impl_->sockets.port(listener);
}

void Server::run(const std::vector<Endpoint*>& endpoints, const std::function<bool()>& goes_on) {
  begin(endpoints);
  impl_->goes_on = goes_on;
  while (goes_on()) {
    impl_->step();
    impl_->wait();
  }
  impl_->goes_on = nullptr;
  end();
}

void Server::begin(const std::vector<Endpoint*>& endpoints) {
  for (Endpoint* const endpoint : endpoints) impl_->served.emplace_back(*endpoint);
  impl_->sockets.start(endpoints);
}

void Server::step() {
  impl_->step();
}

void Server::end() {
  impl_->sockets.stop();
  for (Served& one : impl_->served) {
    for (const auto& [number, line] : one.lines) one.endpoint.disconnect(number);
  }
  impl_->served.clear();
}

}  // namespace underact::serve
