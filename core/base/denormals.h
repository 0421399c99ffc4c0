#pragma once
#include <cstdint>

#if defined(__SSE2__) || defined(_M_X64)
#include <xmmintrin.h>
#endif

namespace underact {

/// While an object of this class exists, the floating-point arithmetic of this thread treats numbers below the smallest
/// normal one (2e-308) as zero, as operands and as results: on some processors they make a tick a hundred times slower.
/// Used wherever the servo ticks, by its thread or by hand, since it affects last bits. Without effect on unknown
/// processors.
class FlushDenormals {
 public:
  /// Sets the mode of the calling thread; the destructor, on the same thread, restores what was set before.
  FlushDenormals() noexcept : before_(control()) { setControl(before_ | kFlush); }
  ~FlushDenormals() { setControl((control() & ~kFlush) | (before_ & kFlush)); }
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

  /// Whether this processor is a known one.
  static constexpr bool isKnown() noexcept { return kFlush != 0; }

 private:
#if defined(__SSE2__) || defined(_M_X64)
  static constexpr std::uint64_t kFlush = 0x8040;  // MXCSR: FTZ (results) and DAZ (operands)
  static std::uint64_t control() noexcept {
    return _mm_getcsr();
  }
  static void setControl(std::uint64_t value) noexcept {
    _mm_setcsr(static_cast<unsigned>(value));
  }
#elif defined(__aarch64__)
  static constexpr std::uint64_t kFlush = std::uint64_t{1} << 24;  // FPCR.FZ: operands and results
  static std::uint64_t control() noexcept {
    std::uint64_t value = 0;
    asm volatile("mrs %0, fpcr" : "=r"(value));
    return value;
  }
  static void setControl(std::uint64_t value) noexcept {
    asm volatile("msr fpcr, %0" : : "r"(value));
  }
#else
  static constexpr std::uint64_t kFlush = 0;
  static std::uint64_t control() noexcept {
    return 0;
  }
  static void setControl(std::uint64_t /*value*/) noexcept {}
#endif

  std::uint64_t before_;
};

}  // namespace underact
