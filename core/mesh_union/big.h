#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

namespace underact::mesh_union {

__extension__ typedef __int128 Wide;
__extension__ typedef unsigned __int128 UnsignedWide;

/// -1, 0 or 1.
inline int signOf(Wide value) {
  return (value > 0 ? 1 : 0) - (value < 0 ? 1 : 0);
}

/// An integer below 2^640 in magnitude, exact. What is computed here from coordinates of 26 bits stays below 2^560: see
/// grid.h and points.h.
class Big {
 public:
  Big() = default;
  Big(Wide value);  // implicit: any integer is one

  /// -1, 0 or 1.
  int sign() const { return size_ == 0 ? 0 : is_negative_ ? -1 : 1; }
  /// With a relative error below 2^-51.
  double toDouble() const;
  /// Modulo 2^61 - 1, from 0 to 2^61 - 2.
  std::uint64_t modulo() const;

  // Exact; below 2^640 in magnitude.
  Big operator-() const;
  friend Big operator+(const Big& a, const Big& b);
  friend Big operator-(const Big& a, const Big& b) { return a + (-b); }
  friend Big operator*(const Big& a, const Big& b);

 private:
  static constexpr std::size_t kLimbs = 10;
  static int compareMagnitude(const Big& a, const Big& b);
  std::array<std::uint64_t, kLimbs> limbs_{};  // the lowest first; of size_ on all 0
  std::uint32_t size_ = 0;
  bool is_negative_ = false;
};

inline constexpr std::uint64_t kModulus = (std::uint64_t{1} << 61U) - 1;

// Products and inverses modulo kModulus; the inverse of 0 is 0.
std::uint64_t timesModulo(std::uint64_t a, std::uint64_t b);
std::uint64_t inverseModulo(std::uint64_t a);

}  // namespace underact::mesh_union
