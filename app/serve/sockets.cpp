#include "app/serve/sockets.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <string_view>
#include <thread>
#include <utility>

#include "app/serve/clients.h"
#include "app/serve/rate.h"
#include "core/web_socket/connection.h"

namespace underact::serve {
namespace {

using web_socket::Milliseconds;

constexpr Milliseconds kPatience{5000};  // until a connection has said who it is, whatever it sends
constexpr Milliseconds kSilence{30000};  // a client that does not answer a ping for so long is taken for dead
constexpr Milliseconds kNoDescriptors{100};
constexpr std::uint32_t kLongestHeader = 16384;
constexpr std::uint64_t kLongestBody = 65536;
constexpr std::size_t kMaxFrames = 2000, kMaxFrameBytes = 4U << 20U;  // that wait for the endpoint

constexpr int kForbidden = 403, kMisdirected = 421;  // of HTTP
constexpr std::array<const char*, 3> kLoopback{"127.0.0.1", "localhost", "[::1]"};

double socketNow_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Whether a request is for this service: a page can have its own name resolved to this computer's address.
bool isHere(std::string host, int port) {
  std::transform(host.begin(), host.end(), host.begin(), [](unsigned char one) { return std::tolower(one); });
  return std::any_of(kLoopback.begin(), kLoopback.end(),
                     [&](const std::string name) { return host == name || host == name + ":" + std::to_string(port); });
}

/// Clients without a browser name no origin, or the service's own.
bool mayAsk(const std::optional<std::string>& origin, const std::vector<std::string>& origins, int port) {
  return !origin || std::find(origins.begin(), origins.end(), *origin) != origins.end() ||
         (origin->starts_with("http://") && origin->ends_with(":" + std::to_string(port)) &&
          isHere(origin->substr(7), port));
}

class Wire;

/// A port, and who has connected to it.
struct Door {
  Door(web_socket::EventLoop& its_loop, std::vector<std::string> allowed)
      : loop(its_loop), origins(std::move(allowed)), listener(loop), pause(loop) {}
  void accept();
  void take(web_socket::Connection connection);
  /// Lets the endpoint's thread know of a line.
  void tell(const std::shared_ptr<Line>& line) {
    {
      const std::lock_guard<std::mutex> lock(mutex);
      fresh.push_back(line);
    }
    came();
  }

  web_socket::EventLoop& loop;
  std::vector<std::string> origins;
  web_socket::Listener listener;
  web_socket::Timer pause;
  Endpoint* endpoint = nullptr;
  std::function<void()> came;
  std::vector<std::shared_ptr<Wire>> wires;  // also of those who have not said what they want
  std::mutex mutex;                          // of:
  std::vector<std::shared_ptr<Line>> fresh;  // that the endpoint's thread does not know yet
};

/// One connection, in the sockets' thread; it lives as long as an operation of it is under way.
class Wire : public std::enable_shared_from_this<Wire> {
 public:
  Wire(web_socket::Connection socket, Door& door)
      : socket_(std::move(socket)), door_(door), deadline_(door.loop), delay_(door.loop) {}

  void begin() {
    deadline_.start(kPatience, [weak = weak_from_this()] {
      if (const auto self = weak.lock(); self && !self->isKnown()) self->end();
    });
    socket_.limit({kLongestHeader, kLongestBody, kLongestFrame, kPatience, kSilence});
    socket_.readHeader([self = shared_from_this()](bool is_read) { self->judge(is_read); });
  }
  /// Sends what waits, reads on where that was put off, and closes what is to be closed.
  void pump() {
    if (is_over_) return;
    std::unique_lock<std::mutex> lock(line_->mutex);
    if (!is_open_) {
      const auto answer = std::exchange(line_->answer, std::nullopt);
      lock.unlock();
      if (answer) respond(answer->status, answer->type, answer->body);
      return;
    }
    const bool writes = !is_writing_ && !line_->messages.empty();
    const bool closes = !is_writing_ && !writes && line_->leave.closes;
    if (writes) {
      message_ = std::move(line_->messages.front());
      line_->messages.pop_front();
      line_->message_bytes -= message_.bytes.size();
    }
    const bool reads = !is_reading_ && mayRead();
    lock.unlock();
    if (writes) write();
    if (closes) close();
    if (reads) read();
  }
  void end() {
    if (std::exchange(is_over_, true)) return;
    socket_.end();
    std::erase(door_.wires, shared_from_this());
    const std::lock_guard<std::mutex> lock(line_->mutex);
    line_->is_gone = true;
    door_.came();
  }

