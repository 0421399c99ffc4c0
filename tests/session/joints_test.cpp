// Sessions with an arm of more than six joints: what is recorded of them, read, replayed and exported.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <memory>

#include "core/arm/forward.h"
#include "core/record/csv.h"
#include "core/record/replay.h"
#include "core/scene/scene_arm.h"
#include "device/simulated_arm.h"
#include "tests/session/rig.h"

namespace underact::record {
namespace {

scene::Description pandaScene() {
  return test::sceneAt(std::string(UNDERACT_SOURCE) + "/scenes/38_panda_wall.json");
}

/// A servo on a simulated Panda whose hand turns its last joint, and what its ticks were.
struct Rig {
  explicit Rig(const scene::Description& scene) {
    device::SimulatedArm::Options options;
    options.arm = *arm::findPreset("panda");
    options.model = *sim::findArmModel(sim::kDefaultArmModel);
    auto made = std::make_unique<device::SimulatedArm>(options);
    hand = made.get();
    host = std::make_unique<servo::Host>(std::move(made), servo::HostOptions{.clock = servo::Clock::Manual});
    EXPECT_TRUE(host->load(scene).empty());
    host->start();
  }
  void turn(double last_rad) {
    arm::JointAngles q = arm::findPreset("panda")->geometry.mechanism->rest;
    q[6] = last_rad;
    const Pose X_WT = arm::tipPose(arm::findPreset("panda")->geometry, q);
    hand->setSetpoint({X_WT.translation(), Vec3::Zero(), X_WT.linear(), true, true, q});
  }
  void run(std::int64_t ticks) {
    host->run(ticks);
    host->drain([this](const servo::TickRecord& record) { seen.push_back(record); });
  }
  device::SimulatedArm* hand = nullptr;
  std::unique_ptr<servo::Host> host;
  std::vector<servo::TickRecord> seen;
};

std::vector<servo::TickRecord> ticksOf(Session& session) {
  std::vector<servo::TickRecord> all;
  EXPECT_TRUE(session
                  .eachBlock(
                      [&](const Block& block, std::int64_t) {
                        for (const servo::TickRecord& record : unpackTicks(block)) all.push_back(record);
                        return true;
                      },
                      [](const Gap&) {})
                  .empty());
  return all;
}

void expectSameJoints(const std::vector<servo::TickRecord>& got, const std::vector<servo::TickRecord>& seen) {
  ASSERT_FALSE(got.empty());
  std::size_t next = 0;
  for (const servo::TickRecord& record : got) {
    while (next < seen.size() && seen[next].tick < record.tick) ++next;
    ASSERT_LT(next, seen.size());
    ASSERT_EQ(record.q_rad, seen[next].q_rad) << "tick " << record.tick;
  }
}

}  // namespace

TEST(SevenJoints, AreRecordedReplayedAndExported) {
  const test::ScratchFolder folder;
  Rig rig(pandaScene());
  rig.run(137);
  {
    const auto recorder = Recorder::start(*rig.host, folder.file("s.h5"), {});
    ASSERT_TRUE(recorder);
    rig.turn(2.0);
    for (int part = 0; part < 5; ++part) rig.run(391);
    ASSERT_TRUE(recorder.value()->stop().empty());
  }
  Session session = Session::open(folder.file("s.h5")).value();
  EXPECT_TRUE(session.hasMoreJoints());
  EXPECT_EQ(session.rows(kJoints), session.info().ticks);
  const std::vector<servo::TickRecord> got = ticksOf(session);
  expectSameJoints(got, rig.seen);
  EXPECT_GT(got.back().q_rad[6], got.front().q_rad[6] + 0.5) << "the last joint turned";
  const Verified verified = verifyReplay(session).value();
  EXPECT_FALSE(verified.differs.has_value()) << verified.differs->column;
  EXPECT_EQ(verified.ticks, session.info().ticks);
  CsvWriter csv = CsvWriter::create(folder.file("s.csv"), system::Existing::ReplaceFile).value();
  EXPECT_TRUE(exportCsv(session, csv, [](double) { return true; }).isWhole());
  std::ifstream file(folder.file("s.csv"));
  std::string header, first;
  std::getline(file, header);
  std::getline(file, first);
  EXPECT_TRUE(header.ends_with(",passive_N,q7_rad,q8_rad")) << header;
  const std::string ends = first.substr(first.rfind(',', first.rfind(',') - 1) + 1);
  EXPECT_EQ(std::stod(ends), got.front().q_rad[6]);
}

TEST(SevenJoints, ComeInTheMidstOfARecordingOfSix) {
  const test::ScratchFolder folder;
  Rig rig(test::sceneAt(std::string(UNDERACT_SOURCE) + "/scenes/30_ur5e_table.json"));
  {
    const auto recorder = Recorder::start(*rig.host, folder.file("s.h5"), {});
    ASSERT_TRUE(recorder);
    rig.run(1234);
    ASSERT_TRUE(rig.host->load(pandaScene()).empty());
    rig.turn(1.5);
    rig.run(1500);
    ASSERT_TRUE(rig.host->load(test::sphereScene()).empty());
    rig.run(400);
    ASSERT_TRUE(recorder.value()->stop().empty());
  }
  Session session = Session::open(folder.file("s.h5")).value();
  ASSERT_TRUE(session.hasMoreJoints());
  EXPECT_LT(session.rows(kJoints), session.info().ticks);
  EXPECT_GT(session.rows(kJoints), 1800);
  const std::vector<servo::TickRecord> got = ticksOf(session);
  ASSERT_EQ(static_cast<std::int64_t>(got.size()), session.info().ticks);
  for (const servo::TickRecord& record : got) {
    for (const double angle_rad : record.q_rad) ASSERT_TRUE(std::isfinite(angle_rad)) << record.tick;
  }
  const Verified verified = verifyReplay(session).value();
  EXPECT_FALSE(verified.differs.has_value()) << verified.differs->tick << " " << verified.differs->column;
}

TEST(SevenJoints, ASixJointArmHasNoneOfItsColumns) {
  const test::ScratchFolder folder;
  test::recordEvents(folder.file("s.h5"), test::sphereScene(), "probe", test::Seed{5});
  Session session = Session::open(folder.file("s.h5")).value();
  EXPECT_FALSE(session.hasMoreJoints());
  EXPECT_EQ(session.rows(kJoints), 0);
  EXPECT_FALSE(hasMoreJoints(session.readTicks(0, 1).value().front()));
}

TEST(SevenJoints, DamagedOnesAreNoNumbers) {
  const test::ScratchFolder folder;
  Rig rig(pandaScene());
  {
    const auto recorder = Recorder::start(*rig.host, folder.file("s.h5"), {});
    ASSERT_TRUE(recorder);
    rig.turn(1.234567890123);
    rig.run(2000);
    ASSERT_TRUE(recorder.value()->stop().empty());
  }
  const double last_rad =
      ticksOf(*std::make_unique<Session>(Session::open(folder.file("s.h5")).value())).back().q_rad[6];
  {  // the bytes of one number of the last block
    std::fstream file(folder.file("s.h5"), std::ios::in | std::ios::out | std::ios::binary);
    std::string bytes((std::istreambuf_iterator<char>(file)), {});
    std::string number(sizeof last_rad, '\0');
    std::memcpy(number.data(), &last_rad, sizeof last_rad);
    const std::size_t at = bytes.rfind(number);
    ASSERT_NE(at, std::string::npos);
    file.seekp(static_cast<std::streamoff>(at));
    file.put(static_cast<char>(bytes[at] ^ 1));
  }
  Session session = Session::open(folder.file("s.h5")).value();
  const std::vector<servo::TickRecord> got = ticksOf(session);
  EXPECT_TRUE(std::isnan(got.back().q_rad[6]));
  EXPECT_TRUE(std::isfinite(got.front().q_rad[6]));
}

}  // namespace underact::record
