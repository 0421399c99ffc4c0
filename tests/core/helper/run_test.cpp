#include "core/helper/run.h"

#include <gtest/gtest.h>

namespace underact::helper {

TEST(Run, ToldFromOneThatComputesOneThatOnlyWaitsIsNoFaultOfTheFile) {
  HelperCall errand;
  errand.program = "/bin/sleep";
  errand.argument = "20";
  errand.max_time_s = 0.2;
  EXPECT_EQ(run(errand, {}).ending, Ending::Waited);
  EXPECT_EQ(timeoutText(errand.max_time_s),
            "Reading the file took longer than 0.2 s, although there was little to compute: the disk or the network "
            "may be slow. Copy the file to this computer, and open the copy.");
}

TEST(Run, OneThatWritesWithoutEndIsEndedSoonAfterItsShare) {
  HelperCall errand;
  errand.program = "/usr/bin/yes";  // a letter that is no share of the way
  errand.argument = "y";
  errand.max_output = 100'000;
  errand.max_cpu_s = errand.max_time_s = 20.0;
  const Answer answer = run(errand, {});
  EXPECT_EQ(answer.ending, Ending::WroteTooMuch);
  EXPECT_GT(answer.output.size(), errand.max_output);
  EXPECT_LT(answer.output.size(), errand.max_output + 2'000'000) << "a block beyond it";
}

}  // namespace underact::helper
