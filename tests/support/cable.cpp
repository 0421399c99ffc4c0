#include "tests/support/cable.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <deque>

namespace underact::test {
namespace {

std::int64_t now() {
  return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

sockaddr_in here(int port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  return address;
}

void atOnce(int fd) {
  const int yes = 1;
  setsockopt(fd, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
  fcntl(fd, F_SETFL, fcntl(fd, F_GETFL) | O_NONBLOCK);
}

}  // namespace

/// One direction: what came, and when it is due.
struct Cable::Lane {
  struct Part {
    std::int64_t due_ns;
    std::vector<char> bytes;
  };
  int from = -1, to = -1;
  std::deque<Part> parts;
};

struct Cable::Line {
  Lane out, back;
  ~Line() {
    for (const int fd : {out.from, out.to}) {
      if (fd >= 0) close(fd);
    }
  }
};

Cable::Cable(int to_port) : to_port_(to_port) {
  listen();
  thread_ = std::thread(&Cable::run, this);
}

Cable::~Cable() {
  ends_ = true;
  thread_.join();
  if (listener_ >= 0) close(listener_);
}

void Cable::listen() {
  listener_ = socket(AF_INET, SOCK_STREAM, 0);
  const int yes = 1;
  setsockopt(listener_, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  sockaddr_in address = here(port_);
  socklen_t size = sizeof address;
  EXPECT_EQ(bind(listener_, reinterpret_cast<sockaddr*>(&address), size), 0);
  EXPECT_EQ(::listen(listener_, 8), 0);
  getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
  port_ = ntohs(address.sin_port);
  atOnce(listener_);
}

void Cable::pull() {
  const std::scoped_lock lock(mutex_);
  is_pulled_ = true;
  if (listener_ >= 0) {
    shutdown(listener_, SHUT_RDWR);  // at once, also while somebody waits at it
    close(listener_);
  }
  listener_ = -1;
}

void Cable::cut() {
  const std::scoped_lock lock(mutex_);
  lines_.clear();
}

void Cable::plug() {
  const std::scoped_lock lock(mutex_);
  lines_.clear();
  is_pulled_ = false;
  if (listener_ < 0) listen();
}

void Cable::accept() {
  const int from = listener_ >= 0 ? ::accept(listener_, nullptr, nullptr) : -1;
  if (from < 0) return;
  const int to = socket(AF_INET, SOCK_STREAM, 0);
  const sockaddr_in address = here(to_port_);
  if (connect(to, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    close(from);
    close(to);
    return;
  }
  atOnce(from);
  atOnce(to);
  auto line = std::make_unique<Line>();
  line->out.from = line->back.to = from;
  line->out.to = line->back.from = to;
  lines_.push_back(std::move(line));
}

/// false: an end has closed.
bool Cable::carry(Line& line) {
  const std::int64_t now_ns = now();
  for (Lane* const lane : {&line.out, &line.back}) {
    std::array<char, 4096> bytes{};
    for (ssize_t size = 0; (size = recv(lane->from, bytes.data(), bytes.size(), 0)) != -1;) {
      if (size == 0) return false;
      seed_ = seed_ * 6364136223846793005ULL + 1442695040888963407ULL;
      const double share = static_cast<double>(seed_ >> 40U) / static_cast<double>(1U << 24U);
      std::int64_t due_ns = now_ns + delay_ns_ + static_cast<std::int64_t>(share * static_cast<double>(jitter_ns_));
      if (!lane->parts.empty()) due_ns = std::max(due_ns, lane->parts.back().due_ns);
      lane->parts.push_back({due_ns, {bytes.begin(), bytes.begin() + size}});
    }
    if (errno != EAGAIN && errno != EWOULDBLOCK) return false;
    while (!held_ && !lane->parts.empty() && lane->parts.front().due_ns <= now_ns) {
      std::vector<char>& first = lane->parts.front().bytes;
      const ssize_t sent = send(lane->to, first.data(), first.size(), MSG_NOSIGNAL);
      if (sent < 0) {
        if (errno != EAGAIN && errno != EWOULDBLOCK) return false;
        break;
      }
      first.erase(first.begin(), first.begin() + sent);
      if (first.empty()) lane->parts.pop_front();
    }
  }
  return true;
}

void Cable::run() {
  while (!ends_) {
    std::vector<pollfd> waits;
    bool is_slow = false;
    {
      const std::scoped_lock lock(mutex_);
      if (!is_pulled_) {
        accept();
        std::erase_if(lines_, [this](const std::unique_ptr<Line>& line) { return !carry(*line); });
        if (listener_ >= 0) waits.push_back({listener_, POLLIN, 0});
        for (const std::unique_ptr<Line>& line : lines_) {
          waits.push_back({line->out.from, POLLIN, 0});
          waits.push_back({line->out.to, POLLIN, 0});
          is_slow = is_slow || !line->out.parts.empty() || !line->back.parts.empty();
        }
      }
    }
    poll(waits.data(), waits.size(), is_slow ? 1 : 10);
  }
}

}  // namespace underact::test
