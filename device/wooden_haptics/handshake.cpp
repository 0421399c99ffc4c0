#include "device/wooden_haptics/handshake.h"

#include <array>
#include <utility>

#include "core/base/translate.h"

namespace underact::device {
namespace {

constexpr int kAsks = 30, kAsk_ms = 30;

Problems problem(Sentence sentence) {
  return {{std::move(sentence), {}}};
}

Result<HidNode> find(const std::vector<HidNode>& nodes, const std::string& which) {
  std::string others;
  for (const HidNode& node : nodes) {
    if (which.empty() ? !findWoodenId(node.vendor, node.product)->is_shared
                      : which == node.serial || which == node.path)
      return node;
    others += (others.empty() ? "" : ", ") + (node.serial.empty() ? node.path : node.serial);
  }
  const Sentence none =
      which.empty()
          ? phrase(TRANSLATE_NOOP("problem", "No WoodenHaptics arm is plugged in."))
          : phrase(
                TRANSLATE_NOOP("problem", "No WoodenHaptics arm with the serial number or path \"%1\" is plugged in."),
                {which});
  if (others.empty()) return problem(none);
  return problem(oneAfterAnother(
      {none, phrase(TRANSLATE_NOOP("problem", "Devices that may be one, and can be chosen by name: %1."), {others})}));
}

/// The first report that arrives, and the format that its length implies. Zero is sent in the shortest form first: too
/// short for the others to obey, but enough to make them report.
Result<WoodenLine> listen(HidNode node, std::unique_ptr<HidPipe> pipe) {
  std::array<std::uint8_t, 2 * kLongestWoodenReport> bytes{};
  int last_size = 0;
  for (int ask = 0; ask < kAsks; ++ask) {
    const int size = pipe->read(bytes, kAsk_ms);
    if (size < 0)
      return problem(phrase(TRANSLATE_NOOP(
          "problem", "The WoodenHaptics arm was unplugged while it was being opened. Plug it in again.")));
    const auto format = formatOf(static_cast<std::size_t>(size));
    if (format) {
      const auto first = readWoodenReport(*format, std::span(bytes).first(static_cast<std::size_t>(size)));
      return WoodenLine{std::move(node), std::move(pipe), *format, nullptr, *first};
    }
    if (size > 0) last_size = size;
    constexpr std::array kTried{kWoodenV1, kWoodenV2, kWoodenTeensy};
    pipe->write(currentsMessage(kTried[static_cast<std::size_t>(ask) % kTried.size()], {}).span());
  }
  if (last_size > 0)
    return problem(phrase(
        TRANSLATE_NOOP("problem", "%1 sends reports of %2 bytes; those of a WoodenHaptics arm have 8, 14 or 64."),
        {node.path, std::to_string(last_size)}));
  return problem(phrase(
      TRANSLATE_NOOP(
          "problem",
          "The WoodenHaptics arm at %1 sends nothing. Press the reset button on its board, or plug it in again."),
      {node.path}));
}

}  // namespace

WoodenChoice readWoodenAddress(const std::string& address) {
  const std::size_t slash = address.find('/');
  const WoodenModel* const model = findWoodenModel(address.substr(0, slash));
  if (model == nullptr) return {nullptr, address};
  return {model, slash == std::string::npos ? std::string() : address.substr(slash + 1)};
}

std::vector<HidNode> woodenNodes(HidBus& bus) {
  std::vector<HidNode> found;
  for (HidNode& node : bus.nodes()) {
    if (findWoodenId(node.vendor, node.product) == nullptr) continue;
    const bool is_told = node.usage_page != 0 || node.usage != 0;
    if (is_told && (node.usage_page != kWoodenUsagePage || node.usage != kWoodenUsage)) continue;
    found.push_back(std::move(node));
  }
  return found;
}

Result<WoodenLine> shakeHands(HidBus& bus, const WoodenChoice& choice) {
  if (choice.model != nullptr && !choice.model->is_open)
    return problem(
        phrase(TRANSLATE_NOOP(
                   "problem",
                   "The kinematics of the arm \"%1\" are not published, so it cannot be used. WoodenHaptics arms can."),
               {choice.model->title}));
  const Result<HidNode> node = find(woodenNodes(bus), choice.which);
  if (!node) return node.problems();
  Result<std::unique_ptr<HidPipe>> pipe = bus.open(node.value());
  if (!pipe) return pipe.problems();
  Result<WoodenLine> line = listen(node.value(), std::move(pipe).value());
  if (line)
    line.value().model = choice.model != nullptr ? choice.model : &defaultWoodenModel(line.value().format.protocol);
  return line;
}

}  // namespace underact::device
