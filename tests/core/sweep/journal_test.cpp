#include "core/sweep/journal.h"

#include <gtest/gtest.h>
#include <underact/version.h>

#include "core/sweep/result_file.h"
#include "tests/core/sweep/some_sweep.h"

namespace underact::sweep {
namespace {

using test::SmallFiles;
using test::someSweep;
using test::textOf;
using test::writeTo;

class JournalFile : public testing::Test {
 protected:
  Journal opened(const Sweep& sweep) const {
    Result<Journal> journal = Journal::open(sweep, result_);
    EXPECT_TRUE(journal) << (journal ? "" : describe(journal.problems().front()));
    return std::move(journal).value();
  }
  std::string refusal(const Sweep& sweep) const {
    const Result<Journal> journal = Journal::open(sweep, result_);
    EXPECT_FALSE(journal);
    return journal ? "" : journal.problems().front().sentence;
  }
  void add(const Sweep& sweep, std::initializer_list<std::size_t> cells) const {
    Journal journal = opened(sweep);
    for (const std::size_t cell : cells) EXPECT_TRUE(journal.add(cell, rowOf(sweep, cell).value()).empty());
  }
  std::string text() const { return textOf(path_); }

  test::SweepFolder folder_;
  std::string result_ = folder_.file("r.csv"), path_ = folder_.file("r.csv.part");
  Sweep sweep_ = someSweep();
};

TEST_F(JournalFile, KeepsRowsInWhateverOrderTheyCame) {
  add(sweep_, {7, 2, 19});
  add(sweep_, {0});
  const Journal journal = opened(sweep_);
  ASSERT_EQ(journal.rows().size(), 4U);
  for (const auto& [cell, row] : journal.rows()) EXPECT_EQ(row, rowOf(sweep_, cell).value());
}

TEST_F(JournalFile, HasEachCellOnceAndAtOnce) {
  Journal journal = opened(sweep_);
  EXPECT_TRUE(journal.add(3, "3,x").empty());
  const std::string before = text();
  EXPECT_NE(before.find("3 3,x\n"), std::string::npos);
  EXPECT_TRUE(journal.add(3, "3,y").empty());
  EXPECT_EQ(text(), before);
}

TEST_F(JournalFile, TornAtAnyByteKeepsTheWholeLinesAndGoesOn) {
  add(sweep_, {0, 1, 2});
  const std::string whole = text();
  std::size_t lines = 0;
  for (std::size_t length = 0; length <= whole.size(); ++length) {
    if (length > 0 && whole[length - 1] == '\n') ++lines;
    writeTo(path_, whole.substr(0, length));
    EXPECT_EQ(opened(sweep_).rows().size(), lines > 0 ? lines - 1 : 0) << length << " bytes";
    add(sweep_, {5});
    const Journal journal = opened(sweep_);
    EXPECT_EQ(journal.rows().size(), lines > 0 ? lines : 1) << length << " bytes";
    EXPECT_EQ(journal.rows().at(5), rowOf(sweep_, 5).value());
  }
  EXPECT_EQ(lines, 4U);
}

TEST_F(JournalFile, ABitThatFlippedCostsItsLineAlone) {
  add(sweep_, {0, 1, 2});
  const std::string whole = text();
  const std::size_t first = whole.find('\n') + 1;
  for (std::size_t at = first; at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x04);
    writeTo(path_, damaged);
    const Journal journal = opened(sweep_);
    // The end of a line that is none joins two; the last one's makes it a torn one.
    EXPECT_EQ(journal.rows().size(), whole[at] != '\n' || at + 1 == whole.size() ? 2U : 1U) << at;
    for (const auto& [cell, row] : journal.rows()) EXPECT_EQ(row, rowOf(sweep_, cell).value());
  }
}

TEST_F(JournalFile, RefusesTheJournalOfAnotherSweepAndLeavesItUnchanged) {
  add(someSweep({}, 2), {0, 1});
  const std::string before = text();
  EXPECT_EQ(refusal(sweep_), std::string("This journal is of another sweep (kind some, seed 2, version ") + kVersion +
                                 "), or of another build, other options or files. Choose "
                                 "another --out, or remove the journal, which discards its cells.");
  EXPECT_EQ(text(), before);
  EXPECT_EQ(opened(someSweep({}, 2)).rows().size(), 2U);
}

TEST_F(JournalFile, WithLinesOfAnotherSweepLeavesThemOut) {
  const Sweep other = someSweep({{"content", {"0124"}}});
  add(other, {0, 1});
  const std::string others = text();
  std::filesystem::remove(path_);
  add(sweep_, {2});
  writeTo(path_, text() + others.substr(others.find('\n') + 1));
  EXPECT_EQ(opened(sweep_).rows().size(), 1U);
}

TEST_F(JournalFile, RefusesAForeignFileAndLeavesItUnchanged) {
  writeTo(path_, "my notes\nand more\n");
  EXPECT_NE(refusal(sweep_).find("an unknown sweep"), std::string::npos);
  EXPECT_EQ(text(), "my notes\nand more\n");
}

TEST_F(JournalFile, WithoutAWholeLineIsRefusedUnlessItBeganAsOurs) {
  writeTo(path_, "my only note");
  EXPECT_NE(refusal(sweep_).find("an unknown sweep"), std::string::npos);
  EXPECT_EQ(text(), "my only note");
}

TEST_F(JournalFile, LeavesOutCellsThatTheSweepDoesNotHave) {
  Journal journal = opened(sweep_);
  EXPECT_TRUE(journal.add(20, "20,x").empty());
  EXPECT_TRUE(journal.add(19, "19,x").empty());
  Journal moved = std::move(journal);
  { const Journal closed = std::move(moved); }
  EXPECT_EQ(opened(sweep_).rows().count(20), 0U);
  EXPECT_EQ(opened(sweep_).rows().count(19), 1U);
}

TEST_F(JournalFile, IsWrittenByOneProgramAtATime) {
  {
    const Journal journal = opened(sweep_);
    EXPECT_NE(refusal(sweep_).find("Another underact-sweep"), std::string::npos);
  }
  opened(sweep_);
}

TEST_F(JournalFile, NamesTheReasonThatItCannotBeOpened) {
  result_ = "/dev/null/r.csv";
  EXPECT_NE(refusal(sweep_).find("Not a directory"), std::string::npos);
}

TEST_F(JournalFile, OnAFullDiskSaysSoAndKeepsWhatItHas) {
  {
    const SmallFiles small(300);
    Journal journal = opened(sweep_);
    Problems problems;
    for (std::size_t cell = 0; cell < 20 && problems.empty(); ++cell)
      problems = journal.add(cell, rowOf(sweep_, cell).value());
    ASSERT_FALSE(problems.empty());
    EXPECT_NE(problems.front().sentence.find("cannot be extended"), std::string::npos);
  }
  const std::size_t kept = opened(sweep_).rows().size();
  EXPECT_GT(kept, 0U);
  EXPECT_LT(kept, 20U);
  add(sweep_, {19});
  EXPECT_EQ(opened(sweep_).rows().size(), kept + 1);
}

TEST_F(JournalFile, IsGoneWhenTheResultIsWritten) {
  Journal journal = opened(sweep_);
  journal.remove();
  EXPECT_FALSE(std::filesystem::exists(path_));
}

TEST_F(JournalFile, ResultIsTheHeaderAndTheRowsInOrder) {
  Rows rows;
  for (std::size_t cell = 20; cell-- > 0;) rows[cell] = rowOf(sweep_, cell).value();
  EXPECT_FALSE(isThere(sweep_, result_).value());
  EXPECT_TRUE(writeResult(sweep_, rows, result_).empty());
  EXPECT_EQ(textOf(result_), sweep_.header + test::allRows(sweep_));
  EXPECT_TRUE(isThere(sweep_, result_).value());
  EXPECT_FALSE(isThere(someSweep({}, 2), result_)) << "of another sweep, it is not overwritten";
  writeTo(result_, sweep_.header + rows[0] + "\n");
  EXPECT_FALSE(isThere(sweep_, result_)) << "somebody has taken rows out of it";
  EXPECT_FALSE(isThere(sweep_, folder_.file("")));
  EXPECT_FALSE(isThere(sweep_, "/dev/null"));
}

TEST_F(JournalFile, ResultThatFindsNoRoomLeavesNothing) {
  const SmallFiles small(300);
  Rows rows;
  for (std::size_t cell = 0; cell < 20; ++cell) rows[cell] = rowOf(sweep_, cell).value();
  const Problems problems = writeResult(sweep_, rows, result_);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_NE(problems.front().sentence.find("File too large"), std::string::npos);
  EXPECT_TRUE(std::filesystem::is_empty(folder_.file("")));
}

}  // namespace
}  // namespace underact::sweep
