#pragma once
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <string>

namespace underact::test {

/// Someone who listens on a port of this machine that the system chose.
class UdpListener {
 public:
  UdpListener() : fd_(socket(AF_INET, SOCK_DGRAM, 0)) {
    sockaddr_in here{};
    here.sin_family = AF_INET;
    here.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof here;
    EXPECT_EQ(bind(fd_, reinterpret_cast<sockaddr*>(&here), size), 0);
    getsockname(fd_, reinterpret_cast<sockaddr*>(&here), &size);
    port_ = ntohs(here.sin_port);
    const timeval patience{5, 0};
    setsockopt(fd_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  }
  ~UdpListener() { close(fd_); }
  UdpListener(const UdpListener&) = delete;
  UdpListener& operator=(const UdpListener&) = delete;
  int port() const { return port_; }
  /// The next message; empty: none came in 5 s.
  std::string next() const { return receive(0); }
  /// The next message that is there already; empty: none is.
  std::string nextNow() const { return receive(MSG_DONTWAIT); }

 private:
  std::string receive(int flags) const {
    std::string text(4096, '\0');
    const ssize_t size = recv(fd_, text.data(), text.size(), flags);
    text.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
    return text;
  }

  int fd_;
  int port_ = 0;
};

}  // namespace underact::test
