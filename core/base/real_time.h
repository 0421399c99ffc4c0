#pragma once

// Marks a function that the servo thread may call: no lock, allocation, exception, log or I/O. Clang 20 and newer check
// it (-Wfunction-effects, tests/architecture/tick_effects); for other compilers it is documentation, and the tests
// count allocations instead (tests/malloc).
#if defined(__clang__) && __clang_major__ >= 20
#define UNDERACT_REAL_TIME [[clang::nonblocking]]
#else
#define UNDERACT_REAL_TIME
#endif
