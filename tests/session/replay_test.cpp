#include "core/record/replay.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <thread>

#include "core/record/laws.h"
#include "core/scene/edit.h"
#include "tests/session/rig.h"
#include "tests/support/property.h"

namespace underact::record {
namespace {

using test::Seed;

std::string explain(const Verified& verified) {
  if (verified.differs) return "tick " + std::to_string(verified.differs->tick) + ", " + verified.differs->column;
  return verified.unknown;
}

void expectIdentical(const std::string& path, const std::string& what) {
  Result<Session> session = Session::open(path);
  ASSERT_TRUE(session) << session.problems().front().sentence;
  // A session does not say where its meshes are; those of the scenes that ship are here.
  const Result<Verified> verified = verifyReplay(session.value(), {}, {UNDERACT_SOURCE "/scenes"});
  ASSERT_TRUE(verified) << what << ": " << verified.problems().front().sentence;
  EXPECT_FALSE(verified.value().differs.has_value()) << what << ": " << explain(verified.value());
  EXPECT_EQ(verified.value().unknown, "") << what;
  EXPECT_EQ(verified.value().ticks, session.value().info().ticks) << what;
  EXPECT_GT(verified.value().ticks, 300) << what;
}

}  // namespace

TEST(Replay, OfEveryShippedSceneIsTheSameToTheBitFromTheMidstOnAndThroughEdits) {
  const test::ScratchFolder folder;
  std::size_t edits = 0;
  for (const std::string& path : test::shippedScenes()) {
    for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(test::sweep(1, 20)); ++seed) {
      const char* const hand = seed % 2 == 1 ? "probe" : "tremor";
      test::recordEvents(folder.file("s.h5"), test::sceneAt(path), hand, Seed{seed});
      expectIdentical(folder.file("s.h5"), path + " seed " + std::to_string(seed));
      edits += Session::open(folder.file("s.h5")).value().changes().size() - 1;
    }
  }
  EXPECT_GT(edits, 3 * test::shippedScenes().size());
}

// Made by version 0.1.0 before sliding was mended: it slips, and stuck again after each slip.
TEST(Replay, OfASessionFromBeforeALawWasMendedNamesTheLawAndCountsTheTicks) {
  Result<Session> session = Session::open(UNDERACT_TEST_DATA "/golden/session_friction_1.h5");
  ASSERT_TRUE(session) << session.problems().front().sentence;
  const Result<Verified> verified = verifyReplay(session.value());
  ASSERT_TRUE(verified);
  EXPECT_EQ(verified.value().mended, std::vector<std::string>{"friction"});
  ASSERT_TRUE(verified.value().differs);
  EXPECT_EQ(verified.value().differs->tick, 226);  // the first slip
  EXPECT_EQ(verified.value().ticks, 225);
  EXPECT_EQ(verified.value().different_ticks, 225);
  // Made again it names the law of today, and is the same to the bit.
  const test::ScratchFolder folder;
  ASSERT_TRUE(rerunFromInput(session.value(), {folder.file("again.h5")}, {}));
  Result<Session> again = Session::open(folder.file("again.h5"));
  ASSERT_TRUE(again);
  EXPECT_TRUE(mendedLaws(again.value()).empty());
  expectIdentical(folder.file("again.h5"), "made again");
}

TEST(Replay, FindsTheFirstTickThatComesOutOtherwise) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("s.h5"), changed = folder.file("changed.h5");
  test::recordEvents(path, test::sphereScene(), "probe", Seed{3});
  Result<Session> session = Session::open(path);
  // The same session written again with the last bit of one force turned over: no checksum is hurt.
  Result<SessionWriter> writer = SessionWriter::create(changed, session.value().info().header);
  ASSERT_TRUE(writer);
  const ChangeRow& first = session.value().changes().front();
  const scene::Description scene = session.value().scene(first).value();
  const tick::TickProgram program = test::programOf(scene);
  ASSERT_TRUE(writer.value().begin(first.tick, first.revision, session.value().start(program).value(), scene).empty());
  for (std::size_t index = 1; index < session.value().changes().size(); ++index) {
    const ChangeRow& row = session.value().changes()[index];
    ASSERT_TRUE(writer.value()
                    .add(servo::Change{row.tick, row.revision, row.carry}, session.value().scene(row).value())
                    .empty());
  }
  std::int64_t spoiled = 0;
  ASSERT_TRUE(session.value()
                  .eachBlock(
                      [&](const Block& block, std::int64_t row) {
                        for (servo::TickRecord record : unpackTicks(block)) {
                          if (row++ == 777) {
                            spoiled = record.tick;
                            record.f_asked_T_W.y() = std::nextafter(record.f_asked_T_W.y(), 1e9);
                          }
                          EXPECT_TRUE(writer.value().add(record).empty());
                        }
                        return true;
                      },
                      [](const Gap&) {})
                  .empty());
  ASSERT_TRUE(writer.value().end({}).empty());
  Result<Session> again = Session::open(changed);
  ASSERT_TRUE(again);
  const Result<Verified> verified = verifyReplay(again.value());
  ASSERT_TRUE(verified);
  ASSERT_TRUE(verified.value().differs.has_value());
  EXPECT_EQ(verified.value().differs->column, "force_asked_N");
  EXPECT_EQ(verified.value().differs->tick, spoiled);
  EXPECT_EQ(verified.value().ticks, 777);
}

