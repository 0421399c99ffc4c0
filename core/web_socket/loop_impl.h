#pragma once
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>

#include "core/web_socket/connection.h"
#include "core/web_socket/loop.h"

namespace underact::web_socket {

/// What the files of this room know of a loop.
struct EventLoop::Impl {
  boost::asio::io_context context{1};
};

/// Of one who has connected.
Connection connectionOf(boost::asio::ip::tcp::socket socket);

}  // namespace underact::web_socket
