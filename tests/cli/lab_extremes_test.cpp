#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/cli/session.h"

namespace underact::test {
namespace {

using cli::Exit;

TEST(LabExtremes, TellsTheWorstOfEachRowAskedFor) {
  const Outcome outcome = runCli({"lab", "extremes", "--only", "law_p,shape_circle", "--count", "100", "--json"});
  ASSERT_EQ(outcome.exit, Exit::Well) << outcome.err;
  const std::vector<json::Value> rows = lines(outcome.out);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(textAt(rows[0], "key"), "shape_circle");  // in the order of the catalogue
  EXPECT_EQ(textAt(rows[1], "key"), "law_p");
  EXPECT_EQ(numberAt(rows[1], "cases"), 100);
  EXPECT_LE(numberAt(rows[1], "error_ulp"), numberAt(rows[1], "promised_ulp"));
  EXPECT_NE(textAt(rows[1], "input").find("e_W.x "), std::string::npos);
}

TEST(LabExtremes, SeedsAreCellsOfTheirOwn) {
  const auto cases = [](const std::string& seed, const std::string& seeds) {
    const Outcome outcome = runCli(
        {"lab", "extremes", "--only", "gate_clamp", "--count", "50", "--seed", seed, "--seeds", seeds, "--json"});
    return lines(outcome.out).at(0);
  };
  const json::Value first = cases("3", "1"), second = cases("4", "1"), both = cases("3", "2");
  EXPECT_EQ(numberAt(both, "cases"), 100);
  EXPECT_EQ(numberAt(both, "error_ulp"), std::max(numberAt(first, "error_ulp"), numberAt(second, "error_ulp")));
}

TEST(LabExtremes, IsATableOrCsv) {
  const Outcome table = runCli({"lab", "extremes", "--only", "law_p", "--count", "10"});
  EXPECT_EQ(table.exit, Exit::Well);
  EXPECT_NE(table.out.find("worst ulp"), std::string::npos);
  EXPECT_NE(table.out.find("law_p "), std::string::npos);
  const Outcome csv = runCli({"lab", "extremes", "--only", "law_p", "--count", "10", "--csv"});
  EXPECT_EQ(
      csv.out.rfind("key,kind,asked,error_ulp,promised_ulp,promise,cases,degenerate,seconds,input\nlaw_p,law,", 0), 0U);
  EXPECT_EQ(runCli({"lab", "extremes", "--csv", "--json"}).exit, Exit::Usage);
}

TEST(LabExtremes, KeepsTheWorstCases) {
  const std::filesystem::path path = std::filesystem::temp_directory_path() / "underact_kept_extremes.csv";
  const Outcome outcome = runCli({"lab", "extremes", "--only", "law_p", "--count", "10", "--keep", path.string()});
  ASSERT_EQ(outcome.exit, Exit::Well) << outcome.err;
  std::ifstream file(path);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(text.rfind("key,error_ulp,input\nlaw_p,", 0), 0U) << text;
  std::filesystem::remove(path);
  EXPECT_EQ(runCli({"lab", "extremes", "--only", "law_p", "--count", "10", "--keep", "/dev/null/x"}).exit, Exit::File);
}

TEST(LabExtremes, ARowThatIsNoneIsWrongUsage) {
  const Outcome outcome = runCli({"lab", "extremes", "--only", "shape_cirle"});
  EXPECT_EQ(outcome.exit, Exit::Usage);
  EXPECT_NE(outcome.err.find("Did you mean \"shape_circle\"?"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace underact::test
