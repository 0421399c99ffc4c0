#include "core/helper/run.h"

#include <gtest/gtest.h>

namespace underact::helper {

TEST(Run, ToldFromOneThatComputesOneThatOnlyWaitsIsNoFaultOfTheFile) {
  Errand errand;
  errand.program = "/bin/sleep";
  errand.argument = "20";
  errand.most_time_s = 0.2;
  EXPECT_EQ(run(errand, {}).ending, Ending::Waited);
  EXPECT_EQ(whyWaited(errand.most_time_s),
            "The file could not be read within 0.2 s, though its reader had little to do: its disk or the network may "
            "be slow. Copy it to this computer, and open the copy.");
}

}  // namespace underact::helper
