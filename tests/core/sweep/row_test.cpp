#include "core/sweep/row.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

#include "core/base/random.h"

namespace underact::sweep {

TEST(Row, HasNumbersThatReadBackToTheSameDouble) {
  std::uint64_t state = 3;
  for (int draw = 0; draw < 2000; ++draw) {
    const double value = std::ldexp(nextShare(state) - 0.5, static_cast<int>(nextBits(state) % 2000U) - 1000);
    SweepRow row;
    row.add(value);
    EXPECT_EQ(std::strtod(row.text().c_str(), nullptr), value);
  }
}

TEST(Row, SaysWhatIsNotFiniteSoThatItReadsBack) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  SweepRow row;
  row.add(kInf);
  row.add(-kInf);
  row.add(std::nan(""));
  EXPECT_EQ(row.text(), "inf,-inf,nan");
}

TEST(Row, QuotesWhatWouldBeReadAsSomethingElse) {
  SweepRow row;
  for (const char* text : {"plain", "a,b", "a \"b\"", " a", "a ", "two\nlines\r", ""}) row.add(text);
  row.add(7);
  EXPECT_EQ(row.text(), "plain,\"a,b\",\"a \"\"b\"\"\",\" a\",\"a \",\"two lines \",,7");
  EXPECT_EQ(row.fields(), 8U);
}

}  // namespace underact::sweep
