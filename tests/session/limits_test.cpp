// What a session may hold at most: the recorder goes on in another file before a limit, and loses no tick between them.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "core/record/replay.h"
#include "tests/session/rig.h"
#include "tests/support/property.h"

namespace underact::record {
namespace {

/// A running servo without a thread of its own, and a recorder that keeps up with it.
class Recorded {
 public:
  Recorded(const std::string& path, const SessionLimits& limits)
      : host_(test::makeHost(servo::Clock::Manual, "probe")) {
    EXPECT_TRUE(host_->load(test::sphereScene()).empty());
    host_->start();
    recorder_ = Recorder::start(*host_, path, {}, {.clock_every_s = 1e-3, .limits = limits}).value();
  }
  servo::Host& host() { return *host_; }
  Recorder& recorder() { return *recorder_; }
  void run(std::int64_t ticks, bool waits = true) {
    host_->run(ticks);
    ticks_ += ticks;
    while (waits && recorder_->status().ticks < ticks_ && recorder_->status().recording)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }

 private:
  std::unique_ptr<servo::Host> host_;
  std::unique_ptr<Recorder> recorder_;
  std::int64_t ticks_ = 0;
};

struct Read {
  std::int64_t ticks = 0;
  std::size_t markers = 0, pushes = 0;
  std::vector<std::string> words;  // of the sessions, and of those that they continue
};

/// Each part is whole, replays to the bit, and begins with the tick after the last one of the part before.
Read readParts(const std::vector<std::string>& files) {
  Read all;
  std::int64_t next = 0;
  for (const std::string& file : files) {
    Result<Session> session = Session::open(file);
    EXPECT_TRUE(session) << file;
    if (!session) break;
    const SessionInfo& info = session.value().info();
    EXPECT_TRUE(info.damage.empty() && info.isComplete()) << file;
    EXPECT_EQ(info.dropped, 0);
    const Result<Verified> verified = verifyReplay(session.value());
    EXPECT_TRUE(verified && !verified.value().differs && verified.value().unknown.empty()) << file;
    if (verified) EXPECT_EQ(verified.value().ticks, info.ticks) << file;
    const std::int64_t first = session.value().changes().front().tick;
    if (all.ticks > 0) EXPECT_EQ(first, next) << file;
    next = info.end->tick + 1;
    EXPECT_EQ(next - first, info.ticks) << file;
    all.ticks += info.ticks;
    all.markers += session.value().markers().size();
    all.pushes += session.value().pushes().size();
    const json::Value run = session.value().provenanceOf(session.value().provenance().front()).value();
    all.words.push_back(run.find("session")->text);
    EXPECT_EQ(all.words.back(), info.header.session_id);
    if (file != files.front()) EXPECT_EQ(run.find("continues")->text, all.words[all.words.size() - 2]);
  }
  return all;
}

}  // namespace

TEST(Limits, OfMarkersAndTheirLabelsAreTheSameForWriterAndReader) {
  const test::ScratchFolder folder;
  const SessionLimits& max = kSessionLimits;
  for (const auto& [label, count] : {std::pair{std::string(), max.markers},
                                     {std::string(max.label_bytes, 'x'), max.all_label_bytes / max.label_bytes}}) {
    const std::string path = folder.file("s" + std::to_string(label.size()) + ".h5");
    Result<SessionWriter> writer = SessionWriter::create(path, {});
    ASSERT_TRUE(writer && writer.value().begin(0, 0, {}, test::sphereScene()).empty());
    std::int64_t taken = 0;
    while (writer.value().mark(1, label).empty()) ++taken;
    EXPECT_EQ(taken, count);
    EXPECT_TRUE(writer.value().isAtLimit());
    EXPECT_TRUE(writer.value().end({}).empty());
    const Result<Session> session = Session::open(path);
    ASSERT_TRUE(session);
    EXPECT_TRUE(session.value().info().damage.empty());
    EXPECT_EQ(std::ssize(session.value().markers()), count);
    EXPECT_EQ(session.value().markers().back().label, label);
  }
}

TEST(Limits, OfAnyTableLetTheRecordingGoOnInAnotherFileAndNoneThatIsThereIsTouched) {
  const std::vector<std::pair<const char*, SessionLimits>> all{{"steering, changes, clock", {.small_rows = 200}},
                                                               {"ticks", {.ticks = 400}},
                                                               {"markers", {.markers = 40}},
                                                               {"labels", {.all_label_bytes = 600}}};
  for (const auto& [what, limits] : all) {
    SCOPED_TRACE(what);
    const test::ScratchFolder folder;
    const std::string taken = folder.write("s_2.underact.h5", "mine");
    Recorded recorded(folder.file("s.underact.h5"), limits);
    test::Random random(test::Seed{50});
    for (int step = 0; step < 60; ++step) {
      for (int tick = 0; tick < 20; ++tick) {
        recorded.host().push(Vec3(0.2 * random.between(-1.0, 1.0), 0.1, 0.0),
                             1 + static_cast<std::int64_t>(random.below(8)));
        recorded.run(1, false);
      }
      scene::Description edited = recorded.host().scene();
      edited.control.gains.kp_N_per_mm.setConstant(0.02 + 0.001 * step);
      EXPECT_TRUE(recorded.host().edit(edited).empty());
      recorded.recorder().mark("a label of 20 letters");
      recorded.run(1);
    }
    const Problems problems = recorded.recorder().stop();
    EXPECT_TRUE(problems.empty()) << problems.front().sentence;
    const RecorderStatus status = recorded.recorder().status();
    ASSERT_GT(status.files.size(), 1U);
    EXPECT_EQ(status.files[1], folder.file("s_3.underact.h5"));
    EXPECT_EQ(std::filesystem::file_size(taken), 4U);
    const Read read = readParts(status.files);
    EXPECT_EQ(read.ticks, 60 * 21);
    EXPECT_EQ(status.ticks, read.ticks);
    EXPECT_EQ(read.markers, 60U);
    const std::vector<Sentence> news = newsOf({}, status);
    ASSERT_EQ(news.size(), status.files.size() - 1);
    EXPECT_NE(news.front().find("goes on in " + status.files[1]), std::string::npos) << news.front();
  }
}

TEST(Limits, HoldMarkersBackUntilTheNextFileAndSayWhereNoTickCameAnyMore) {
  const test::ScratchFolder folder;
  Recorded recorded(folder.file("s.h5"), {.markers = 40});
  recorded.run(100);
  for (int mark = 0; mark < 70; ++mark) recorded.recorder().mark("m");
  recorded.run(100);
  recorded.run(100);
  for (int mark = 0; mark < 70; ++mark) recorded.recorder().mark("m");
  const Problems problems = recorded.recorder().stop();
  const Read read = readParts(recorded.recorder().status().files);
  EXPECT_EQ(read.ticks, 300);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems.front().sentence, std::to_string(140 - read.markers) +
                                           " markers are missing: the recording has as many as a session may have.");
  EXPECT_GE(read.markers, 80U);
}

