#include "core/servo/tap.h"

#include <algorithm>

#include "core/base/excepted.h"
#include "core/servo/touch_pages.h"

namespace underact::servo {
namespace {

constexpr std::int64_t kRoom_ns = 4'000'000'000;
constexpr std::int64_t kRoomAtLeast = 16384;
constexpr std::size_t kEvents = 1024;  // edits or faults between two readings of the recorder

std::size_t roomFor(std::int64_t period_ns) {
  return static_cast<std::size_t>(std::max(kRoomAtLeast, kRoom_ns / std::max<std::int64_t>(period_ns, 1)));
}

}  // namespace

Tap::Tap(std::int64_t period_ns, std::int64_t max_ticks, std::size_t details)
    : records_(roomFor(period_ns)),
      changes_(kEvents),
      faults_(kEvents),
      pushes_(roomFor(period_ns)),  // a program may push in each tick
      details_(details),
      ticks_left_(max_ticks > 0 ? max_ticks : -1) {
  touchPages(records_);
  touchPages(changes_);
  touchPages(faults_);
  touchPages(pushes_);
  if (details > 0) {
    truths_ = std::make_unique<boost::lockfree::spsc_queue<TruthRow>>(roomFor(period_ns));
    constraints_ = std::make_unique<boost::lockfree::spsc_queue<ConstraintRow>>(details * roomFor(period_ns));
    touchPages(*truths_);
    touchPages(*constraints_);
  }
  start_.entries.resize(tick::kMaxConstraints);  // touches the pages, too
  start_.entries.clear();
}

void Tap::begin(std::int64_t tick, std::uint64_t revision, const tick::TickState& state) noexcept {
  UNDERACT_EXCEPTED("a vector with its room from the start: tests/malloc counts", start_ = state);
  first_tick_ = tick;
  first_revision_ = revision;
  wants_start_.store(false, std::memory_order_relaxed);
  begun_.store(true, std::memory_order_release);
}

void Tap::add(const TickRecord& record) noexcept {
  if (!listens() || ticks_left_ == 0) return;
  if (ticks_left_ > 0) --ticks_left_;
  if (!records_.push(record)) drop();
}

void Tap::add(const Change& change) noexcept {
  if (listens() && !changes_.push(change)) drop();
}

void Tap::add(const FaultMark& fault) noexcept {
  if (listens() && !faults_.push(fault)) drop();
}

void Tap::add(const Push& push) noexcept {
  if (listens() && !pushes_.push(push)) drop();
}

void Tap::add(const TruthRow& row) noexcept {
  if (listens() && ticks_left_ != 0 && !truths_->push(row)) drop();
}

void Tap::add(const ConstraintRow& row) noexcept {
  if (listens() && ticks_left_ != 0 && !constraints_->push(row)) drop();
}

std::size_t Tap::room() const {
  const std::size_t rows = records_.write_available();
  if (details_ == 0) return rows;
  return std::min({rows, truths_->write_available(), constraints_->write_available() / details_});
}

void Tap::announce(std::uint64_t revision, const scene::Description& scene) {
  const std::scoped_lock lock(scenes_mutex_);
  scenes_[revision] = scene;
}

scene::Description Tap::takeScene(std::uint64_t revision) {
  const std::scoped_lock lock(scenes_mutex_);
  const auto found = scenes_.find(revision);
  if (found == scenes_.end()) return {};
  scene::Description scene = std::move(found->second);
  scenes_.erase(scenes_.begin(), std::next(found));  // older ones never came into effect
  return scene;
}

}  // namespace underact::servo
