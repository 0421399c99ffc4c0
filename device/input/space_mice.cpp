#include "device/input/space_mice.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <iterator>
#include <utility>

#include "core/base/translate.h"
#include "core/system/clock.h"
#include "device/input/default_maps.h"

namespace underact::device::input {
namespace {

constexpr int kRead_ms = 10, kIdle_ms = 50;
constexpr int kMaxAtOnce = 64;  // reports: as many as the kernel keeps

DeviceState describeNode(const HidNode& node, const SpaceMouseModel& model) {
  DeviceState seen;
  // Two of one model are distinguished by their serial number, if they have one.
  seen.id = "3d-" + std::string(model.name) + (node.serial.empty() ? "" : "-" + node.serial);
  seen.name = spaceMouseName(model);
  seen.kind = InputKind::SpaceMouse;
  seen.button_names = buttonNames(model);
  describeSpaceMouse(seen, escButton(model));
  return seen;
}

/// A path is reused for the next device that is plugged in.
bool isSame(const HidNode& one, const HidNode& other) {
  return one.path == other.path && one.vendor == other.vendor && one.product == other.product;
}

}  // namespace

SpaceMice::SpaceMice(HidBus& bus, std::int64_t search_every_ns) : bus_(bus), search_every_ns_(search_every_ns) {}

SpaceMice::~SpaceMice() {
  {
    const std::scoped_lock lock(mutex_);
    ends_ = true;
  }
  ending_.notify_all();
  if (thread_.joinable()) thread_.join();
}

std::vector<DeviceState> SpaceMice::poll() {
  if (!thread_.joinable()) thread_ = std::thread(&SpaceMice::run, this);
  const std::scoped_lock lock(mutex_);
  return seen_;
}

void SpaceMice::run() {
  std::int64_t searched_ns = system::monotonicNow_ns() - search_every_ns_;
  for (;;) {
    {
      std::unique_lock lock(mutex_);
      const bool any =
          std::any_of(mice_.begin(), mice_.end(), [](const Mouse& mouse) { return mouse.pipe != nullptr; });
      if (!any) ending_.wait_for(lock, std::chrono::milliseconds(kIdle_ms), [this] { return ends_; });
      if (ends_) break;
    }
    if (system::monotonicNow_ns() - searched_ns >= search_every_ns_) {
      search();
      searched_ns = system::monotonicNow_ns();
    }
    const int each_ms = std::max(1, kRead_ms / std::max(1, static_cast<int>(mice_.size())));
    const auto isGone = [&](Mouse& mouse) { return mouse.pipe != nullptr && !read(mouse, each_ms); };
    mice_.erase(std::remove_if(mice_.begin(), mice_.end(), isGone), mice_.end());
    publish();
  }
}

/// Opens what is new; tries again what could not be opened.
void SpaceMice::search() {
  std::vector<HidNode> nodes = bus_.nodes();
  nodes.erase(std::remove_if(nodes.begin(), nodes.end(), [](const HidNode& node) { return !isSpaceMouse(node); }),
              nodes.end());
  const auto isThere = [&nodes](const Mouse& mouse) {
    return std::any_of(nodes.begin(), nodes.end(), [&](const HidNode& node) { return isSame(node, mouse.node); });
  };
  mice_.erase(std::remove_if(mice_.begin(), mice_.end(), [&](const Mouse& mouse) { return !isThere(mouse); }),
              mice_.end());
  for (const HidNode& node : nodes) {
    auto mouse = std::find_if(mice_.begin(), mice_.end(), [&](const Mouse& one) { return isSame(node, one.node); });
    if (mouse == mice_.end()) {
      mice_.emplace_back();
      mouse = std::prev(mice_.end());
      mouse->model = findSpaceMouse(node.vendor, node.product);
    }
    mouse->node = node;
    if (mouse->pipe == nullptr) open(*mouse);
  }
}

void SpaceMice::open(Mouse& mouse) {
  mouse.missing.clear();
  mouse.readings = {};
  mouse.readings.axes = 6;
  mouse.readings.buttons =
      mouse.model->buttons.empty() ? kMaxButtons / 4 : static_cast<int>(mouse.model->buttons.size());
  if (!bus_.mayOpen(mouse.node)) {
    mouse.missing = {{phrase(TRANSLATE_NOOP("problem", "You do not have permission to read %1."), {mouse.node.path}),
                      udevCommand(mouse.node)}};
    return;
  }
  Result<std::unique_ptr<HidPipe>> pipe = bus_.open(mouse.node);
  if (pipe)
    mouse.pipe = std::move(pipe).value();
  else
    for (const Problem& problem : pipe.problems()) mouse.missing.push_back({problem.sentence, {}});
}

/// false: it is unplugged.
bool SpaceMice::read(Mouse& mouse, int time_ms) {
  std::array<std::uint8_t, 64> bytes{};
  for (int count = 0; count < kMaxAtOnce; ++count) {
    const int size = mouse.pipe->read(bytes, count == 0 ? time_ms : 0);
    if (size < 0) return false;
    if (size == 0) break;
    const auto report = std::span(bytes).first(std::min(static_cast<std::size_t>(size), bytes.size()));
    if (readSpaceMouseReport(report, mouse.readings) == SpaceMouseReport::Moved)
      mouse.moved_ns = system::monotonicNow_ns();
  }
  if (system::monotonicNow_ns() - mouse.moved_ns > kSilent_ns) mouse.readings.axis.fill(0.0);
  return true;
}

void SpaceMice::publish() {
  std::vector<DeviceState> seen;
  for (const Mouse& mouse : mice_) {
    seen.push_back(describeNode(mouse.node, *mouse.model));
    seen.back().readings = mouse.readings;
    seen.back().missing = mouse.missing;
  }
  makeIdsUnique(seen);
  const std::scoped_lock lock(mutex_);
  seen_ = std::move(seen);
}

}  // namespace underact::device::input
