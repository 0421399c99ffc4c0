#pragma once
#include <utility>

#include "core/base/real_time.h"

namespace underact {

/// Calls what the effect analysis cannot see through; only by UNDERACT_EXCEPTED.
#if defined(__clang__) && __clang_major__ >= 20
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wfunction-effects"
#endif
template <class Call>
[[gnu::always_inline]] inline decltype(auto) excepted(Call&& call) noexcept UNDERACT_REAL_TIME {
  return call();
}
#if defined(__clang__) && __clang_major__ >= 20
#pragma clang diagnostic pop
#endif

}  // namespace underact

// One expression in a function marked UNDERACT_REAL_TIME that calls what clang cannot know to keep off heap and locks,
// with the reason why it does, and who counts. tests/house/tick_effects lists all of them; there is no other way past
// it.
#define UNDERACT_EXCEPTED(why, ...) ::underact::excepted([&]() noexcept -> decltype(auto) { return __VA_ARGS__; })
