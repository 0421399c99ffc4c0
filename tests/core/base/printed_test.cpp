#include "core/base/printed.h"

#include <gtest/gtest.h>

#include "core/base/result.h"

namespace underact {
namespace {

TEST(Printed, ControlCharactersAreShownAndEverythingElseStays) {
  EXPECT_EQ(printed("a\x1B[31m\nb\r\t\x7F"), "a\\u001b[31m\\nb\\r\\t\\u007f");
  EXPECT_EQ(printed(std::string_view("a\0b", 3)), "a\\u0000b");
  EXPECT_EQ(printed("\u009B31m"), "\\u009b31m") << "C1: a terminal may take it for ESC [";
  EXPECT_EQ(printed("a\u202Eb\u2066\u200F\u2028\u061C"), "a\\u202eb\\u2066\\u200f\\u2028\\u061c");
  EXPECT_EQ(printed("Küche € 🙂 \u00A0\u2013"), "Küche € 🙂 \u00A0\u2013");
}

TEST(Printed, ReplacesInvalidUtf8ByteForByte) {
  EXPECT_EQ(printed("a\x9B!"), "a\uFFFD!") << "a bare byte of C1";
  EXPECT_EQ(printed("\xE2\x80"), "\uFFFD\uFFFD");
  EXPECT_EQ(printed("\xC0\x9B"), "\uFFFD\uFFFD") << "overlong";
  EXPECT_EQ(printed("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD") << "a surrogate";
  EXPECT_EQ(printed("\xF5\x80\x80\x80"), "\uFFFD\uFFFD\uFFFD\uFFFD");
}

TEST(Printed, AProblemIsOneLineWhateverItsFileIsCalled) {
  EXPECT_EQ(describe(Problem{"No.\x1B", {"a\nb.json: error", 1, 2, "k\u202E"}}),
            "a\\nb.json: error:1:2: error: k\\u202e: No.\\u001b");
}

}  // namespace
}  // namespace underact
