#include "core/web_socket/loop.h"

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <utility>

#include "core/web_socket/loop_impl.h"

namespace underact::web_socket {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

EventLoop::EventLoop() : impl_(std::make_unique<Impl>()) {}
EventLoop::~EventLoop() = default;

void EventLoop::run() {
  const auto stays = asio::make_work_guard(impl_->context);
  impl_->context.run();
}

void EventLoop::stop() {
  impl_->context.stop();
}

bool EventLoop::runOneUntil(std::chrono::steady_clock::time_point end) {
  impl_->context.restart();  // where all was done the last time, it has stopped
  return impl_->context.run_one_until(end) > 0;
}

void EventLoop::poll() {
  impl_->context.restart();
  impl_->context.poll();
}

void EventLoop::post(std::function<void()> what) {
  asio::post(impl_->context, std::move(what));
}

struct Timer::Impl {
  asio::steady_timer timer;
};

Timer::Timer(EventLoop& loop) : impl_(new Impl{asio::steady_timer(loop.impl().context)}) {}
Timer::~Timer() = default;

void Timer::start(Milliseconds time, std::function<void()> then) {
  impl_->timer.expires_after(time);
  impl_->timer.async_wait([then = std::move(then)](error_code error) {
    if (!error) then();
  });
}

std::chrono::steady_clock::time_point Timer::end() const {
  return impl_->timer.expiry();
}

struct Bell::Impl {
#ifdef BOOST_ASIO_HAS_POSIX_STREAM_DESCRIPTOR
  explicit Impl(asio::io_context& context) : descriptor(context) {}
  asio::posix::stream_descriptor descriptor;
  std::shared_ptr<bool> is_watched = std::make_shared<bool>(false);
#else
  explicit Impl(asio::io_context&) {}
#endif
};

Bell::Bell(EventLoop& loop) : impl_(std::make_unique<Impl>(loop.impl().context)) {}

Bell::~Bell() {
  forget();
}

#ifdef BOOST_ASIO_HAS_POSIX_STREAM_DESCRIPTOR
bool Bell::watch(int descriptor) {
  if (!impl_->descriptor.is_open()) {
    error_code ignored;
    impl_->descriptor.assign(descriptor, ignored);
  }
  if (!std::exchange(*impl_->is_watched, true))
    impl_->descriptor.async_wait(asio::posix::stream_descriptor::wait_read,
                                 [watched = impl_->is_watched](error_code) { *watched = false; });
  return true;
}

void Bell::forget() {
  if (impl_->descriptor.is_open()) impl_->descriptor.release();
}
#else
bool Bell::watch(int) {
  return false;
}

void Bell::forget() {}
#endif

struct Listener::Impl {
  tcp::acceptor acceptor;
};

Listener::Listener(EventLoop& loop) : impl_(new Impl{tcp::acceptor(loop.impl().context)}) {}
Listener::~Listener() = default;
Listener::Listener(Listener&&) noexcept = default;

std::string Listener::open(int port) {
  tcp::acceptor& acceptor = impl_->acceptor;
  const tcp::endpoint here(asio::ip::address_v4::loopback(), static_cast<std::uint16_t>(port));
  error_code error;
  acceptor.open(here.protocol(), error);
  if (!error) acceptor.set_option(tcp::acceptor::reuse_address(true), error);
  if (!error) acceptor.bind(here, error);
  if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
  return error ? error.message() : "";
}

int Listener::port() const {
  error_code ignored;
  return impl_->acceptor.local_endpoint(ignored).port();
}

void Listener::accept(std::function<void(std::optional<Connection>)> then) {
  impl_->acceptor.async_accept([then = std::move(then)](error_code error, tcp::socket socket) {
    if (error == asio::error::operation_aborted) return;
    then(error ? std::nullopt : std::optional(connectionOf(std::move(socket))));
  });
}

void Listener::close() {
  error_code ignored;
  impl_->acceptor.close(ignored);
}

}  // namespace underact::web_socket
