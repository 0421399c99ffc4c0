#include "core/servo/histogram.h"

#include <algorithm>
#include <bit>

namespace underact::servo {
namespace {

constexpr int kStepBits = 5;  // 32 buckets an octave

/// Below 32 ns a bucket each; above, the octave and the five bits after the leading one.
std::size_t bucketOf(std::uint64_t ns) {
  if (ns < 32) return ns;
  const int shift = static_cast<int>(std::bit_width(ns)) - 1 - kStepBits;
  return static_cast<std::size_t>((static_cast<std::uint64_t>(shift) << kStepBits) + (ns >> shift));
}

/// The largest duration that falls into a bucket.
std::uint64_t upperEdge_ns(std::size_t bucket) {
  if (bucket < 64) return bucket;
  const std::uint64_t shift = (bucket >> kStepBits) - 1;
  const std::uint64_t step = (bucket & 31U) + 32;
  return ((step + 1) << shift) - 1;
}

}  // namespace

void Histogram::add(std::int64_t duration_ns) noexcept {
  const std::int64_t held_ns = std::clamp<std::int64_t>(duration_ns, 0, std::int64_t{1} << 35);
  ++counts_[bucketOf(static_cast<std::uint64_t>(held_ns))];
  ++count_;
  max_ns_ = std::max(max_ns_, held_ns);
}

void Histogram::add(const Histogram& other) noexcept {
  for (std::size_t bucket = 0; bucket < counts_.size(); ++bucket) counts_[bucket] += other.counts_[bucket];
  count_ += other.count_;
  max_ns_ = std::max(max_ns_, other.max_ns_);
}

std::int64_t Histogram::between(std::int64_t from_ns, std::int64_t to_ns) const noexcept {
  std::int64_t sum = 0;
  for (std::size_t bucket = 0; bucket < counts_.size(); ++bucket) {
    const auto edge_ns = static_cast<std::int64_t>(upperEdge_ns(bucket));
    if (edge_ns > from_ns && edge_ns <= to_ns) sum += counts_[bucket];
  }
  return sum;
}

Percentiles Histogram::percentiles() const noexcept {
  Percentiles result;
  if (count_ == 0) return result;
  const auto at = [this](double share) {
    const auto wanted = static_cast<std::int64_t>(share * static_cast<double>(count_ - 1)) + 1;
    std::int64_t seen = 0;
    for (std::size_t bucket = 0; bucket < counts_.size(); ++bucket) {
      seen += counts_[bucket];
      if (seen >= wanted)
        return std::min(static_cast<double>(upperEdge_ns(bucket)), static_cast<double>(max_ns_)) * 1e-3;
    }
    return static_cast<double>(max_ns_) * 1e-3;
  };
  result = {at(0.50), at(0.99), at(0.999), static_cast<double>(max_ns_) * 1e-3};
  return result;
}

}  // namespace underact::servo
