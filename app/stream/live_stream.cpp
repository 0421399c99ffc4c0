#include "app/stream/live_stream.h"

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>
#include <charconv>
#include <chrono>
#include <cmath>
#include <concepts>
#include <thread>
#include <utility>

#include "core/json/json.h"
#include "core/record/columns.h"
#include "core/record/provenance.h"

namespace underact::stream {
namespace {

using boost::asio::ip::udp;

constexpr std::int64_t kBurst = 20;
constexpr std::chrono::milliseconds kBetweenBursts{2};

/// A tick as one JSON object, without what is no number.
class Message {
 public:
  Message(const servo::TickRecord& record, const std::string& session_id)
      : fields_(record::csvFields(record.joints > 6)) {
    text_ = "{\"timestamp\":" + json::numberText(kSecondPerNanosecond * static_cast<double>(record.time_ns));
    record::fillRow(record, *this, record.joints > 6);
    text_ += ",\"underact_live\":" + std::to_string(kLiveVersion);
    if (!session_id.empty()) text_ += ",\"session\":\"" + session_id + "\"";
    text_ += ",\"clock\":\"arm\",\"unix_s\":";  // of timestamp; and the system's clock, now
    text_ += json::numberText(kSecondPerNanosecond * static_cast<double>(record::unixNow_ns())) + "}";
  }
  const std::string& text() const { return text_; }

  // What fillRow() calls, column by column.
  void integer(std::integral auto value) { add(std::to_string(value)); }
  void number(double value) { std::isfinite(value) ? add(json::numberText(value)) : void(++column_); }
  void word(FaultKind fault) { add(json::quotedText(name(fault))); }

 private:
  void add(const std::string& value) {
    text_.append(",\"").append(fields_[column_++].name).append("\":").append(value);
  }

  std::span<const record::CsvField> fields_;
  std::string text_;
  std::size_t column_ = 0;
};

}  // namespace

bool Address::isThisMachine() const {
  boost::system::error_code error;
  return boost::asio::ip::make_address(host, error).is_loopback() && !error;
}

Result<Address> readAddress(const std::string& text) {
  const auto wrong = [&] {
    return Problems{{"\"" + text +
                     "\" is not an address. Give a port (9870), a host by its number (192.168.1.20), or both "
                     "(192.168.1.20:9870, [::1]:9870)."}};
  };
  Address address;
  std::string port;
  const std::size_t bracket = text.rfind(']');
  const std::size_t colon = text.rfind(':');
  if (!text.empty() && std::all_of(text.begin(), text.end(), [](char one) { return one >= '0' && one <= '9'; })) {
    port = text;
  } else if (text.starts_with('[') && bracket != std::string::npos) {
    address.host = text.substr(1, bracket - 1);
    if (colon > bracket && colon != std::string::npos) port = text.substr(colon + 1);
  } else if (colon != std::string::npos && text.find(':') == colon) {
    address.host = text.substr(0, colon);
    port = text.substr(colon + 1);
    if (port.empty()) return wrong();
  } else {
    address.host = text;
  }
  const char* const end = port.data() + port.size();
  if (!port.empty() && std::from_chars(port.data(), end, address.port).ptr != end) return wrong();
  boost::system::error_code error;
  boost::asio::ip::make_address(address.host, error);
  if (error || address.port < 1 || address.port > 65535) return wrong();
  return address;
}

struct LiveStream::Impl {
  boost::asio::io_context context;
  udp::socket socket{context};
  udp::endpoint target;
  std::int64_t every = 1, sent = 0, lost = 0;
  std::string session_id;
  bool paced = false;
  /// A receiver on a system with the usual buffer has room for some 90 messages of this size.
  void waitForReceiver() const {
    if (paced && sent % kBurst == 0) std::this_thread::sleep_for(kBetweenBursts);
  }
};

LiveStream::LiveStream(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
LiveStream::~LiveStream() = default;
LiveStream::LiveStream(LiveStream&&) noexcept = default;
LiveStream& LiveStream::operator=(LiveStream&&) noexcept = default;

Result<LiveStream> LiveStream::open(const Address& address, int rate_hz) {
  auto impl = std::make_unique<Impl>();
  boost::system::error_code error;
  const boost::asio::ip::address host = boost::asio::ip::make_address(address.host, error);
  impl->target = udp::endpoint(host, static_cast<std::uint16_t>(address.port));
  if (!error) impl->socket.open(impl->target.protocol(), error);
  if (!error) impl->socket.non_blocking(true, error);
  if (error) return Problems{{"Live data cannot be sent to " + address.host + ": " + error.message() + "."}};
  LiveStream stream(std::move(impl));
  stream.setRate(rate_hz);
  return stream;
}

void LiveStream::setRate(int rate_hz) {
  impl_->every = std::max(1, (rate_hz + kMaxMessages_hz - 1) / kMaxMessages_hz);
}

void LiveStream::send(const servo::TickRecord& record) {
  if (record.tick % impl_->every != 0) return;
  const Message message(record, impl_->session_id);
  boost::system::error_code error;
  impl_->socket.send_to(boost::asio::buffer(message.text()), impl_->target, 0, error);
  // Nobody listening yet is no loss of ours: the system tells it with the message after.
  ++(error && error != boost::asio::error::connection_refused ? impl_->lost : impl_->sent);
  impl_->waitForReceiver();
}

void LiveStream::setSession(const std::string& session_id) {
  impl_->session_id = session_id;
}

void LiveStream::pace() {
  impl_->paced = true;
}

std::int64_t LiveStream::sent() const {
  return impl_->sent;
}

std::int64_t LiveStream::lost() const {
  return impl_->lost;
}

}  // namespace underact::stream
