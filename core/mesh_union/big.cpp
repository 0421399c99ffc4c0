#include "core/mesh_union/big.h"

#include <algorithm>

namespace underact::mesh_union {

Big::Big(Wide value) : is_negative_(value < 0) {
  const UnsignedWide magnitude = value < 0 ? -static_cast<UnsignedWide>(value) : static_cast<UnsignedWide>(value);
  limbs_[0] = static_cast<std::uint64_t>(magnitude);
  limbs_[1] = static_cast<std::uint64_t>(magnitude >> 64U);
  size_ = limbs_[1] != 0 ? 2 : limbs_[0] != 0 ? 1 : 0;
}

double Big::toDouble() const {
  double value = 0.0;
  for (std::uint32_t k = size_; k-- > 0;) value = value * 0x1p64 + static_cast<double>(limbs_[k]);
  return is_negative_ ? -value : value;
}

std::uint64_t Big::modulo() const {
  std::uint64_t rest = 0;
  for (std::uint32_t k = size_; k-- > 0;) {
    rest = static_cast<std::uint64_t>(((static_cast<UnsignedWide>(rest) << 64U) + limbs_[k]) % kModulus);
  }
  return is_negative_ && rest != 0 ? kModulus - rest : rest;
}

Big Big::operator-() const {
  Big other = *this;
  other.is_negative_ = !is_negative_ && size_ > 0;
  return other;
}

int Big::compareMagnitude(const Big& a, const Big& b) {
  if (a.size_ != b.size_) return a.size_ < b.size_ ? -1 : 1;
  for (std::uint32_t k = a.size_; k-- > 0;) {
    if (a.limbs_[k] != b.limbs_[k]) return a.limbs_[k] < b.limbs_[k] ? -1 : 1;
  }
  return 0;
}

Big operator+(const Big& a, const Big& b) {
  const bool swapped = Big::compareMagnitude(a, b) < 0;
  const Big& large = swapped ? b : a;
  const Big& small = swapped ? a : b;
  Big sum;
  sum.is_negative_ = large.is_negative_;
  const bool adds = large.is_negative_ == small.is_negative_;
  std::uint64_t carry = 0;
  const std::uint32_t max = std::min<std::uint32_t>(large.size_ + 1, Big::kLimbs);
  for (std::uint32_t k = 0; k < max; ++k) {
    const UnsignedWide x = large.limbs_[k], y = static_cast<UnsignedWide>(small.limbs_[k]) + carry;
    const UnsignedWide z = adds ? x + y : x - y;
    sum.limbs_[k] = static_cast<std::uint64_t>(z);
    carry = static_cast<std::uint64_t>(z >> 64U) != 0 ? 1 : 0;
    if (sum.limbs_[k] != 0) sum.size_ = k + 1;
  }
  if (sum.size_ == 0) sum.is_negative_ = false;
  return sum;
}

Big operator*(const Big& a, const Big& b) {
  Big product;
  if (a.size_ == 0 || b.size_ == 0) return product;
  for (std::uint32_t i = 0; i < a.size_; ++i) {
    std::uint64_t carry = 0;
    for (std::uint32_t j = 0; i + j < Big::kLimbs && (j < b.size_ || carry != 0); ++j) {
      const UnsignedWide sum = static_cast<UnsignedWide>(a.limbs_[i]) * b.limbs_[j < b.size_ ? j : Big::kLimbs - 1] *
                                   (j < b.size_ ? 1U : 0U) +
                               product.limbs_[i + j] + carry;
      product.limbs_[i + j] = static_cast<std::uint64_t>(sum);
      carry = static_cast<std::uint64_t>(sum >> 64U);
    }
  }
  product.size_ = std::min<std::uint32_t>(a.size_ + b.size_, Big::kLimbs);
  while (product.size_ > 0 && product.limbs_[product.size_ - 1] == 0) --product.size_;
  product.is_negative_ = a.is_negative_ != b.is_negative_;
  return product;
}

std::uint64_t timesModulo(std::uint64_t a, std::uint64_t b) {
  return static_cast<std::uint64_t>(static_cast<UnsignedWide>(a) * b % kModulus);
}

std::uint64_t inverseModulo(std::uint64_t a) {  // a^(p - 2), Fermat
  std::uint64_t inverse = 1;
  for (std::uint64_t power = kModulus - 2; power != 0; power >>= 1U) {
    if ((power & 1U) != 0) inverse = timesModulo(inverse, a);
    a = timesModulo(a, a);
  }
  return inverse;
}

}  // namespace underact::mesh_union
