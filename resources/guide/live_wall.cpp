#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <cmath>
#include <fstream>
#include <iostream>
#include <string>

/// A connection to a running scene.
class Live {
 public:
  Live(unsigned short port, const std::string& token) {
    socket_.next_layer().connect({boost::asio::ip::address_v4::loopback(), port});
    socket_.handshake("127.0.0.1", "/");
    ask(R"("do": "hello", "name": "C++", "token": ")" + token + '"');
  }
  /// Sends a request; its answer. Ticks and events come in between.
  std::string ask(const std::string& keys) {
    socket_.write(boost::asio::buffer("{\"id\": 1, " + keys + "}"));
    for (;;)
      if (std::string message = next(); message.rfind("{\"id\"", 0) == 0) return message;
  }
  std::string next() {
    boost::beast::flat_buffer buffer;
    socket_.read(buffer);
    return boost::beast::buffers_to_string(buffer.data());
  }

 private:
  boost::asio::io_context context_;
  boost::beast::websocket::stream<boost::asio::ip::tcp::socket> socket_{context_};
};

int main(int, char** words) {
  std::string token;
  std::ifstream(words[2]) >> token;
  Live live(static_cast<unsigned short>(std::stoi(words[1])), token);
  live.ask(R"("do": "constraint.add", "constraint": {"name": "floor", "type": "plane",
    "side": "outside", "point_mm": [0, -30, 0], "normal": [0, 1, 0]})");
  live.ask(R"("do": "start")");
  for (int step = 0; step < 100; ++step)
    live.ask(R"("do": "constraint.move", "name": "floor", "over_ms": 10, "values": {"point_mm": [0, )" +
             std::to_string(-30 + 10 * std::sin(0.126 * step)) + ", 0]}");
  std::cout << live.ask(R"("do": "stop")") << '\n';
}