TEST(Limits, OfANextFileThatCannotBeMadeEndTheRecordingInOrderWithASentence) {
  const test::ScratchFolder folder;
  const std::string path = folder.file(std::string(252, 'a') + ".h5");  // no longer name is possible
  Recorded recorded(path, {.ticks = 400});
  for (int step = 0; step < 40; ++step) recorded.run(20);
  EXPECT_FALSE(recorded.recorder().status().recording);
  const Problems problems = recorded.recorder().stop();
  ASSERT_FALSE(problems.empty());
  EXPECT_NE(problems.front().sentence.find("File name too long"), std::string::npos) << problems.front().sentence;
  EXPECT_GT(readParts({path}).ticks, 300);
}

TEST(Steering, AForceThatIsSentAgainUnchangedTakesARowOnlyWhereItBeginsAndEnds) {
  const test::ScratchFolder folder;
  Recorded recorded(folder.file("s.h5"), {});
  recorded.run(50);
  for (int tick = 0; tick < 400; ++tick) {
    recorded.host().push(Vec3(0.1, -0.2, 0.05), 50);
    recorded.host().push(Vec3(0.1, -0.2, 0.05), 50);  // twice between two ticks
    recorded.host().run(1);
  }
  recorded.host().run(100);
  EXPECT_TRUE(recorded.recorder().stop().empty());
  const Read read = readParts({folder.file("s.h5")});
  EXPECT_EQ(read.ticks, 550);
  EXPECT_EQ(read.pushes, 3U);
}

TEST(Steering, ForcesThatChangeEndAndOverlapReplayToTheBit) {
  const test::ScratchFolder folder;
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(test::sweep(6, 200)); ++seed) {
    Recorded recorded(folder.file(std::to_string(seed) + ".h5"), {});
    test::Random random(test::Seed{seed});
    std::size_t asked = 0;
    for (int step = 0; step < 300; ++step) {
      for (std::size_t times = random.below(3); times > 0; --times, ++asked)
        recorded.host().push(Vec3(random.below(4) == 0 ? 0.2 : 0.1, 0.0, random.below(5) == 0 ? -0.1 : 0.0),
                             static_cast<std::int64_t>(random.below(7)));
      recorded.host().run(static_cast<std::int64_t>(random.below(5)));
    }
    EXPECT_TRUE(recorded.recorder().stop().empty());
    EXPECT_LT(readParts({folder.file(std::to_string(seed) + ".h5")}).pushes, asked) << seed;
  }
}

TEST(Recorder, SaysOnceThatItLostTicksOrEnded) {
  RecorderStatus status, ended;
  status.dropped = ended.dropped = 7;
  ended.recording = false;
  ended.problems = {{"The disk is full.", {}}};
  EXPECT_EQ(newsOf({}, status).size(), 1U);
  EXPECT_TRUE(newsOf(status, status).empty());
  EXPECT_EQ(newsOf(status, ended), std::vector<Sentence>{"The disk is full."});
}

}  // namespace underact::record
