#include "core/sweep/lead.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <deque>
#include <memory>
#include <mutex>
#include <thread>

#include "core/sweep/messages.h"
#include "tests/core/sweep/some_sweep.h"

namespace underact::sweep {
namespace {

using test::cellsRun;
using test::someSweep;

/// Ranks that are threads of this process.
class Post {
 public:
  explicit Post(int size) : boxes_(static_cast<std::size_t>(size)) {}
  int size() const { return static_cast<int>(boxes_.size()); }
  void put(int to, Message message) {
    const std::lock_guard lock(mutex_);
    boxes_[static_cast<std::size_t>(to)].push_back(std::move(message));
  }
  std::optional<Message> get(int rank) {
    const std::lock_guard lock(mutex_);
    std::deque<Message>& box = boxes_[static_cast<std::size_t>(rank)];
    if (box.empty()) return {};
    Message message = std::move(box.front());
    box.pop_front();
    return message;
  }

 private:
  std::mutex mutex_;
  std::vector<std::deque<Message>> boxes_;
};

class ThreadTeam final : public Team {
 public:
  ThreadTeam(Post& post, int rank) : post_(post), rank_(rank) {}
  int rank() const override { return rank_; }
  int size() const override { return post_.size(); }
  void send(int to, const std::string& text) override { post_.put(to, {rank_, text}); }
  std::optional<Message> receive() override { return post_.get(rank_); }

 private:
  Post& post_;
  int rank_;
};

/// A sweep on so many ranks of so many threads; made: of the other ranks, by default the leader's own.
class Ranks {
 public:
  explicit Ranks(int size, int threads = 1) : post_(size), threads_(threads) {}
  ~Ranks() {
    for (std::thread& rank : ranks_) rank.join();
  }
  Outcome lead(const Sweep& sweep, Journal& journal, const Watcher& watcher = {}) {
    for (int rank = 1; rank < post_.size(); ++rank) start(rank, sweep);
    return leadAlone(sweep, journal, watcher);
  }
  Outcome leadAlone(const Sweep& sweep, Journal& journal, const Watcher& watcher = {}) {
    ThreadTeam team(post_, 0);
    return sweep::lead(sweep, journal, &team, threads_, watcher);
  }
  void start(
      int rank, const Result<Sweep>& sweep, std::function<bool()> interrupted = [] { return false; }) {
    ranks_.emplace_back([this, rank, sweep, interrupted = std::move(interrupted)] {
      ThreadTeam team(post_, rank);
      follow(sweep, team, threads_, interrupted);
    });
  }
  Post& post() { return post_; }

