#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/serve/endpoint.h"
#include "core/base/result.h"

namespace underact::serve {

inline constexpr int kUsualPort = 7171;

/// The sockets of a service: WebSocket on this computer's own address alone. Any page in a browser could open one, so a
/// connection that names an origin is refused unless it is one of the given ones.
class Server {
 public:
  /// Listens. port: 0: a free one. origins: of the pages that may connect. Problems: the port is in use, or not
  /// permitted.
  static Result<Server> open(int port, std::vector<std::string> origins);
  /// Listens at one more port, where no page may connect. Problems: as open().
  Problems alsoListen(int port);
  ~Server();
  Server(Server&&) noexcept;
  Server& operator=(Server&&) noexcept;
  /// listener: 0: that of open(), 1: the first of alsoListen().
  int port(std::size_t listener = 0) const;
  /// Serves, in this thread, until goes_on(), which is called at least 50 times a second, gives false. Polls the
  /// endpoints in their order. endpoints: one for each port; they outlive the call.
  void run(const std::vector<Endpoint*>& endpoints, const std::function<bool()>& goes_on);

  // For a thread that has a loop of its own.
  /// Takes connections from now on, in step(). endpoints: outlive end().
  void begin(const std::vector<Endpoint*>& endpoints);
  /// Reads and writes what can be without waiting, and polls the endpoints. Between begin() and end().
  void step();
  /// Closes all connections, and listens no more.
  void end();

 private:
  struct Impl;
  explicit Server(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace underact::serve
