#pragma once
#include <utility>

#include "core/base/real_time.h"

namespace underact {

#if defined(__clang__) && __clang_major__ >= 20
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wfunction-effects"
#endif
/// Calls what the effect analysis cannot see through, and gives what that gives. Only UNDERACT_EXCEPTED uses it.
template <class Call>
[[gnu::always_inline]] inline decltype(auto) excepted(Call&& call) noexcept UNDERACT_REAL_TIME {
  return call();
}
#if defined(__clang__) && __clang_major__ >= 20
#pragma clang diagnostic pop
#endif

}  // namespace underact

// For one expression in a function marked UNDERACT_REAL_TIME whose callee clang cannot prove free of heap and locks.
// why: the reason why it is. tests/architecture/tick_effects lists all of them; nothing else is excepted from the
// analysis.
#define UNDERACT_EXCEPTED(why, ...) ::underact::excepted([&]() noexcept -> decltype(auto) { return __VA_ARGS__; })
