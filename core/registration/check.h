#pragma once
#include <cstddef>
#include <vector>

#include "core/base/sentence.h"
#include "core/registration/fit.h"

namespace underact::registration {

/// What a person should know of a fit before trusting it.
struct Warning {
  enum class Kind { NearLine, NearMarks, Order, UpsideDown, Residual, Moved };
  Kind kind;
  Sentence sentence;
  std::vector<std::size_t> marks;  // that it is about, from 0
};
std::vector<Warning> warningsOf(const std::vector<Touch>& touches, const Fit& fit);

/// The order in which the marks were probably touched: for each touched point the mark that it is. As they stand where
/// no other order fits much better.
std::vector<std::size_t> likelyOrder(const std::vector<Touch>& touches, const Fit& fit);

/// The mark that was most probably touched beside its place: without it the others fit best; of three marks, that with
/// the largest residual.
std::size_t worstMark(const std::vector<Touch>& touches, const Fit& fit);

/// Whether the arm's own "up" points up from the desk.
bool isUpright(const Fit& fit);

}  // namespace underact::registration
