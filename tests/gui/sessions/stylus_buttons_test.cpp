#include "app/gui/sessions/stylus_buttons.h"

#include <gtest/gtest.h>

namespace underact::gui::test {

TEST(ButtonEdges, APressIsCountedOnceAndABounceNotAtAll) {
  ButtonEdges edges;
  servo::TickRecord record;
  const auto at = [&](std::int64_t ms, unsigned buttons) {
    record.time_ns = 1'000'000 * ms;
    record.buttons = buttons;
    return edges.add(record);
  };
  EXPECT_EQ(at(1, 2), 0U);  // held from before
  EXPECT_EQ(at(100, 0), 0U);
  EXPECT_EQ(at(200, 2), 2U);
  EXPECT_EQ(at(201, 2), 0U);
  EXPECT_EQ(at(202, 0), 0U);
  EXPECT_EQ(at(205, 2), 0U);  // it has bounced
  EXPECT_EQ(at(300, 0), 0U);
  EXPECT_EQ(at(400, 3), 3U);
}

}  // namespace underact::gui::test