 private:
  Post post_;
  int threads_;
  std::vector<std::thread> ranks_;
};

class Led : public testing::Test {
 protected:
  void SetUp() override { cellsRun(); }
  Journal journal(const Sweep& sweep) const { return Journal::open(sweep, folder_.file("r.csv")).value(); }
  static std::string rowsOf(const Journal& journal) {
    std::string rows;
    for (const auto& [cell, row] : journal.rows()) rows += row + "\n";
    return rows;
  }
  test::SweepFolder folder_;
};

TEST_F(Led, GivesTheSameRowsOnAnyNumberOfRanksAndThreadsEachCellOnce) {
  const Sweep sweep = someSweep({{"cells", {"300"}}});
  const std::string expected = test::allRows(sweep);
  for (const auto& [size, threads] : std::vector<std::pair<int, int>>{{1, 1}, {1, 4}, {2, 1}, {4, 1}, {3, 3}}) {
    cellsRun();
    Journal kept = journal(sweep);
    Ranks ranks(size, threads);
    const Outcome outcome = size == 1 ? lead(sweep, kept, nullptr, threads, {}) : ranks.lead(sweep, kept);
    EXPECT_TRUE(outcome.problems.empty());
    EXPECT_FALSE(outcome.interrupted);
    EXPECT_EQ(rowsOf(kept), expected) << size << " ranks, " << threads << " threads";
    EXPECT_EQ(cellsRun(), 300);
    kept.remove();
  }
}

TEST_F(Led, SharesTheCellsAmongTheRanks) {
  const Sweep sweep = someSweep({{"cells", {"300"}}, {"wait_us", {"5000"}}});
  Sweep others = sweep;
  const auto ran_there = std::make_shared<std::atomic<int>>(0);
  others.cells.run = [run = sweep.cells.run, ran_there](std::size_t index, std::uint64_t seed) {
    ++*ran_there;
    return run(index, seed);
  };
  Journal kept = journal(sweep);
  Ranks ranks(3);
  ranks.start(1, others);
  ranks.start(2, others);
  EXPECT_TRUE(ranks.leadAlone(sweep, kept).problems.empty());
  // 200 in the mean; a machine that is busy may take a rank away for a while.
  EXPECT_GE(ran_there->load(), 10);
  EXPECT_LE(ran_there->load(), 290);
}

TEST_F(Led, GoesOnWithWhatIsMissingAndRunsNothingTwice) {
  const Sweep sweep = someSweep();
  {
    Journal kept = journal(sweep);
    for (const std::size_t cell : {0U, 5U, 19U}) EXPECT_TRUE(kept.add(cell, rowOf(sweep, cell).value()).empty());
  }
  cellsRun();
  Journal kept = journal(sweep);
  Ranks ranks(2);
  EXPECT_TRUE(ranks.lead(sweep, kept).problems.empty());
  EXPECT_EQ(cellsRun(), 17);
  EXPECT_EQ(rowsOf(kept), test::allRows(sweep));
}

TEST_F(Led, EndsWhenACellFailsAndKeepsTheOthers) {
  for (const char* option : {"bad", "thrown", "short"}) {
    const Sweep sweep = someSweep({{option, {"7"}}, {"cells", {"4000"}}, {"wait_us", {"300"}}});
    Journal kept = journal(sweep);
    Ranks ranks(3);
    const Outcome outcome = ranks.lead(sweep, kept);
    ASSERT_EQ(outcome.problems.size(), 1U);
    EXPECT_NE(outcome.problems.front().sentence.find("Cell 7: "), std::string::npos);
    EXPECT_GE(kept.rows().size(), 1U);
    EXPECT_LT(kept.rows().size(), 3999U);
    kept.remove();
  }
}

TEST_F(Led, EndsWhenACellFailsOnAnotherRank) {
  const Sweep sweep = someSweep({{"cells", {"3000"}}, {"wait_us", {"3000"}}});
  Sweep bad = sweep;
  bad.cells.run = [](std::size_t, std::uint64_t) -> Result<SweepRow> { return Problems{{"It is bad here."}}; };
  Journal kept = journal(sweep);
  Ranks ranks(2);
  ranks.start(1, bad);
  const Outcome outcome = ranks.leadAlone(sweep, kept);
  ASSERT_EQ(outcome.problems.size(), 1U);
  EXPECT_TRUE(outcome.problems.front().sentence.starts_with("Rank 1: Cell ")) << outcome.problems.front().sentence;
  EXPECT_LT(kept.rows().size(), 2999U);
}

TEST_F(Led, EndsWhenARankCannotMakeTheSweep) {
  const Sweep sweep = someSweep({{"cells", {"3000"}}, {"wait_us", {"3000"}}});
  Journal kept = journal(sweep);
  Ranks ranks(2);
  ranks.start(1, Problems{{"The file cannot be opened.", {"a.json", 0, 0, {}}}});
  const Outcome outcome = ranks.leadAlone(sweep, kept);
  ASSERT_EQ(outcome.problems.size(), 1U);
  EXPECT_EQ(outcome.problems.front().sentence, "Rank 1: a.json: error: The file cannot be opened.");
}

TEST_F(Led, EndsWhenARankHasAnotherSweep) {
  const Sweep sweep = someSweep({{"cells", {"3000"}}, {"wait_us", {"3000"}}}),
              other = someSweep({{"cells", {"3000"}}, {"wait_us", {"3001"}}});
  Journal kept = journal(sweep);
  Ranks ranks(2);
  ranks.start(1, other);
  const Outcome outcome = ranks.leadAlone(sweep, kept);
  ASSERT_EQ(outcome.problems.size(), 1U);
  EXPECT_NE(outcome.problems.front().sentence.find("another build"), std::string::npos);
}

TEST_F(Led, EndsWhenALetterIsNone) {
  const Sweep sweep = someSweep({{"cells", {"3000"}}, {"wait_us", {"3000"}}});
  Journal kept = journal(sweep);
  Ranks ranks(2);
  ranks.post().put(0, {1, "nonsense"});
  ranks.post().put(0, {1, write(Report{MessageKind::Trouble, "That was nonsense."})});
  const Outcome outcome = ranks.lead(sweep, kept);
  ASSERT_EQ(outcome.problems.size(), 1U) << "the first one, from which the others follow";
  EXPECT_NE(outcome.problems.front().sentence.find("not a message"), std::string::npos);
}

TEST_F(Led, EndsInOrderWhenItIsInterruptedHereOrThere) {
  const Sweep sweep = someSweep({{"cells", {"20000"}}, {"wait_us", {"500"}}});
  for (const bool here : {true, false}) {
    Journal kept = journal(sweep);
    const auto enough = std::make_shared<std::atomic<bool>>(false);
    const auto asked = [enough] { return enough->load(); };
    Watcher watcher;
    watcher.progress = [&](std::size_t done) { *enough = done >= 20; };
    if (here) watcher.interrupted = asked;
    Ranks ranks(2);
    here ? ranks.start(1, sweep) : ranks.start(1, sweep, asked);
    const Outcome outcome = ranks.leadAlone(sweep, kept, watcher);
    EXPECT_TRUE(outcome.problems.empty());
    EXPECT_TRUE(outcome.interrupted);
    EXPECT_GE(kept.rows().size(), 20U);
    EXPECT_LT(kept.rows().size(), 20'000U);
    kept.remove();
  }
}

TEST_F(Led, BeginsNoFurtherCellOnceItIsInterrupted) {
  const Sweep sweep = someSweep({{"cells", {"200"}}, {"wait_us", {"2000"}}});  // so short that some are in store
  int fewest = 200;
  for (int attempt = 0; attempt < 5; ++attempt) {  // a busy machine may take the leader away in that moment
    Journal kept = journal(sweep);
    int begun = 0;
    Watcher watcher;
    watcher.interrupted = [&begun] {
      begun += cellsRun();
      return begun >= 5;
    };
    EXPECT_TRUE(lead(sweep, kept, nullptr, 1, watcher).interrupted);
    const int later = cellsRun();
    EXPECT_EQ(kept.rows().size(), static_cast<std::size_t>(begun + later)) << "what was begun is waited for";
    fewest = std::min(fewest, later);
    kept.remove();
  }
  EXPECT_LE(fewest, 1) << "but for one that begins in that moment";
}

TEST_F(Led, EndsWhenTheJournalTakesNoMore) {
  const Sweep sweep = someSweep({{"cells", {"1000"}}, {"wait_us", {"100"}}});
  std::size_t kept_cells = 0;
  {
    const test::SmallFiles small(500);
    Journal kept = journal(sweep);
    Ranks ranks(3);
    const Outcome outcome = ranks.lead(sweep, kept);
    ASSERT_EQ(outcome.problems.size(), 1U) << "said once, however many rows come behind";
    EXPECT_NE(outcome.problems.front().sentence.find("cannot be extended"), std::string::npos);
    kept_cells = kept.rows().size();
    EXPECT_LT(cellsRun(), 1000);
  }
  EXPECT_EQ(journal(sweep).rows().size(), kept_cells);
}

TEST_F(Led, DismissesEveryRankThatHasCome) {
  Ranks ranks(3);
  ranks.start(1, someSweep());
  ranks.start(2, Problems{{"No."}});
  ThreadTeam team(ranks.post(), 0);
  dismiss(team);
  EXPECT_EQ(cellsRun(), 0);
}

TEST_F(Led, TellsHowFarItIs) {
  const Sweep sweep = someSweep();
  Journal kept = journal(sweep);
  std::size_t last = 0;
  Watcher watcher;
  watcher.progress = [&last](std::size_t done) {
    EXPECT_GE(done, last);
    last = done;
  };
  EXPECT_TRUE(lead(sweep, kept, nullptr, 2, watcher).problems.empty());
  EXPECT_EQ(last, 20U);
}

}  // namespace
}  // namespace underact::sweep
