#include <gtest/gtest.h>

#include "tests/cli/scene.h"
#include "tests/cli/session.h"

namespace underact::test {
namespace {

using cli::Exit;

TEST(LabSearch, TellsTimeAndErrorOfEachSearchOfAMesh) {
  const Outcome outcome =
      runCli({"lab", "search", scene("26_bumpy_sphere"), "--hand", "probe", "--seconds", "2", "--json"});
  ASSERT_EQ(outcome.exit, Exit::Success) << outcome.err;
  const json::Value object = lines(outcome.out).at(0);
  EXPECT_EQ(textAt(object, "constraint"), "ball");
  EXPECT_GT(numberAt(object, "count"), 15000);
  const std::vector<json::Value>& rows = object.find("searches")->items;
  ASSERT_EQ(rows.size(), 3U);
  for (const json::Value& row : rows) {
    EXPECT_GT(numberAt(row, "p50_us"), 0.0);
    EXPECT_LE(numberAt(row, "p50_us"), numberAt(row, "p99_us"));
    if (textAt(row, "search") == "local") continue;
    EXPECT_EQ(numberAt(row, "share_beside"), 0.0);  // hybrid and global: the nearest of all
    EXPECT_EQ(numberAt(row, "share_unproved"), 0.0);
  }
}

TEST(LabSearch, TellsThemOfACurveAsATableToo) {
  const Outcome outcome = runCli({"lab", "search", scene("29_signature"), "--seconds", "1"});
  ASSERT_EQ(outcome.exit, Exit::Success) << outcome.err;
  EXPECT_NE(outcome.out.find("stroke, "), std::string::npos);
  for (const char* search : {"local", "hybrid", "global"}) EXPECT_NE(outcome.out.find(search), std::string::npos);
}

TEST(LabSearch, WhereNothingIsSoughtItSaysSo) {
  const Outcome outcome = runCli({"lab", "search", scene("02_sphere")});
  EXPECT_EQ(outcome.exit, Exit::BadInput);
  EXPECT_NE(outcome.err.find("no mesh and no curve"), std::string::npos);
  EXPECT_EQ(runCli({"lab", "search", scene("26_bumpy_sphere"), "--hand", "swep"}).exit, Exit::Usage);
}

}  // namespace
}  // namespace underact::test
