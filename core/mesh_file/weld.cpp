#include "core/mesh_file/weld.h"

#include <array>
#include <bit>
#include <cmath>

#include "core/mesh_file/steps.h"

namespace underact::mesh_file {
namespace {

// Cells of twice the tolerance: what is within the tolerance of a point is in its cell or in the adjacent one, on each
// axis on the side to which the point is nearer; so in 8 cells.
using Cell = std::array<std::int64_t, 3>;

std::uint64_t mixed(std::uint64_t z) {  // SplitMix64's (Steele, Lea, Flood 2014)
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  return z ^ (z >> 31U);
}

std::uint64_t hashOf(const Cell& cell) {
  std::uint64_t hash = 0x9E3779B97F4A7C15U;
  for (const std::int64_t index : cell) hash = mixed(hash + static_cast<std::uint64_t>(index));
  return hash;
}

/// First corners by their cells. Their order does not matter: all in a cell are looked at.
class Cells {
 public:
  explicit Cells(std::size_t corners) : slots_(std::bit_ceil(2 * corners + 2), -1), next_(corners, -1) {}

  void add(const Cell& cell, std::int32_t corner) {
    std::int32_t& slot = slots_[hashOf(cell) & (slots_.size() - 1)];
    next_[static_cast<std::size_t>(corner)] = slot;
    slot = corner;
  }
  std::int32_t firstIn(const Cell& cell) const { return slots_[hashOf(cell) & (slots_.size() - 1)]; }
  std::int32_t after(std::int32_t corner) const { return next_[static_cast<std::size_t>(corner)]; }

 private:
  std::vector<std::int32_t> slots_;
  std::vector<std::int32_t> next_;
};

class Welding {
 public:
  Welding(const std::vector<Eigen::Vector3f>& p_MV, double tolerance)
      : p_MV_(p_MV), tolerance_(tolerance), cells_(p_MV.size()) {}

  std::int32_t firstOf(std::int32_t corner) {
    const Vec3 p = at(corner);
    Cell cell{}, side{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double x = p[static_cast<Eigen::Index>(axis)];
      if (tolerance_ > 0.0) {
        const double place = x / (2.0 * tolerance_);
        cell[axis] = static_cast<std::int64_t>(std::floor(place));
        side[axis] = place - std::floor(place) < 0.5 ? -1 : 1;
      } else {
        cell[axis] = std::bit_cast<std::int64_t>(x + 0.0);  // -0 is 0
      }
    }
    std::int32_t best = -1;
    double best_squared = tolerance_ * tolerance_;
    for (unsigned around = 0; around < (tolerance_ > 0.0 ? 8U : 1U); ++around) {
      Cell other = cell;
      for (std::size_t axis = 0; axis < 3; ++axis) other[axis] += (around >> axis & 1U) != 0 ? side[axis] : 0;
      for (std::int32_t first = cells_.firstIn(other); first >= 0; first = cells_.after(first)) {
        const double squared = (at(first) - p).squaredNorm();
        const bool is_better = squared < best_squared || (squared == best_squared && (best < 0 || first < best));
        if (!is_better) continue;
        best = first;
        best_squared = squared;
      }
    }
    if (best >= 0) return best;
    cells_.add(cell, corner);
    return corner;
  }

 private:
  Vec3 at(std::int32_t corner) const { return p_MV_[static_cast<std::size_t>(corner)].cast<double>(); }
  const std::vector<Eigen::Vector3f>& p_MV_;
  double tolerance_;
  Cells cells_;
};

}  // namespace

std::optional<std::vector<std::int32_t>> weld(const std::vector<Eigen::Vector3f>& p_MV, double tolerance,
                                              const TaskMonitor& monitor) {
  Welding welding(p_MV, tolerance);
  Steps steps(monitor);
  std::vector<std::int32_t> firsts(p_MV.size());
  for (std::size_t corner = 0; corner < p_MV.size(); ++corner) {
    if (steps.isCancelled()) return {};
    firsts[corner] = welding.firstOf(static_cast<std::int32_t>(corner));
  }
  return firsts;
}

}  // namespace underact::mesh_file
