#pragma once
#include <cstddef>
#include <vector>

#include "core/base/sentence.h"
#include "core/registration/fit.h"

namespace underact::registration {

/// Something to know about a fit before trusting it.
struct Warning {
  /// What it warns of: points near one line or near each other, a wrong order, an arm upside down, a large residual, a
  /// tip that moved while it was held.
  enum class Kind { NearLine, NearMarks, Order, UpsideDown, Residual, Moved };
  Kind kind;
  Sentence sentence;
  std::vector<std::size_t> marks;  // indexes of the reference points concerned
};
/// All there are; empty where the fit may be trusted. fit: fitTouches() of these touches.
std::vector<Warning> warningsOf(const std::vector<Touch>& touches, const Fit& fit);

/// The order in which the reference points were probably touched: for each touch the index of its reference point. The
/// order as it is unless another one fits much better.
std::vector<std::size_t> likelyOrder(const std::vector<Touch>& touches, const Fit& fit);

/// The index of the reference point that was most probably touched inaccurately: the others fit best without it; of
/// three, the one with the largest residual.
std::size_t worstPoint(const std::vector<Touch>& touches, const Fit& fit);

/// Whether the arm's own "up" points up from the desk.
bool isUpright(const Fit& fit);

}  // namespace underact::registration
