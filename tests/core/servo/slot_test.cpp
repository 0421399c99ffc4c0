#include "core/servo/slot.h"

#include <gtest/gtest.h>

#include <array>
#include <thread>

namespace underact::servo {

TEST(Slot, GivesTheNewestValueOnceAndAgain) {
  Slot<int> slot;
  slot.back() = 1;
  slot.publish();
  slot.back() = 2;
  slot.publish();
  EXPECT_EQ(slot.latest(), 2);
  EXPECT_EQ(slot.latest(), 2);
}

TEST(Slot, ShowsOnlyWhatWasPublished) {
  Slot<int> slot;
  slot.back() = 1;
  slot.publish();
  EXPECT_EQ(slot.latest(), 1);
  slot.back() = 9;
  EXPECT_EQ(slot.latest(), 1);
}

TEST(Slot, AReaderBesideAWriterSeesWholeAndRisingValues) {  // thread sanitizer sees any race
  using Wide = std::array<long, 64>;
  Slot<Wide> slot;
  constexpr long kLast = 200'000;
  std::thread writer([&] {
    for (long value = 1; value <= kLast; ++value) {
      slot.back().fill(value);
      slot.publish();
    }
  });
  long last = 0;
  while (last < kLast) {
    const Wide& seen = slot.latest();
    ASSERT_GE(seen[0], last);
    for (const long part : seen) ASSERT_EQ(part, seen[0]);
    last = seen[0];
  }
  writer.join();
}

}  // namespace underact::servo
