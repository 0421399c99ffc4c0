#include "device/haply/haply_arm.h"

#include <gtest/gtest.h>

#include "core/arm/forward.h"
#include "core/base/units.h"
#include "device/catalogue.h"
#include "device/haply/haply.h"
#include "tests/support/comes.h"
#include "tests/support/haply_service.h"

namespace underact::device::haply {
namespace {

using namespace std::chrono_literals;
using test::comes;
using test::HaplyService;

/// What only the gate can make: a force within 5 N, fully ramped.
safety::GatedForce gatedForHaply(const Vec3& f_T_W) {
  safety::GateState state;
  state.level = 1.0;
  return safety::gate({5.0}, state, {f_T_W, true, false, {}}, 0.001).force;
}

const Vec3 kHaplyPush_N(0.5, 0.1, -0.2);

/// A program that ticks when it is told to, and the service.
struct HaplyRig {
  explicit HaplyRig(const HaplyService::Options& options = {}) : service(options) {}
  Problems open(const std::string& id = "") {
    arm.reset();
    auto opened = HaplyArm::open({"127.0.0.1", service.port(), id}, geometry, 1000);
    if (!opened) return opened.problems();
    arm = std::move(opened).value();
    return {};
  }
  bool tick(const Vec3& f_T_W = kHaplyPush_N) {
    const bool has = arm->read(sample);
    arm->write(gatedForHaply(f_T_W));
    return has;
  }
  bool push(const Vec3& f_T_W = kHaplyPush_N) {
    return comes([&] {
      tick(f_T_W);
      return (service.force_N() - f_T_W).norm() < 1e-9;
    });
  }
  bool rests() const { return service.force_N() == Vec3::Zero(); }
  /// Is told zero by all of many ticks, once what has changed has come: a single zero is told when ticks are late, too.
  bool staysAtRest() {
    for (int ticks = 0; ticks < 100; ++ticks) {
      tick();
      std::this_thread::sleep_for(1ms);
      if (ticks >= 50 && !rests()) return false;
    }
    return true;
  }
  /// Without a sample for long; what the arm says then.
  std::string silence() {
    EXPECT_TRUE(comes([&] { return !tick(); }));
    for (int ticks = 0; ticks < 30; ++ticks) tick();
    return arm->trouble();
  }