TEST(Replay, WithTheSceneAsItWasGivesTheForcesThatWereSentAndWithOthersOthers) {
  const test::ScratchFolder folder;
  const auto host = test::makeHost(servo::Clock::Manual, "probe");
  ASSERT_TRUE(host->load(test::sphereScene()).empty());
  host->start();
  {
    const auto recorder = Recorder::start(*host, folder.file("s.h5"), {});
    ASSERT_TRUE(recorder);
    host->run(3000);
    ASSERT_TRUE(recorder.value()->stop().empty());
  }
  Result<Session> session = Session::open(folder.file("s.h5"));
  const auto maxApart_N = [&](const scene::Description& scene) {
    double max_N = 0.0;
    const Problems problems = replayWith(session.value(), scene, [&](const auto& recorded, const auto& now) {
      max_N = std::max(max_N, (recorded.f_sent_T_W - now.f_sent_T_W).norm());
    });
    EXPECT_TRUE(problems.empty());
    return max_N;
  };
  EXPECT_EQ(maxApart_N(test::sphereScene()), 0.0) << "the recording began with the servo";
  scene::Description softer = test::sphereScene();
  softer.control.gains.kp_N_per_mm.setConstant(0.1);
  EXPECT_GT(maxApart_N(softer), 0.05);
}

TEST(Replay, OfAServoThatWasLimitedToLessForceIsTheSameToTheBit) {
  const test::ScratchFolder folder;
  const auto host = test::makeHost(servo::Clock::Manual, "probe");
  ASSERT_TRUE(host->setForceShare(0.2).empty());
  ASSERT_TRUE(host->load(test::sphereScene()).empty());
  host->start();
  const auto recorder = Recorder::start(*host, folder.file("s.h5"), {});
  ASSERT_TRUE(recorder);
  host->run(2000);
  ASSERT_TRUE(recorder.value()->stop().empty());
  Result<Session> session = Session::open(folder.file("s.h5"));
  const Result<Verified> verified = verifyReplay(session.value());
  ASSERT_TRUE(verified);
  EXPECT_FALSE(verified.value().differs.has_value()) << verified.value().differs->column;
  EXPECT_EQ(verified.value().ticks, 2000);
}

// Rows of the clocks stand at the beginning, in between and at the end, and go forwards together.
TEST(Clock, IsReadAtTheBeginningInBetweenAndAtTheEnd) {
  const test::ScratchFolder folder;
  const auto host = test::makeHost(servo::Clock::Thread, "probe");
  ASSERT_TRUE(host->load(test::sphereScene()).empty());
  const auto recorder = Recorder::start(*host, folder.file("s.h5"), {}, {.clock_every_s = 0.1});
  ASSERT_TRUE(recorder);
  host->begin();
  std::this_thread::sleep_for(std::chrono::milliseconds(450));
  ASSERT_TRUE(recorder.value()->stop().empty());
  Result<Session> session = Session::open(folder.file("s.h5"));
  const std::vector<ClockRow>& rows = session.value().clock();
  ASSERT_GE(rows.size(), 4U);
  for (std::size_t row = 1; row < rows.size(); ++row) {
    const std::int64_t by_tick_ns = 1'000'000 * (rows[row].tick - rows[row - 1].tick);
    EXPECT_EQ(rows[row].time_ns - rows[row - 1].time_ns, by_tick_ns);  // the simulated arm's
    EXPECT_NEAR(static_cast<double>(rows[row].monotonic_ns - rows[row - 1].monotonic_ns),
                static_cast<double>(rows[row].unix_ns - rows[row - 1].unix_ns), 1e6);
  }
  EXPECT_EQ(rows.back().tick, session.value().info().ticks);
}

TEST(Replay, OfASessionThatLacksTicksSaysWhereItEnds) {
  const test::ScratchFolder folder;
  const auto host = test::makeHost(servo::Clock::Manual, "sweep");
  ASSERT_TRUE(host->load(test::sphereScene()).empty());
  Result<SessionWriter> writer = SessionWriter::create(folder.file("s.h5"), {});
  ASSERT_TRUE(writer);
  ASSERT_TRUE(
      writer.value().begin(1, 1, tick::makeState(test::programOf(test::sphereScene())), test::sphereScene()).empty());
  host->run(500);
  host->drain([&](const servo::TickRecord& record) {
    if (record.tick == 251) return;
    EXPECT_TRUE(writer.value().add(record).empty());
  });
  ASSERT_TRUE(writer.value().end({}).empty());
  Result<Session> session = Session::open(folder.file("s.h5"));
  const Result<Verified> verified = verifyReplay(session.value());
  ASSERT_TRUE(verified);
  EXPECT_FALSE(verified.value().differs.has_value()) << verified.value().differs->column;
  EXPECT_EQ(verified.value().ticks, 250);
  EXPECT_NE(verified.value().unknown.find("1 ticks are missing after tick 250"), std::string::npos)
      << verified.value().unknown;
}

}  // namespace underact::record
