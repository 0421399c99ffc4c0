#include "device/remote/message.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace underact::device::remote {
namespace {

static_assert(std::numeric_limits<double>::is_iec559);

constexpr std::size_t kJoints = 6;  // of every device
constexpr std::array<std::uint8_t, 4> kMark{'U', 'A', 'R', 'M'};
enum Kind : std::uint8_t { kSample = 1, kForce, kHello, kWelcome, kWords, kBye };
enum Flag : std::uint32_t {
  kHasSample = 1,
  kPushes = 1,
  kOnlyLooks = 1,
  kAllowsForce = 1,
  kIsPassive = 2,
  kUntested = 4
};
constexpr std::uint8_t kLastAbout = static_cast<std::uint8_t>(About::Ended);

class Writer {
 public:
  explicit Writer(Kind kind) {
    bytes.assign(kMark.begin(), kMark.end());
    put(static_cast<std::uint16_t>(kVersion));
    put(static_cast<std::uint8_t>(kind));
    put(std::uint8_t{0});
  }
  template <class Unsigned>
  void put(Unsigned value) {
    for (std::size_t byte = 0; byte < sizeof value; ++byte)
      bytes.push_back(static_cast<std::uint8_t>(static_cast<std::uint64_t>(value) >> (8 * byte)));
  }
  void putNumber(double value) { put(std::bit_cast<std::uint64_t>(value)); }
  void putVector(const Vec3& v) {
    for (int axis = 0; axis < 3; ++axis) putNumber(v[axis]);
  }
  void updateText(const std::string& text) {
    const std::size_t size = std::min(text.size(), kLongestText);
    put(static_cast<std::uint16_t>(size));
    for (std::size_t at = 0; at < size; ++at) {
      const auto byte = static_cast<std::uint8_t>(text[at]);
      bytes.push_back(byte < 0x20 || byte == 0x7F ? std::uint8_t{' '} : byte);
    }
  }
  void putArm(const Kinematics& arm) {
    putNumber(arm.geometry.upper_m);
    putNumber(arm.geometry.fore_m);
    putVector(arm.geometry.p_WB);
    updateText(arm.preset);
  }
  std::vector<std::uint8_t> bytes;
};

/// Reads one field after another; after an error it stays invalid.
class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : left_(bytes) {}
  bool isDone() const { return is_ok_ && left_.empty(); }
  template <class Unsigned>
  Unsigned take() {
    if (left_.size() < sizeof(Unsigned)) return fail(Unsigned{0});
    std::uint64_t value = 0;
    for (std::size_t byte = 0; byte < sizeof(Unsigned); ++byte)
      value |= static_cast<std::uint64_t>(left_[byte]) << (8 * byte);
    left_ = left_.subspan(sizeof(Unsigned));
    return static_cast<Unsigned>(value);
  }
  double takeNumber() {
    const double value = std::bit_cast<double>(take<std::uint64_t>());
    return std::isfinite(value) ? value : fail(0.0);
  }
  Vec3 takeVector() {
    Vec3 v;
    for (int axis = 0; axis < 3; ++axis) v[axis] = takeNumber();
    return v;
  }
  std::string takeText() {
    const std::size_t size = take<std::uint16_t>();
    if (size > kLongestText || size > left_.size()) return fail(std::string());
    std::string text(left_.begin(), left_.begin() + static_cast<std::ptrdiff_t>(size));
    left_ = left_.subspan(size);
    const auto isControl = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; };
    return std::any_of(text.begin(), text.end(), isControl) ? fail(std::string()) : text;
  }
  std::uint32_t takeFlags(std::uint32_t known) {
    const auto flags = take<std::uint32_t>();
    return (flags & ~known) == 0 ? flags : fail(0U);
  }
  int takeRate() {
    const auto rate_hz = take<std::uint32_t>();
    return rate_hz > 0 && rate_hz <= 1'000'000 ? static_cast<int>(rate_hz) : fail(0);
  }
  Kinematics takeArm() {
    Kinematics arm;
    arm.geometry.upper_m = takeNumber();
    arm.geometry.fore_m = takeNumber();
    arm.geometry.p_WB = takeVector();
    arm.preset = takeText();
    return arm;
  }

 private:
  template <class T>
  T fail(T nothing) {
    is_ok_ = false;
    return nothing;
  }
  std::span<const std::uint8_t> left_;
  bool is_ok_ = true;
};

std::vector<std::uint8_t> written(const SampleMessage& message) {
  Writer writer(kSample);
  writer.put(message.sequence);
  writer.put(static_cast<std::uint64_t>(message.sample.time_ns));
  for (const double angle_rad : std::span(message.sample.q_rad).first<kJoints>()) writer.putNumber(angle_rad);
  writer.put(message.sample.buttons);
  writer.put(message.sample.epoch);
  writer.put(message.has_sample ? std::uint32_t{kHasSample} : 0U);
  return writer.bytes;
}