  bool isKnown() const {
    const std::lock_guard<std::mutex> lock(line_->mutex);
    return line_->leave.is_known;
  }

 private:
  /// With the line's mutex. Of who is not known one frame at a time is read; who does not take its answers is not read
  /// either, nor who may not be refused and is too fast.
  bool mayRead() const {
    const Leave& leave = line_->leave;
    if (leave.closes || !leave.may_be_read || is_delayed_ || line_->messages.size() >= kMaxMessages) return false;
    if (!leave.is_known) return line_->frames.empty();
    return line_->frames.size() < 2 * kMaxFrames && line_->frame_bytes < 2 * kMaxFrameBytes;
  }
  bool hasRoom(std::size_t bytes) const {
    const std::lock_guard<std::mutex> lock(line_->mutex);
    return line_->frames.size() < kMaxFrames && line_->frame_bytes + bytes <= kMaxFrameBytes;
  }
  void judge(bool is_read) {
    if (!is_read || is_over_) return end();
    const web_socket::Request request = socket_.request();
    const int port = door_.listener.port();
    if (!isHere(request.host, port))
      return respond(kMisdirected, "", "This service is asked as 127.0.0.1 or localhost alone.\n");
    if (!mayAsk(request.origin, door_.origins, port))
      return respond(kForbidden, "", "Pages of this origin may not connect. See --allow-origin.\n");
    if (!request.is_upgrade)
      return socket_.readBody([self = shared_from_this()](bool is_whole) { self->ask(is_whole); });
    socket_.accept([self = shared_from_this()](bool is_accepted) {
      if (!is_accepted || self->is_over_) return self->end();
      self->is_open_ = true;
      self->door_.tell(self->line_);
      self->pump();
    });
  }
  void ask(bool is_whole) {
    if (!is_whole || is_over_) return end();
    const web_socket::Request request = socket_.request();
    line_->question = {request.method, request.target, request.body};
    door_.tell(line_);
  }
  void respond(int status, const std::string& type, const std::string& body) {
    socket_.respond(status, type, body, [self = shared_from_this()](bool) { self->end(); });
  }
  void read() {
    is_reading_ = true;
    socket_.read([self = shared_from_this()](bool is_read, std::string_view text, bool is_text) {
      self->is_reading_ = false;
      if (!is_read || self->is_over_) return self->end();
      self->receive(text, is_text);
      self->pump();
    });
  }
  void receive(std::string_view text, bool is_text) {
    Frame frame{std::string(text), is_text};
    door_.endpoint->heed(frame, isKnown());
    const double now_s = socketNow_s(), bytes = static_cast<double>(text.size());
    const bool has_requests = requests_.has(1.0, now_s), has_bytes = bytes_.has(bytes, now_s);
    if (!frame.has_stopped && !(has_requests && has_bytes && hasRoom(text.size()))) {
      if (std::optional<std::string> answer = door_.endpoint->tooSoon(text)) {
        const std::lock_guard<std::mutex> lock(line_->mutex);
        line_->message_bytes += answer->size();
        line_->messages.push_back({std::move(*answer), false});
        return;
      }
    }
    requests_.take(1.0);
    bytes_.take(bytes);
    {
      const std::lock_guard<std::mutex> lock(line_->mutex);
      line_->frame_bytes += text.size();
      line_->frames.push_back(std::move(frame));
    }
    door_.came();
    const double wait_s = std::max(requests_.wait_s(), bytes_.wait_s());
    if (wait_s <= 0.0) return;
    is_delayed_ = true;
    delay_.start(Milliseconds(1 + static_cast<int>(1e3 * wait_s)), [weak = weak_from_this()] {
      const auto self = weak.lock();
      if (!self) return;
      self->is_delayed_ = false;
      self->pump();
    });
  }
  void write() {
    is_writing_ = true;
    socket_.write(message_.bytes, message_.is_binary, [self = shared_from_this()](bool is_written) {
      self->is_writing_ = false;
      if (!is_written || self->is_over_) return self->end();
      self->door_.came();  // there is room for more
      self->pump();
    });
  }
  void close() {
    is_writing_ = true;  // nothing more is written
    socket_.close(web_socket::kPolicyError, [self = shared_from_this()](bool) { self->end(); });
  }

