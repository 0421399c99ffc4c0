#include "core/base/random.h"

#include <gtest/gtest.h>

namespace underact {

TEST(NextBits, AreThoseOfSplitMix64) {  // the first numbers of seed 0, as Vigna's reference prints them
  std::uint64_t state = 0;
  EXPECT_EQ(nextBits(state), 0xE220A8397B1DCDAFU);
  EXPECT_EQ(nextBits(state), 0x6E789E6AA1B965F4U);
  EXPECT_EQ(nextBits(state), 0x06C45D188009454FU);
}

TEST(NextShare, IsTheUpperFiftyThreeBits) {
  std::uint64_t bits = 7, share = 7;
  for (int draw = 0; draw < 1000; ++draw) {
    const double expected = static_cast<double>(nextBits(bits) / 2048U) / 9007199254740992.0;
    EXPECT_EQ(nextShare(share), expected);
    EXPECT_LT(expected, 1.0);
  }
}

}  // namespace underact
