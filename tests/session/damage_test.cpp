#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "core/record/replay.h"
#include "tests/session/rig.h"
#include "tests/support/property.h"

namespace underact::record {
namespace {

std::string bytesAt(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void write(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

/// Everything that a session says, as it was before it was damaged.
struct Truth {
  std::vector<Block> ticks;
  std::vector<ChangeRow> changes;
  std::vector<std::string> scenes;
  std::vector<Marker> markers;
  SessionInfo info;
};

Truth truthOf(const std::string& path) {
  Session session = Session::open(path).value();
  Truth truth{session.readTicks(0, session.blocks()).value(), session.changes(), {}, session.markers(), session.info()};
  for (const ChangeRow& change : session.changes()) truth.scenes.push_back(session.sceneText(change).value());
  return truth;
}

/// What a reader is told of a damaged file is an error, or right.
struct Seen {
  int refused = 0, partial = 0, whole = 0;
  int around = 0;  // of the partial ones: all is read but what is between two good blocks, or behind the last
};

void look(const std::string& path, const Truth& truth, Seen& seen) {
  Result<Session> opened = Session::open(path);
  if (!opened) {
    ++seen.refused;
    EXPECT_GT(opened.problems().front().sentence.size(), 20U);
    return;
  }
  Session& session = opened.value();
  const SessionInfo& info = session.info();
  EXPECT_EQ(info.header.rate_hz, truth.info.header.rate_hz);
  EXPECT_EQ(info.header.words.name, truth.info.header.words.name);
  EXPECT_EQ(info.header.started_unix_ns, truth.info.header.started_unix_ns);
  EXPECT_LE(info.ticks, truth.info.ticks);
  bool partial = info.ticks < truth.info.ticks || !info.damage.empty() || !info.isComplete();
  int blocks = 0, gaps = 0;
  const Problems problems = session.eachBlock(
      [&](const Block& block, std::int64_t first_row) {
        ++blocks;
        const Block& right = truth.ticks[static_cast<std::size_t>(first_row / session.blockRows())];
        EXPECT_TRUE(block.rows == right.rows && block.bytes == right.bytes) << "a wrong number, unnoticed";
        return true;
      },
      [&](const Gap&) {
        partial = true;
        ++gaps;
      });
  if (problems.empty() && blocks > 0 && gaps == 1) ++seen.around;
  partial = partial || !problems.empty();
  for (const ChangeRow& change : session.changes()) {
    const auto right = std::find_if(truth.changes.begin(), truth.changes.end(), [&](const ChangeRow& one) {
      return one.revision == change.revision && one.tick == change.tick && one.carry == change.carry;
    });
    ASSERT_NE(right, truth.changes.end()) << "an edit that never was";
    const Result<std::string> text = session.sceneText(change);
    EXPECT_TRUE(!text || text.value() == truth.scenes[static_cast<std::size_t>(right - truth.changes.begin())]);
    partial = partial || !text;
  }
  for (const Marker& marker : session.markers()) {
    EXPECT_TRUE(marker.label == "?" || std::any_of(truth.markers.begin(), truth.markers.end(), [&](const Marker& one) {
                  return one.tick == marker.tick && one.label == marker.label;
                }));
  }
  ++(partial ? seen.partial : seen.whole);
}

}  // namespace

class Damage : public ::testing::Test {
 protected:
  void SetUp() override {
    test::recordEvents(folder_.file("s.h5"), test::sphereScene(), "probe", test::Seed{5});
    truth_ = truthOf(folder_.file("s.h5"));
    bytes_ = bytesAt(folder_.file("s.h5"));
    ASSERT_GT(truth_.changes.size(), 3U);
    ASSERT_GT(truth_.markers.size(), 0U);
  }
  test::ScratchFolder folder_;
  Truth truth_;
  std::string bytes_;
};

TEST_F(Damage, FindsEachFlippedBitThatMatters) {
  test::Random random(test::Seed{11});
  Seen seen;
  const int flips = test::sweep(400, 10'000);
  for (int flip = 0; flip < flips && !HasFailure(); ++flip) {
    std::string damaged = bytes_;
    // Half of them near the beginning, where the structure of the file is densest.
    const std::size_t at = random.below(flip % 2 == 0 ? damaged.size() : std::size_t{20'000});
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << random.below(8)));
    write(folder_.file("d.h5"), damaged);
    SCOPED_TRACE(at);
    look(folder_.file("d.h5"), truth_, seen);
  }
  std::printf("%d bits: %d refused, %d read in part, %d whole\n", flips, seen.refused, seen.partial, seen.whole);
  EXPECT_GT(seen.refused, 0);
  EXPECT_GT(seen.partial, 0);
  EXPECT_GT(seen.around, 0) << "a damaged block takes others with it";
}

TEST_F(Damage, FindsAFileThatIsCutAnywhere) {
  test::Random random(test::Seed{12});
  Seen seen, recovered;
  const int cuts = test::sweep(100, 2'000);
  for (int cut = 0; cut < cuts && !HasFailure(); ++cut) {
    const std::size_t left = random.below(bytes_.size());
    write(folder_.file("d.h5"), bytes_.substr(0, left));
    SCOPED_TRACE(left);
    look(folder_.file("d.h5"), truth_, seen);
    (void)recover(folder_.file("d.h5"));  // gives what is right or nothing, too
    look(folder_.file("d.h5"), truth_, recovered);
  }
  std::printf("%d cuts: %d refused, %d read in part, %d whole\n", cuts, seen.refused, seen.partial, seen.whole);
  EXPECT_EQ(seen.whole, 0);
}

TEST_F(Damage, FindsOverwrittenRunsOfBytes) {
  test::Random random(test::Seed{13});
  Seen seen;
  const int runs = test::sweep(100, 2'000);
  for (int run = 0; run < runs && !HasFailure(); ++run) {
    std::string damaged = bytes_;
    const std::size_t at = random.below(damaged.size()), length = 1 + random.below(5000);
    for (std::size_t index = at; index < std::min(damaged.size(), at + length); ++index) {
      damaged[index] = run % 2 == 0 ? '\0' : static_cast<char>(random.below(256));
    }
    write(folder_.file("d.h5"), damaged);
    SCOPED_TRACE(at);
    look(folder_.file("d.h5"), truth_, seen);
  }
  std::printf("%d runs: %d refused, %d read in part, %d whole\n", runs, seen.refused, seen.partial, seen.whole);
}

TEST(Session, IsToldFromOtherFiles) {
  const test::ScratchFolder folder;
  write(folder.file("empty.h5"), "");
  write(folder.file("text.h5"), "tick,time_s\n1,0.001\n");
  for (const char* name : {"empty.h5", "text.h5"}) {
    const Result<Session> session = Session::open(folder.file(name));
    ASSERT_FALSE(session) << name;
    EXPECT_EQ(session.problems().front().sentence, "This is not a session, or its beginning is damaged.");
  }
  EXPECT_EQ(Session::open(folder.file("none.h5")).problems().front().sentence, "There is no such file.");
  ASSERT_TRUE(Hdf5File::create(folder.file("other.h5"), {}, {}));
  EXPECT_NE(Session::open(folder.file("other.h5")).problems().front().sentence.find("no table \"ticks\""),
            std::string::npos);
}

}  // namespace underact::record