  web_socket::Connection socket_;
  Door& door_;
  std::shared_ptr<Line> line_ = std::make_shared<Line>();
  web_socket::Timer deadline_, delay_;
  Bucket requests_{kMaxRequestsPerSecond, kMaxRequestsPerSecond}, bytes_{kMaxBytesPerSecond, kMaxBytesAtOnce};
  Message message_;
  bool is_open_ = false, is_reading_ = false, is_writing_ = false, is_delayed_ = false, is_over_ = false;
};

void Door::accept() {
  listener.accept([this](std::optional<web_socket::Connection> connection) {
    if (connection) {
      take(std::move(*connection));
      return accept();
    }
    pause.start(kNoDescriptors, [this] { accept(); });  // else it would fail again at once, and again
  });
}

void Door::take(web_socket::Connection connection) {
  const auto unknown = std::count_if(wires.begin(), wires.end(), [](const auto& one) { return !one->isKnown(); });
  if (static_cast<std::size_t>(unknown) >= kMaxUnknown) return;  // the socket closes
  wires.push_back(std::make_shared<Wire>(std::move(connection), *this));
  wires.back()->begin();
}

}  // namespace

struct Sockets::Impl {
  std::function<void()> came;
  web_socket::EventLoop loop;
  std::vector<std::unique_ptr<Door>> doors;
  std::atomic<bool> looks = false;  // a call of look() is on its way
  std::thread thread;
};

Sockets::Sockets(std::function<void()> came) : impl_(std::make_unique<Impl>()) {
  impl_->came = std::move(came);
}

Sockets::~Sockets() {
  stop();
}

std::string Sockets::listen(int port, std::vector<std::string> origins) {
  auto door = std::make_unique<Door>(impl_->loop, std::move(origins));
  door->came = impl_->came;
  if (std::string why = door->listener.open(port); !why.empty()) return why;
  impl_->doors.push_back(std::move(door));
  return {};
}

int Sockets::port(std::size_t door) const {
  return impl_->doors.at(door)->listener.port();
}

void Sockets::start(const std::vector<Endpoint*>& endpoints) {
  for (std::size_t index = 0; index < endpoints.size(); ++index) {
    impl_->doors.at(index)->endpoint = endpoints[index];
    impl_->doors[index]->accept();
  }
  impl_->thread = std::thread([impl = impl_.get()] { impl->loop.run(); });
}

std::vector<std::shared_ptr<Line>> Sockets::takeNew(std::size_t door) {
  const std::lock_guard<std::mutex> lock(impl_->doors.at(door)->mutex);
  return std::exchange(impl_->doors[door]->fresh, {});
}

void Sockets::look() {
  if (impl_->looks.exchange(true)) return;
  impl_->loop.post([impl = impl_.get()] {
    impl->looks = false;
    for (const auto& door : impl->doors) {
      const std::vector<std::shared_ptr<Wire>> all = door->wires;  // some end
      for (const std::shared_ptr<Wire>& wire : all) wire->pump();
    }
  });
}

void Sockets::stop() {
  if (!impl_->thread.joinable()) return;
  impl_->loop.post([impl = impl_.get()] {
    for (const auto& door : impl->doors) {
      const std::vector<std::shared_ptr<Wire>> all = door->wires;
      for (const std::shared_ptr<Wire>& wire : all) wire->end();
      door->listener.close();
    }
    impl->loop.stop();
  });
  impl_->thread.join();
  impl_->loop.poll();  // what was under way ends
}

}  // namespace underact::serve
