#include "device/wooden_haptics/wooden_arm.h"

#include <gtest/gtest.h>

#include "core/arm/forward.h"
#include "core/servo/host.h"
#include "device/driver.h"
#include "device/wooden_haptics/wooden.h"
#include "tests/support/comes.h"
#include "tests/support/hid_double.h"
#include "tests/support/property.h"

namespace underact::device {
namespace {

using namespace std::chrono_literals;
using test::comes;
using test::HidDouble;
using test::WoodenFirmware;

const WoodenFirmware::Built kBuiltV1{}, kBuiltV2{2, 14, {0.321, 0.0603, 0.0603}};

const arm::Geometry& geometryOf(const char* preset) {
  return arm::findPreset(preset)->geometry;
}

/// What only the gate can make: a force within 5 N, fully ramped.
safety::GatedForce gatedForWooden(const Vec3& f_T_W) {
  safety::GateState state;
  state.level = 1.0;
  safety::GateInput asked;
  asked.f_T_W = f_T_W;
  asked.engage = true;
  return safety::gate({5.0}, state, asked, 0.001).force;
}

/// An arm and, at the other end of its line, the board.
struct WoodenRig {
  explicit WoodenRig(const WoodenFirmware::Built& built = kBuiltV1, const char* preset = "woodenhaptics")
      : firmware(built), bus(firmware), geometry(geometryOf(preset)) {}
  Problems open(const std::string& address = "") {
    arm.reset();
    Result<std::unique_ptr<WoodenArm>> opened = WoodenArm::open(bus, readWoodenAddress(address), geometry, 1000);
    if (!opened) return opened.problems();
    arm = std::move(opened).value();
    return {};
  }
  std::string refusalReason(const std::string& address = "") {
    const Problems problems = open(address);
    return problems.empty() ? "" : problems.front().sentence;
  }
  /// A tick that writes f_T_W. false: there was no sample.
  bool tick(const Vec3& f_T_W) {
    const bool has = arm->read(sample);
    arm->write(gatedForWooden(f_T_W));
    return has;
  }
  Vec3 force_N() const { return firmware.force_N(system::monotonicNow_ns()); }
  bool rests() const { return firmware.currents_mA(system::monotonicNow_ns()) == std::array<int, 3>{}; }
  /// Ticks until it is pushed so, to half a mA of each motor.
  bool push(const Vec3& f_T_W) {
    return comes([&] {
      tick(f_T_W);
      return (force_N() - f_T_W).norm() < 0.02;
    });
  }

