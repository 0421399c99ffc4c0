#include "device/remote/wire.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <thread>
#include <zmq.hpp>

#include "core/base/translate.h"
#include "core/system/thread_priority.h"
#include "device/remote/message.h"

namespace underact::device::remote {
namespace {

constexpr const char* kEvents = "inproc://line";
// What waits on a slow connection is out of date: little of it is kept, here and in the system.
constexpr int kMaxWaiting = 5, kSystemBytes = 16384;
constexpr int kHandshake_ms = 2000, kHeartbeat_ms = 1000, kSilence_ms = 3000;

/// ZeroMQ handles messages in threads of its own: on a busy computer they need the priority of the threads that wait
/// for them. Requested only if it is granted: otherwise the library ends the program.
void setUrgent(zmq::context_t& context) {
  const std::optional<system::ThreadPriority> granted = system::grantedPriority();
  if (!granted) return;
  zmq_ctx_set(context.handle(), ZMQ_THREAD_SCHED_POLICY, granted->policy);
  zmq_ctx_set(context.handle(), ZMQ_THREAD_PRIORITY, granted->priority);
}

zmq::context_t hurried() {
  zmq::context_t context;
  setUrgent(context);
  return context;
}

/// A context whose threads can be told from all others of this program, by the number at the start of their names.
zmq::context_t numbered(int number) {
  zmq::context_t context;
  zmq_ctx_set(context.handle(), ZMQ_THREAD_NAME_PREFIX, number);
  return context;
}

int nextNumber() {
  static std::atomic<int> made{0};
  return ++made % 1000;  // a name has 15 characters
}

/// Takes all pending events of a connection; returns how many.
int countEvents(zmq::socket_t& events) {
  int count = 0;
  for (zmq::message_t message; events.recv(message, zmq::recv_flags::dontwait); ++count) {
    if (message.more() && !events.recv(message, zmq::recv_flags::dontwait)) break;  // whose it is
  }
  return count;
}

LineState after(LineState state, const zmq_event_t& event) {
  const bool was_connected = state == LineState::Connected;
  switch (event.event) {
    case ZMQ_EVENT_HANDSHAKE_SUCCEEDED:
      return LineState::Connected;
    case ZMQ_EVENT_HANDSHAKE_FAILED_AUTH:
      return LineState::NotAllowed;
    case ZMQ_EVENT_HANDSHAKE_FAILED_NO_DETAIL:
    case ZMQ_EVENT_HANDSHAKE_FAILED_PROTOCOL:
      return state == LineState::NotAllowed ? state : LineState::NotTheOne;
    case ZMQ_EVENT_DISCONNECTED:
      if (state == LineState::NotAllowed) return state;
      return was_connected ? LineState::Gone : LineState::NotTheOne;
    case ZMQ_EVENT_CLOSED:  // before it was ever connected
    case ZMQ_EVENT_CONNECT_RETRIED:
      return state == LineState::Connecting ? LineState::NotReachable : state;
    default:
      return state;
  }
}

}  // namespace

struct Wire::Impl {
  zmq::context_t context = hurried();
  zmq::socket_t socket{context, zmq::socket_type::dealer};
  zmq::socket_t events{context, zmq::socket_type::pair};
  LineState state = LineState::Connecting;
};

Wire::Wire(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Wire::~Wire() = default;

Result<std::unique_ptr<Wire>> Wire::open(const Address& address, const std::string& server_key, const KeyPair& own) {
  try {
    auto impl = std::make_unique<Impl>();
    zmq::socket_t& socket = impl->socket;
    socket.set(zmq::sockopt::curve_serverkey, server_key);
    socket.set(zmq::sockopt::curve_publickey, own.public_key);
    socket.set(zmq::sockopt::curve_secretkey, own.secret_key);
    socket.set(zmq::sockopt::sndhwm, kMaxWaiting);
    socket.set(zmq::sockopt::sndbuf, kSystemBytes);
    socket.set(zmq::sockopt::rcvbuf, kSystemBytes);
    socket.set(zmq::sockopt::maxmsgsize, std::int64_t{kLongestMessage});
    socket.set(zmq::sockopt::handshake_ivl, kHandshake_ms);
    socket.set(zmq::sockopt::reconnect_ivl, -1);
    socket.set(zmq::sockopt::linger, 50);  // the last message
    socket.set(zmq::sockopt::ipv6, address.isIpv6());
    if (zmq_socket_monitor(socket.handle(), kEvents, ZMQ_EVENT_ALL) != 0) throw zmq::error_t();
    impl->events.set(zmq::sockopt::linger, 0);
    impl->events.connect(kEvents);
    socket.connect("tcp://" + address.text());
    return std::unique_ptr<Wire>(new Wire(std::move(impl)));
  } catch (const zmq::error_t& error) {
    return Problems{
        {phrase(TRANSLATE_NOOP("problem", "No connection to %1: %2."), {address.text(), error.what()}), {}}};
  }
}

void Wire::wait(int bell, int time_ms) {
  std::array items{zmq::pollitem_t{impl_->socket.handle(), 0, ZMQ_POLLIN, 0},
                   zmq::pollitem_t{impl_->events.handle(), 0, ZMQ_POLLIN, 0},
                   zmq::pollitem_t{nullptr, bell, ZMQ_POLLIN, 0}};
  zmq_poll(items.data(), bell < 0 ? 2 : 3, bell < 0 ? std::min(time_ms, 1) : time_ms);  // interrupted: looked too early
}

bool Wire::receive(Bytes& bytes) {
  try {
    zmq::message_t message;
    if (!impl_->socket.recv(message, zmq::recv_flags::dontwait)) return false;
    bytes.assign(message.data<std::uint8_t>(), message.data<std::uint8_t>() + message.size());
    return true;
  } catch (const zmq::error_t&) {
    return false;
  }
}

bool Wire::send(std::span<const std::uint8_t> bytes) {
  try {
    return impl_->socket.send(zmq::buffer(bytes.data(), bytes.size()), zmq::send_flags::dontwait).has_value();
  } catch (const zmq::error_t&) {
    return false;
  }
}

LineState Wire::state() {
  try {
    for (zmq::message_t message; impl_->events.recv(message, zmq::recv_flags::dontwait);) {
      zmq_event_t event{};
      if (message.size() >= 6) {  // libzmq's: uint16 and int32, packed
        std::copy_n(message.data<char>(), 2, reinterpret_cast<char*>(&event.event));
        impl_->state = after(impl_->state, event);
      }
      if (message.more() && !impl_->events.recv(message, zmq::recv_flags::dontwait)) break;  // whose it is
    }
  } catch (const zmq::error_t&) {
    impl_->state = LineState::Gone;
  }
  return impl_->state;
}

struct Hub::Impl {
  const int prefix = nextNumber();
  zmq::context_t context = numbered(prefix);
  zmq::socket_t keeper{context, zmq::socket_type::rep};  // who is admitted
  zmq::socket_t socket{context, zmq::socket_type::router};
  zmq::socket_t events{context, zmq::socket_type::pair};
  std::vector<std::string> allowed;
  int turned_away = 0;

  void admit();
  void answer();
};

Hub::Hub(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Hub::~Hub() = default;

Result<std::unique_ptr<Hub>> Hub::open(const Address& address, const KeyPair& own, std::vector<std::string> allowed) {
  try {
    auto impl = std::make_unique<Impl>();
    impl->allowed = std::move(allowed);
    impl->keeper.set(zmq::sockopt::linger, 0);
    impl->keeper.bind("inproc://zeromq.zap.01");  // ZeroMQ RFC 27
    zmq::socket_t& socket = impl->socket;
    socket.set(zmq::sockopt::zap_domain, "underact");
    socket.set(zmq::sockopt::curve_server, true);
    socket.set(zmq::sockopt::curve_secretkey, own.secret_key);
    socket.set(zmq::sockopt::sndhwm, kMaxWaiting);
    socket.set(zmq::sockopt::sndbuf, kSystemBytes);
    socket.set(zmq::sockopt::rcvbuf, kSystemBytes);
    socket.set(zmq::sockopt::maxmsgsize, std::int64_t{kLongestMessage});
    socket.set(zmq::sockopt::handshake_ivl, kHandshake_ms);
    socket.set(zmq::sockopt::heartbeat_ivl, kHeartbeat_ms);
    socket.set(zmq::sockopt::heartbeat_timeout, kSilence_ms);
    socket.set(zmq::sockopt::linger, 100);
    socket.set(zmq::sockopt::ipv6, address.isIpv6());
    if (zmq_socket_monitor(socket.handle(), kEvents, ZMQ_EVENT_ACCEPTED | ZMQ_EVENT_ACCEPT_FAILED) != 0)
      throw zmq::error_t();
    impl->events.set(zmq::sockopt::linger, 0);
    impl->events.set(zmq::sockopt::rcvhwm, 0);  // otherwise the I/O threads would wait for the thread that counts
    impl->events.connect(kEvents);
    socket.bind("tcp://" +
                (address.port == 0 ? address.text().substr(0, address.text().size() - 1) + "*" : address.text()));
    return std::unique_ptr<Hub>(new Hub(std::move(impl)));
  } catch (const zmq::error_t& error) {
    return Problems{{phrase(TRANSLATE_NOOP("problem",
                                           "Connections cannot be accepted at %1: %2. Is an arm already shared there? "
                                           "Choose another port with --listen HOST:PORT."),
                            {address.text(), error.what()}),
                     {}}};
  }
}

Address Hub::address() const {
  constexpr std::string_view kBefore = "tcp://";
  Result<Address> address =
      readAddress(std::string_view(impl_->socket.get(zmq::sockopt::last_endpoint)).substr(kBefore.size()));
  return address ? address.value() : Address{};
}

/// ZAP: seven parts, the last of which is the client's key.
void Hub::Impl::answer() {
  std::vector<std::string> parts;
  for (zmq::message_t part; keeper.recv(part, zmq::recv_flags::dontwait);) {
    parts.push_back(part.to_string());
    if (!part.more()) break;
  }
  if (parts.empty()) return;
  std::array<char, 41> key{};
  const bool has_key =
      parts.size() == 7 && parts[5] == "CURVE" && parts[6].size() == 32 &&
      zmq_z85_encode(key.data(), reinterpret_cast<const std::uint8_t*>(parts[6].data()), 32) != nullptr;
  const bool is_known = has_key && std::find(allowed.begin(), allowed.end(), key.data()) != allowed.end();
  if (!is_known) ++turned_away;
  const std::string number = parts.size() > 1 ? parts[1] : "";
  const std::array<std::string, 6> reply{
      "1.0", number, is_known ? "200" : "400", is_known ? "OK" : "This key is not known here", "", ""};
  for (std::size_t part = 0; part < reply.size(); ++part)
    keeper.send(zmq::buffer(reply[part]), part + 1 < reply.size() ? zmq::send_flags::sndmore : zmq::send_flags::none);
}

void Hub::Impl::admit() {
  try {
    zmq::pollitem_t item{keeper.handle(), 0, ZMQ_POLLIN, 0};
    while (zmq_poll(&item, 1, 0) > 0) answer();
  } catch (const zmq::error_t&) {  // nobody is admitted then
  }
}

void Hub::wait(int bell, int time_ms) {
  std::array items{zmq::pollitem_t{impl_->socket.handle(), 0, ZMQ_POLLIN, 0},
                   zmq::pollitem_t{impl_->keeper.handle(), 0, ZMQ_POLLIN, 0},
                   zmq::pollitem_t{nullptr, bell, ZMQ_POLLIN, 0}};
  zmq_poll(items.data(), bell < 0 ? 2 : 3, bell < 0 ? std::min(time_ms, 1) : time_ms);
  if ((items[1].revents & ZMQ_POLLIN) != 0) impl_->admit();
}

bool Hub::receive(std::string& from, Bytes& bytes) {
  try {
    zmq::message_t part;
    if (!impl_->socket.recv(part, zmq::recv_flags::dontwait)) return false;
    from = part.to_string();
    bytes.clear();
    while (part.more() && impl_->socket.recv(part, zmq::recv_flags::dontwait)) {
      if (bytes.size() <= kLongestMessage)
        bytes.insert(bytes.end(), part.data<std::uint8_t>(), part.data<std::uint8_t>() + part.size());
    }
    return true;
  } catch (const zmq::error_t&) {
    return false;
  }
}

bool Hub::send(const std::string& to, std::span<const std::uint8_t> bytes) {
  try {
    if (!impl_->socket.send(zmq::buffer(to), zmq::send_flags::dontwait | zmq::send_flags::sndmore)) return false;
    return impl_->socket.send(zmq::buffer(bytes.data(), bytes.size()), zmq::send_flags::dontwait).has_value();
  } catch (const zmq::error_t&) {
    return false;
  }
}

int Hub::rejected() {
  return std::exchange(impl_->turned_away, 0);
}

int Hub::connections() {
  try {
    return countEvents(impl_->events);
  } catch (const zmq::error_t&) {
    return 0;
  }
}

void Hub::setUrgent(bool on) {
  system::setThreadPriority(std::to_string(impl_->prefix) + "/ZMQbg/IO/0", on);
}

}  // namespace underact::device::remote