std::vector<std::uint8_t> written(const ForceMessage& message) {
  Writer writer(kForce);
  writer.put(message.number);
  writer.put(message.answered);
  writer.putVector(message.f_T_W);
  writer.put(message.pushes ? std::uint32_t{kPushes} : 0U);
  return writer.bytes;
}

std::vector<std::uint8_t> written(const Hello& message) {
  Writer writer(kHello);
  writer.put(message.token);
  writer.put(static_cast<std::uint32_t>(message.rate_hz));
  writer.put(message.only_looks ? std::uint32_t{kOnlyLooks} : 0U);
  writer.putArm(message.arm);
  return writer.bytes;
}

std::vector<std::uint8_t> written(const Welcome& message) {
  Writer writer(kWelcome);
  writer.put(static_cast<std::uint32_t>(message.rate_hz));
  writer.put((message.allows_force ? kAllowsForce : 0U) | (message.is_passive ? kIsPassive : 0U) |
             (message.untested ? kUntested : 0U));
  writer.putNumber(message.max_force_N);
  writer.putNumber(message.frozen_s);
  writer.putArm(message.arm);
  writer.updateText(message.title);
  return writer.bytes;
}

std::vector<std::uint8_t> written(const Words& message) {
  Writer writer(kWords);
  writer.put(static_cast<std::uint8_t>(message.about));
  writer.updateText(message.text);
  return writer.bytes;
}

std::vector<std::uint8_t> written(const Bye& /*message*/) {
  return Writer(kBye).bytes;
}

SampleMessage takeSample(Reader& reader) {
  SampleMessage message;
  message.sequence = reader.take<std::uint64_t>();
  message.sample.time_ns = static_cast<std::int64_t>(reader.take<std::uint64_t>());
  for (double& angle_rad : std::span(message.sample.q_rad).first<kJoints>()) angle_rad = reader.takeNumber();
  message.sample.buttons = reader.take<std::uint32_t>();
  message.sample.epoch = reader.take<std::uint32_t>();
  message.has_sample = reader.takeFlags(kHasSample) != 0;
  return message;
}

ForceMessage takeForce(Reader& reader) {
  ForceMessage message;
  message.number = reader.take<std::uint64_t>();
  message.answered = reader.take<std::uint64_t>();
  message.f_T_W = reader.takeVector();
  message.pushes = reader.takeFlags(kPushes) != 0;
  return message;
}

Hello takeHello(Reader& reader) {
  Hello message;
  message.token = reader.take<std::uint64_t>();
  message.rate_hz = reader.takeRate();
  message.only_looks = reader.takeFlags(kOnlyLooks) != 0;
  message.arm = reader.takeArm();
  return message;
}

Welcome takeWelcome(Reader& reader) {
  Welcome message;
  message.rate_hz = reader.takeRate();
  const std::uint32_t flags = reader.takeFlags(kAllowsForce | kIsPassive | kUntested);
  message.allows_force = (flags & kAllowsForce) != 0;
  message.is_passive = (flags & kIsPassive) != 0;
  message.untested = (flags & kUntested) != 0;
  message.max_force_N = reader.takeNumber();
  message.frozen_s = reader.takeNumber();
  message.arm = reader.takeArm();
  message.title = reader.takeText();
  return message;
}

std::optional<Message> takeWords(Reader& reader) {
  const auto about = reader.take<std::uint8_t>();
  Words message{static_cast<About>(std::min(about, kLastAbout)), reader.takeText()};
  if (about > kLastAbout) return {};
  return message;
}

std::optional<Message> takeKind(std::uint8_t kind, Reader& reader) {
  switch (kind) {
    case kSample:
      return takeSample(reader);
    case kForce:
      return takeForce(reader);
    case kHello:
      return takeHello(reader);
    case kWelcome:
      return takeWelcome(reader);
    case kWords:
      return takeWords(reader);
    case kBye:
      return Bye{};
    default:
      return {};
  }
}

}  // namespace

std::vector<std::uint8_t> bytesOf(const Message& message) {
  return std::visit([](const auto& one) { return written(one); }, message);
}

std::optional<int> versionOf(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kHeaderBytes || !std::equal(kMark.begin(), kMark.end(), bytes.begin())) return {};
  return bytes[4] + 256 * bytes[5];
}

std::optional<Message> readMessage(std::span<const std::uint8_t> bytes) {
  if (bytes.size() > kLongestMessage || versionOf(bytes) != kVersion || bytes[7] != 0) return {};
  Reader reader(bytes.subspan(kHeaderBytes));
  std::optional<Message> message = takeKind(bytes[6], reader);
  if (!message || !reader.isDone()) return {};
  return message;
}

}  // namespace underact::device::remote