  HaplyService service;
  arm::Geometry geometry = arm::findPreset(arm::kDefaultArm)->geometry;
  std::unique_ptr<HaplyArm> arm;
  arm::Sample sample;
};

std::string reasonOf(const Problems& problems) {
  return problems.empty() ? "" : problems.front().sentence;
}

bool has(const std::string& text, const char* words) {
  return text.find(words) != std::string::npos;
}

}  // namespace

TEST(HaplyArm, StandsAndPointsAsTheInverse3AndItsGrip) {
  HaplyRig rig;
  rig.service.placeTip(Vec3(0.03, 0.02, 0.05));
  Mat3 R_WT = Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  rig.service.turnTip(R_WT);
  ASSERT_TRUE(rig.open().empty());
  ASSERT_TRUE(comes([&] { return rig.tick(Vec3::Zero()); }));
  const Pose X_WT = arm::tipPose(rig.geometry, rig.sample.q_rad);
  EXPECT_LT((X_WT.translation() - Vec3(0.03, 0.02, 0.05)).norm(), 2e-5);
  EXPECT_LT((X_WT.linear() - R_WT).norm(), 1e-9);
  EXPECT_TRUE(has(rig.arm->info().title, "Inverse3 04C3 at 127.0.0.1:"));
  EXPECT_TRUE(rig.arm->info().untested);
  const std::vector<std::string> lines = rig.arm->listing();
  EXPECT_EQ(lines.front(), "Serial number: 04C3");
  EXPECT_EQ(lines.back(), "its own joints: -89.5, 122.25, -22.75 deg");
}

TEST(HaplyArm, WithoutAGripTheWristRestsAndNoButtonIsHeld) {
  HaplyService::Options options;
  options.has_grip = false;
  options.is_middle_origin = true;
  HaplyRig rig(options);
  rig.service.holdButton(true);
  rig.service.placeTip(Vec3(0.03, 0.02, 0.05));
  ASSERT_TRUE(rig.open().empty());
  ASSERT_TRUE(comes([&] { return rig.tick(Vec3::Zero()); }));
  EXPECT_LT((arm::tipPosition(rig.geometry, rig.sample.q_rad) - Vec3(0.03, 0.02, 0.05)).norm(), 2e-5);
  EXPECT_EQ(rig.sample.q_rad[3], 0.0);
  EXPECT_EQ(rig.sample.buttons, 0U);
}

TEST(HaplyArm, PushesInBothFormsAndNamesItsSession) {
  for (const char* const version : {"3.5.0", "3.1.4"}) {
    HaplyService::Options options;
    options.version = version;
    HaplyRig rig(options);
    ASSERT_TRUE(rig.open().empty());
    EXPECT_TRUE(rig.push()) << version << ": " << rig.service.force_N().transpose();
    EXPECT_EQ(has(rig.service.greeting(), R"("name": "underact")"), options.version == "3.5.0");
  }
  HaplyService::Options silent;
  silent.version = "3.1.0";
  silent.has_version = false;
  HaplyRig rig(silent);
  ASSERT_TRUE(rig.open().empty());
  EXPECT_TRUE(rig.push()) << "a service that does not tell its version is an old one";
}

TEST(HaplyArm, OutOfReachOfTheScenesArmItDoesNotPush) {
  HaplyRig rig;
  ASSERT_TRUE(rig.open().empty());
  ASSERT_TRUE(rig.push());
  rig.service.placeTip(Vec3(0.5, 0.0, 0.06));
  EXPECT_TRUE(rig.staysAtRest());
  rig.service.placeTip(Vec3(0.0, 0.0, 0.06));
  EXPECT_TRUE(rig.push());
}

TEST(HaplyArm, WithoutTicksItTellsZeroAndIsStillAnswered) {
  HaplyRig rig;
  ASSERT_TRUE(rig.open().empty());
  ASSERT_TRUE(rig.push());
  EXPECT_TRUE(comes([&] { return rig.rests(); }));
  std::this_thread::sleep_for(1200ms);
  EXPECT_TRUE(rig.push()) << rig.arm->trouble();
}

TEST(HaplyArm, ACutIsToldOnceAndLastsUntilTheNextForce) {
  HaplyRig rig;
  ASSERT_TRUE(rig.open().empty());
  ASSERT_TRUE(rig.push());
  rig.arm->cut();
  EXPECT_TRUE(comes([&] { return rig.rests(); }));
  const std::int64_t frames = rig.service.frames();
  const auto begin = std::chrono::steady_clock::now();
  std::this_thread::sleep_for(100ms);
  const std::int64_t more = rig.service.frames() - frames;
  const auto periods = (std::chrono::steady_clock::now() - begin) / 1ms;
  EXPECT_LE(more, periods / HaplyArm::kQuietPeriods + 2) << "no more than an arm that rests";
  EXPECT_TRUE(rig.push());
}

TEST(HaplyArm, WhereNothingListensOrSomethingElseDoesItSaysSo) {
  HaplyRig rig;
  rig.service.stop();
  EXPECT_TRUE(has(reasonOf(rig.open()), "No service of Haply answers at 127.0.0.1:"));
  rig.service.start();
  rig.service.sayInstead(R"({"event": "hello"})");
  EXPECT_TRUE(has(reasonOf(rig.open()), "does not say where an Inverse3 is"));
  rig.service.sayInstead("HTTP?");
  EXPECT_TRUE(has(reasonOf(rig.open()), "does not say where an Inverse3 is"));
  rig.service.sayInstead(std::nullopt);
  rig.service.unplugArm(true);
  EXPECT_TRUE(has(reasonOf(rig.open()), "has no Inverse3. Plug it in"));
  rig.service.unplugArm(false);
  EXPECT_TRUE(has(reasonOf(rig.open("ABCD")), "has no Inverse3 \"ABCD\". It has: 04C3."));
  EXPECT_EQ(reasonOf(rig.open("04C3")), "");
  HaplyService::Options turned;
  turned.axes = "XZY";
  HaplyRig other(turned);
  EXPECT_TRUE(has(reasonOf(other.open()), "in the axes XZY"));
}

TEST(HaplyArm, AServiceThatAnswersLateGetsZeroAndIsSaidToBeSilent) {
  HaplyRig rig;
  ASSERT_TRUE(rig.open().empty());
  ASSERT_TRUE(rig.push());
  rig.service.hold(true);
  EXPECT_TRUE(comes([&] { return !rig.arm->read(rig.sample); }));
  for (int tick = 0; tick < 30; ++tick) rig.tick();  // a tick that has no sample writes zero; this one does not
  EXPECT_TRUE(rig.rests());
  EXPECT_TRUE(has(rig.arm->trouble(), "no longer says where the Inverse3 is"));
  rig.service.hold(false);
  EXPECT_TRUE(rig.push()) << "it was late, not lost";
  rig.service.hold(true);
  std::this_thread::sleep_for(1500ms);
  rig.service.hold(false);
  for (int tick = 0; tick < 50; ++tick) EXPECT_FALSE(rig.tick()) << "after a second it is lost";
  EXPECT_TRUE(rig.arm->reopen().empty());
  EXPECT_TRUE(rig.push());
}

TEST(HaplyArm, OfFramesThatPushFewAreUnderWay) {
  HaplyRig rig;
  ASSERT_TRUE(rig.open().empty());
  ASSERT_TRUE(rig.push());
  rig.service.hold(true);
  std::this_thread::sleep_for(10ms);
  const std::int64_t pushes = rig.service.pushes();
  for (int tick = 0; tick < 30; ++tick) {
    rig.arm->write(gatedForHaply(kHaplyPush_N));
    std::this_thread::sleep_for(1ms);
  }
  EXPECT_LE(rig.service.pushes() - pushes, HaplyArm::kMaxUnanswered);
  rig.arm->cut();
  EXPECT_TRUE(comes([&] { return rig.rests(); })) << "what is zero goes out";
}

TEST(HaplyArm, MessagesThatAreNotUnderstoodAreNoSamples) {
  HaplyRig rig;
  ASSERT_TRUE(rig.open().empty());
  ASSERT_TRUE(rig.push());
  rig.service.sayInstead(
      R"({"inverse3": [{"device_id": "04C3", "state": {"cursor_position": {"x": 1e9, "y": 0, "z": 0}}}]})");
  EXPECT_TRUE(has(rig.silence(), "messages that are not understood"));
  EXPECT_TRUE(rig.staysAtRest());
  rig.service.sayInstead(std::nullopt);
  EXPECT_TRUE(rig.push());
}

TEST(HaplyArm, AnArmThatIsNotReadyIsShownAndNotPushed) {
  HaplyRig rig;
  ASSERT_TRUE(rig.open().empty());
  ASSERT_TRUE(rig.push());
  const std::uint32_t epoch = rig.sample.epoch;
  struct Row {
    bool calibrated, power;
    const char* words;
  };
  for (const Row& row :
       {Row{false, true, "is not calibrated"}, {true, false, "no power supply"}, {true, true, "is not ready"}}) {
    rig.service.setStatus(row.calibrated, row.power, row.calibrated && !row.power);
    EXPECT_TRUE(comes([&] { return rig.tick() && has(rig.arm->trouble(), row.words); })) << row.words;
    EXPECT_TRUE(rig.staysAtRest()) << row.words;
  }
  rig.service.setStatus(true, true, true);
  EXPECT_TRUE(rig.push());
  EXPECT_GT(rig.sample.epoch, epoch) << "the past is void";
  EXPECT_EQ(rig.arm->trouble(), "");
}

TEST(HaplyArm, ARestartedServiceIsTakenUpByReopenAlone) {
  HaplyRig rig;
  ASSERT_TRUE(rig.open().empty());
  ASSERT_TRUE(rig.push());
  const std::uint32_t epoch = rig.sample.epoch;
  rig.service.stop();
  EXPECT_TRUE(has(rig.silence(), "The connection to Haply's service at 127.0.0.1:"));
  EXPECT_TRUE(has(reasonOf(rig.arm->reopen()), "No service of Haply answers"));
  rig.service.start();
  std::this_thread::sleep_for(100ms);
  EXPECT_FALSE(rig.tick());
  ASSERT_TRUE(rig.arm->reopen().empty());
  EXPECT_TRUE(rig.rests());
  const std::int64_t before_ns = rig.sample.time_ns;
  EXPECT_TRUE(rig.push());
  EXPECT_GT(rig.sample.epoch, epoch);
  EXPECT_GT(rig.sample.time_ns, before_ns);
}

TEST(HaplyArm, ClosedItHasSaidZero) {
  HaplyRig rig;
  ASSERT_TRUE(rig.open().empty());
  ASSERT_TRUE(rig.push());
  const std::int64_t forces = rig.service.forces();
  rig.arm.reset();
  EXPECT_GE(rig.service.forces(), forces + 1);
  EXPECT_TRUE(rig.rests());
}

TEST(HaplyRow, ListsTheArmsOfAServiceAndOpensThemByTheirNames) {
  HaplyService service;
  const std::string address = "127.0.0.1:" + std::to_string(service.port());
  const std::vector<Found> found = searchAt(address);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found.front().address, address + "/04C3");
  Request request;
  request.arm = *arm::findPreset(arm::kDefaultArm);
  const auto arm = openDevice("haply:" + found.front().address, request);
  ASSERT_TRUE(arm);
  EXPECT_EQ(arm.value()->info().serial, "04C3");
  service.stop();
  EXPECT_TRUE(searchAt(address).empty());
  EXPECT_TRUE(has(reasonOf(openDevice("haply:no host", request).problems()), "is not an address of Haply's service"));
}

}  // namespace underact::device::haply