  WoodenFirmware firmware;
  HidDouble bus;
  arm::Geometry geometry;
  std::unique_ptr<WoodenArm> arm;
  arm::Sample sample;
};

Vec3 tipOf(const WoodenRig& rig) {
  return arm::tipPosition(rig.geometry, rig.sample.q_rad);
}

}  // namespace

TEST(WoodenArm, ShowsItsOwnJointsOrThoseOfAnotherArmThatReachTheSameTip) {
  for (const char* preset : {"woodenhaptics", "omni-thesis", "touch-measured"}) {
    WoodenRig rig(kBuiltV1, preset);
    rig.firmware.placeTip(Vec3(0.03, 0.02, 0.05));
    ASSERT_TRUE(rig.open().empty());
    ASSERT_TRUE(comes([&] { return rig.tick(Vec3::Zero()); }));
    EXPECT_LT((tipOf(rig) - Vec3(0.03, 0.02, 0.05)).norm(), 1e-4) << preset;  // steps of three encoders
  }
}

TEST(WoodenArm, BeyondTheReachOfTheOtherArmItDoesNotPush) {
  WoodenRig rig(kBuiltV1, "omni-thesis");  // its shoulder is 0.176 m behind, and it reaches 0.277 m
  ASSERT_TRUE(rig.open().empty());
  ASSERT_TRUE(rig.push(Vec3(0.5, 0.0, 0.0)));
  rig.firmware.placeTip(Vec3(0.0, 0.0, 0.13));
  EXPECT_TRUE(comes([&] { return rig.tick(Vec3(0.5, 0.0, 0.0)) && rig.rests(); }));
  rig.firmware.placeTip(Vec3(0.0, 0.0, 0.06));
  EXPECT_TRUE(rig.push(Vec3(0.5, 0.0, 0.0)));
}

TEST(WoodenArm, TheAddressNamesModelAndSerialNumber) {
  WoodenRig rig(kBuiltV2);
  EXPECT_EQ(rig.refusalReason("0043"),
            "No WoodenHaptics arm with the serial number or path \"0043\" is plugged in. Devices that may be one, and "
            "can be chosen by name: 0042.");
  EXPECT_EQ(rig.refusalReason("woody-2019/0042"), "");
  EXPECT_EQ(rig.arm->info().title, "WoodenHaptics, 2019, serial 0042");
  EXPECT_EQ(rig.arm->info().serial, "0042");
  EXPECT_EQ(rig.refusalReason("woody//dev/hidraw7"), "");
  EXPECT_EQ(rig.arm->info().title, "WoodenHaptics, 2015, serial 0042");
  EXPECT_EQ(rig.refusalReason("polhem-v3"),
            "The kinematics of the arm \"Polhem, version 3\" are not published, so it cannot be used. WoodenHaptics "
            "arms can.");
  rig.bus.unplug();
  EXPECT_EQ(rig.refusalReason(), "No WoodenHaptics arm is plugged in.");
}

TEST(WoodenArm, ABoardThatMayBeAnythingIsTakenByNameAlone) {
  WoodenRig rig({2, 64, {0.321, 0.0603, 0.0603}});
  rig.bus.node.vendor = 0x16C0, rig.bus.node.product = 0x0486;
  EXPECT_NE(rig.refusalReason().find("chosen by name: 0042."), std::string::npos);
  EXPECT_EQ(rig.refusalReason("0042"), "");
  rig.bus.node.usage = 0x0100;  // a keyboard somebody built
  EXPECT_NE(rig.refusalReason("0042"), "");
}

TEST(WoodenArm, SaysWhatIsWrongWithABoardThatDoesNotAnswer) {
  WoodenRig rig;
  rig.bus.silence(true);
  EXPECT_EQ(
      rig.refusalReason(),
      "The WoodenHaptics arm at /dev/hidraw7 sends nothing. Press the reset button on its board, or plug it in again.");
  rig.bus.say(std::vector<std::uint8_t>(12, 0));
  EXPECT_EQ(rig.refusalReason(),
            "/dev/hidraw7 sends reports of 12 bytes; those of a WoodenHaptics arm have 8, 14 or 64.");
}

TEST(WoodenArm, ThatWasNotCalibratedPushesOnlyOnceItIs) {
  WoodenRig rig({2, 14, {0.321, 0.0603, 0.0603}, false});
  rig.firmware.pressCalibration();  // puts it in its home posture
  ASSERT_TRUE(rig.open().empty());
  EXPECT_TRUE(comes([&] {
    rig.tick(Vec3(0.5, 0.0, 0.0));
    return rig.sample.epoch == 1 && rig.arm->trouble().empty();
  }));
  const Vec3 home_W(0.0, 0.205, 0.025);
  EXPECT_TRUE(comes([&] { return rig.tick(Vec3::Zero()) && (tipOf(rig) - home_W).norm() < 1e-4; }));
  EXPECT_TRUE(rig.push(Vec3(0.5, 0.0, 0.0)));
}

TEST(WoodenArm, AsksForItsPostureWhereItIsUnknown) {
  for (const auto& [protocol, protocol_name] :
       {std::pair(1, "Unplug it, put it in its home posture"), std::pair(2, "press the calibration button")}) {
    WoodenRig rig({protocol, protocol == 1 ? 8U : 14U, {0.321, 0.0603, 0.0603}, false});
    rig.firmware.placeTip(Vec3(0.0, -0.3, -0.15));  // hanging down, far from home
    rig.firmware.losePower();
    rig.firmware.placeTip(Vec3(0.0, 0.15, 0.1));
    ASSERT_TRUE(rig.open().empty());
    EXPECT_NE(rig.arm->trouble().find("does not know its posture"), std::string::npos);
    EXPECT_NE(rig.arm->trouble().find(protocol_name), std::string::npos) << rig.arm->trouble();
    for (int tick = 0; tick < 50; ++tick) ASSERT_TRUE(comes([&] { return rig.tick(Vec3(0.5, 0.0, 0.0)); }));
    EXPECT_EQ(rig.firmware.pushes(), 0);
  }
}

TEST(WoodenArm, AWriteThatTakesLongSendsTheNewestForceAlone) {
  WoodenRig rig;
  ASSERT_TRUE(rig.open().empty());
  rig.bus.slowDown(10ms);
  const std::int64_t before = rig.firmware.currentsTaken();
  int ticks = 0;
  const auto end = std::chrono::steady_clock::now() + 200ms;
  while (std::chrono::steady_clock::now() < end) {
    rig.tick(Vec3(1e-3 * ++ticks, 0.0, 0.0));
    std::this_thread::sleep_for(500us);
  }
  EXPECT_LE(rig.firmware.currentsTaken() - before, 25);  // 10 ms each: 20, and what was under way
  EXPECT_TRUE(rig.push(Vec3(0.5, 0.0, 0.0)));
}

TEST(WoodenArm, WithoutANewForceItIsToldZero) {
  for (const WoodenFirmware::Built& built : {kBuiltV1, kBuiltV2}) {
    WoodenRig rig(built);
    ASSERT_TRUE(rig.open().empty());
    ASSERT_TRUE(rig.push(Vec3(0.5, 0.0, 0.0)));
    const std::int64_t taken = rig.firmware.currentsTaken();
    EXPECT_TRUE(comes([&] { return rig.rests(); }));
    EXPECT_GT(rig.firmware.currentsTaken(), taken) << "it was the board's own watchdog";
  }
}

TEST(WoodenArm, ACutIsHeardAndLastsUntilTheNextForce) {
  WoodenRig rig;
  ASSERT_TRUE(rig.open().empty());
  for (int round = 0; round < 20; ++round) {
    ASSERT_TRUE(rig.push(Vec3(0.0, 0.5, 0.0)));
    rig.arm->cut();
    ASSERT_TRUE(comes([&] { return rig.rests(); }));
  }
}

TEST(WoodenArm, GivesNoSampleWhenItFallsSilentAndReportsIt) {
  WoodenRig rig;
  ASSERT_TRUE(rig.open().empty());
  ASSERT_TRUE(comes([&] { return rig.tick(Vec3::Zero()); }));
  rig.bus.silence(true);
  EXPECT_TRUE(comes([&] { return !rig.tick(Vec3::Zero()); }));
  EXPECT_TRUE(comes([&] { return rig.arm->trouble().find("sends nothing") != std::string::npos; }));
  rig.bus.silence(false);
  EXPECT_TRUE(comes([&] { return rig.tick(Vec3::Zero()) && rig.arm->trouble().empty(); }));
}

TEST(WoodenArm, AMessageThatIsNotTakenIsNoLossAndManyAre) {
  WoodenRig rig;
  ASSERT_TRUE(rig.open().empty());
  rig.bus.refuse(3);
  EXPECT_TRUE(rig.push(Vec3(0.5, 0.0, 0.0)));
  EXPECT_EQ(rig.arm->trouble(), "");
  rig.bus.refuse(1'000'000);
  EXPECT_TRUE(comes([&] { return !rig.tick(Vec3(0.5, 0.0, 0.0)); }));
  EXPECT_NE(rig.arm->trouble(), "");
}

TEST(WoodenArm, WhereReadingAloneFailsTheMotorsAreToldZero) {
  WoodenRig rig;
  ASSERT_TRUE(rig.open().empty());
  ASSERT_TRUE(rig.push(Vec3(0.5, 0.0, 0.0)));
  const std::int64_t taken = rig.firmware.currentsTaken(), pushes = rig.firmware.pushes();
  rig.bus.breakReading();
  EXPECT_TRUE(comes([&] { return rig.rests(); }));
  EXPECT_GT(rig.firmware.currentsTaken() - taken, rig.firmware.pushes() - pushes) << "it was the board's own watchdog";
  EXPECT_NE(rig.arm->trouble(), "");
  EXPECT_TRUE(rig.arm->reopen().size() == 1) << "it is still so";
  rig.bus.plugIn();
  EXPECT_TRUE(rig.arm->reopen().empty());
  EXPECT_TRUE(rig.push(Vec3(0.5, 0.0, 0.0)));
}

TEST(WoodenArm, TimeNeverStandsStillHoweverFastItIsRead) {
  WoodenRig rig;
  ASSERT_TRUE(rig.open().empty());
  std::int64_t before_ns = -1;
  for (int read = 0; read < 200; ++read) {
    if (!rig.arm->read(rig.sample)) continue;
    ASSERT_GE(rig.sample.time_ns - before_ns, before_ns < 0 ? 0 : 500'000);  // half a period
    before_ns = rig.sample.time_ns;
  }
}

TEST(WoodenArm, AnyReportIsRefusedOrASampleOfNumbers) {
  test::Random random(test::Seed{1234});
  for (const WoodenFirmware::Built& built : {kBuiltV1, kBuiltV2}) {
    WoodenRig rig(built, "omni-thesis");
    ASSERT_TRUE(rig.open().empty());
    for (int round = test::sweep(500, 5000); round > 0; --round) {
      std::vector<std::uint8_t> report(random.below(4) == 0 ? random.below(80) : built.report_bytes);
      for (std::uint8_t& byte : report) byte = static_cast<std::uint8_t>(random.bits());
      rig.bus.say(std::move(report));
      if (!rig.tick(random.direction())) continue;
      for (const double angle_rad : rig.sample.q_rad) ASSERT_TRUE(std::isfinite(angle_rad));
    }
    // Random reports may say that the arm stands where none can; the true ones are heeded again.
    rig.firmware.placeTip(Vec3(0.01, 0.0, 0.05));
    EXPECT_TRUE(comes([&] { return rig.tick(Vec3::Zero()) && (tipOf(rig) - Vec3(0.01, 0.0, 0.05)).norm() < 1e-4; }));
  }
}

TEST(WoodenArm, LetGoIsDrawnToTheTargetAndComesToRest) {  // with a sign wrong anywhere it would be driven away
  for (const WoodenFirmware::Built& built : {kBuiltV1, kBuiltV2}) {
    WoodenFirmware firmware(built);
    HidDouble bus(firmware);
    Result<std::unique_ptr<WoodenArm>> arm = WoodenArm::open(bus, {}, geometryOf(arm::kDefaultArm.data()), 1000);
    ASSERT_TRUE(arm);
    servo::Host host(std::move(arm).value(), servo::HostOptions{.max_late = 1'000'000});
    scene::Description scene;
    scene.title = "Point";
    scene.constraints.push_back({"point", scene::Point{Vec3(10.0, -8.0, 50.0)}, target::Side::Both, {}, {}});
    ASSERT_TRUE(host.load(scene).empty());
    const Vec3 target_W(0.010, -0.008, 0.050);
    const double far_m = (firmware.tip() - target_W).norm();
    host.start();
    host.begin();
    firmware.letGo();
    const auto isThere = [&] {
      if (host.snapshot().mode == servo::Mode::Faulted) host.start();  // a busy machine
      return (firmware.tip() - target_W).norm() < 0.1 * far_m;
    };
    EXPECT_TRUE(comes(isThere)) << firmware.tip().transpose();
    std::this_thread::sleep_for(300ms);
    EXPECT_TRUE(comes(isThere)) << firmware.tip().transpose();
    EXPECT_GT(firmware.joules(), 0.0) << "the motors brought it there";
  }
}

TEST(WoodenLook, NamesEachArmAndWhatIsMissing) {
  WoodenFirmware firmware({});
  HidDouble bus(firmware);
  bus.others = {{0x046D, 0xC626, 1, 8, "/dev/hidraw1", "a mouse"}};
  ASSERT_EQ(searchWooden(bus).size(), 1U);
  EXPECT_EQ(searchWooden(bus)[0].title, "WoodenHaptics, serial 0042");
  EXPECT_EQ(searchWooden(bus)[0].address, "0042");
  EXPECT_TRUE(searchWooden(bus)[0].missing.empty());
  bus.others.push_back({0x1234, 0x0006, 0xFFAB, 0x0200, "/dev/hidraw8", "0042"});
  EXPECT_EQ(searchWooden(bus)[0].address, "/dev/hidraw8") << "two of the same serial number: by path";
  bus.is_allowed = false;
  ASSERT_EQ(searchWooden(bus)[1].missing.size(), 1U);
  EXPECT_EQ(
      searchWooden(bus)[1].missing[0].command,
      "echo 'KERNEL==\"hidraw*\", ATTRS{idVendor}==\"1234\", ATTRS{idProduct}==\"0006\", TAG+=\"uaccess\"' | sudo "
      "tee /etc/udev/rules.d/70-underact-1234-0006.rules && sudo udevadm control --reload && sudo udevadm "
      "trigger");
}

}  // namespace underact::device
