#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/serve/endpoint.h"
#include "core/base/result.h"

namespace underact::serve {

inline constexpr int kDefaultPort = 7171;

/// The sockets of a service: WebSocket on this computer's own address alone, on a thread of their own. Any page in a
/// browser could open one, so a connection that names an origin is refused unless it is one of the given ones or the
/// port's own address, and so is one that asks for another computer. A frame that stops the servo does so while the
/// thread of the endpoints, which calls all of this, is busy.
class Server {
 public:
  /// Listens. port: 0: a free one. origins: of the pages that may connect. Problems: the port is in use, or not
  /// permitted.
  static Result<Server> open(int port, std::vector<std::string> origins);
  /// Listens at one more port. Problems: as open().
  Problems alsoListen(int port, std::vector<std::string> origins);
  ~Server();
  Server(Server&&) noexcept;
  Server& operator=(Server&&) noexcept;
  /// listener: 0: that of open(), 1: the first of alsoListen().
  int port(std::size_t listener = 0) const;
  /// Serves, in this thread, until goes_on(), which is called at least 50 times a second and between requests, gives
  /// false. Polls the endpoints in their order. endpoints: one for each port; they outlive the call.
  void run(const std::vector<Endpoint*>& endpoints, const std::function<bool()>& goes_on);

  // For a thread that has a loop of its own.
  /// Takes connections from now on, in step(). endpoints: outlive end().
  void begin(const std::vector<Endpoint*>& endpoints);
  /// Gives the endpoints what has come, for 5 ms, polls them, and sends what they have. Between begin() and end().
  void step();
  /// Closes all connections, and listens no more.
  void end();

 private:
  struct Impl;
  explicit Server(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace underact::serve
