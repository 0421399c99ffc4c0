#include "core/sweep/messages.h"

#include <gtest/gtest.h>

namespace underact::sweep {

TEST(Letters, OfARankAreReadAsTheyWereWritten) {
  const Report done{MessageKind::Done, {}, 3, {{7, "7,8,\"a b\""}, {12, ""}}};
  const std::optional<Report> read = readReport(write(done));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->word, MessageKind::Done);
  EXPECT_EQ(read->wants, 3U);
  ASSERT_EQ(read->rows.size(), 2U);
  EXPECT_EQ(read->rows[0].cell, 7U);
  EXPECT_EQ(read->rows[0].row, "7,8,\"a b\"");
  EXPECT_EQ(read->rows[1].row, "");
  for (const MessageKind word :
       {MessageKind::Hello, MessageKind::Trouble, MessageKind::Interrupted, MessageKind::Bye}) {
    const std::optional<Report> other = readReport(write(Report{word, "two\nlines"}));
    ASSERT_TRUE(other);
    EXPECT_EQ(other->word, word);
    EXPECT_EQ(other->text, "two\nlines");
  }
}

TEST(Letters, OfTheLeaderAreReadAsTheyWereWritten) {
  EXPECT_TRUE(readOrder(write(Order{true}))->stop);
  const std::optional<Order> order = readOrder(write(Order{false, {4, 0, 1'000'000}}));
  ASSERT_TRUE(order);
  EXPECT_FALSE(order->stop);
  EXPECT_EQ(order->cells, (std::vector<std::size_t>{4, 0, 1'000'000}));
}

TEST(Letters, RefusesWhatIsNoLetter) {
  for (const char* text : {"", "hallo\n", "done", "done\nx\n", "done\n1\nx y\n", "done\n-1\n", "stop"})
    EXPECT_FALSE(readReport(text)) << text;
  for (const char* text : {"", "go", "cells\nx", "cells\n-1", "cells\n1\n2x", "bye\n"})
    EXPECT_FALSE(readOrder(text)) << text;
}

}  // namespace underact::sweep
