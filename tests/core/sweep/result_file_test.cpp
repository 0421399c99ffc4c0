#include "core/sweep/result_file.h"

#include <gtest/gtest.h>

#include "tests/core/sweep/some_sweep.h"

namespace underact::sweep {
namespace {

using test::someSweep;
using test::textOf;
using test::writeTo;

class ResultFile : public testing::Test {
 protected:
  ResultFile() {
    for (std::size_t cell = 0; cell < sweep_.cells.count; ++cell) rows_[cell] = rowOf(sweep_, cell).value();
  }
  Problems write() const { return writeResult(sweep_, rows_, path_); }
  std::string whole() const { return sweep_.header + test::allRows(sweep_); }

  test::SweepFolder folder_;
  std::string path_ = folder_.file("r.csv"), beside_ = folder_.file("r.csv.new");
  Sweep sweep_ = someSweep();
  Rows rows_;
};

TEST_F(ResultFile, HasTheHeaderAndAllRowsAndNothingBesideIt) {
  EXPECT_TRUE(write().empty());
  EXPECT_EQ(textOf(path_), whole());
  EXPECT_TRUE(isThere(sweep_, path_).value());
  EXPECT_FALSE(std::filesystem::exists(beside_));
}

TEST_F(ResultFile, OverwritesNothingThatHasComeMeanwhile) {
  writeTo(path_, "a letter");
  const Problems problems = write();
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].place.file, path_);
  EXPECT_NE(problems[0].sentence.find("is not overwritten"), std::string::npos) << problems[0].sentence;
  EXPECT_EQ(textOf(path_), "a letter");
  EXPECT_FALSE(std::filesystem::exists(beside_));
}

TEST_F(ResultFile, OverwritesNoLinkThatLeadsNowhere) {
  std::filesystem::create_symlink(folder_.file("elsewhere"), path_);
  EXPECT_FALSE(isThere(sweep_, path_)) << "told before the cells are run";
  EXPECT_FALSE(write().empty());
  EXPECT_FALSE(std::filesystem::exists(folder_.file("elsewhere")));
  std::filesystem::remove(path_);
  std::filesystem::create_symlink(folder_.file("elsewhere"), beside_);
  EXPECT_FALSE(write().empty());
  EXPECT_FALSE(std::filesystem::exists(folder_.file("elsewhere")));
}

TEST_F(ResultFile, TakesTheTornPartOfAKilledProgramAwayAndNothingElse) {
  writeTo(beside_, whole().substr(0, 100));
  EXPECT_TRUE(write().empty());
  EXPECT_EQ(textOf(path_), whole());
  std::filesystem::remove(path_);
  writeTo(beside_, "a letter");
  const Problems problems = write();
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].place.file, beside_);
  EXPECT_EQ(textOf(beside_), "a letter");
  EXPECT_FALSE(std::filesystem::exists(path_));
}

TEST_F(ResultFile, OnAFullDiskLeavesNothing) {
  const test::SmallFiles small(100);
  EXPECT_FALSE(write().empty());
  EXPECT_FALSE(std::filesystem::exists(path_));
  EXPECT_FALSE(std::filesystem::exists(beside_));
}

}  // namespace
}  // namespace underact::sweep
