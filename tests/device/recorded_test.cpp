#include "device/recorded.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>

#include "core/record/recorder.h"
#include "device/simulated_arm.h"

namespace underact::device {
namespace {

// A simulated arm whose samples fail to come at some reads, and which keeps those that it gave.
class SpoiledArm final : public servo::DevicePort {
 public:
  SpoiledArm(const SimulatedArm::Options& options, std::vector<arm::Sample>& given) : arm_(options), given_(given) {}
  bool read(arm::Sample& sample) noexcept override {
    arm_.read(sample);
    sample.buttons = static_cast<std::uint32_t>(++reads_);
    if (reads_ == 201) sample.q_rad[2] = kNotANumber;
    given_.push_back(sample);
    return reads_ < 100 || reads_ > 104;
  }
  void write(const safety::GatedForce& force) noexcept override { arm_.write(force); }
  void cut() noexcept override { arm_.cut(); }
  servo::DeviceInfo info() const override { return {"Spoiled", true, false, 0.0}; }

 private:
  SimulatedArm arm_;
  std::vector<arm::Sample>& given_;
  int reads_ = 0;
};

scene::Description ball(double radius_mm) {
  scene::Description scene;
  scene.title = "Ball";
  scene.constraints.push_back({"ball", scene::Sphere{Vec3::Zero(), radius_mm}, target::Side::Both, {}, {}});
  return scene;
}

struct Session {
  Session() {
    SimulatedArm::Options options;
    options.arm = *arm::findPreset("touch-measured");
    options.model = *sim::findArmModel("vendor-nominal");
    path = (std::filesystem::temp_directory_path() / "underact_recorded_test.h5").string();
    servo::Host host(std::make_unique<SpoiledArm>(options, given), {.clock = servo::Clock::Manual});
    EXPECT_TRUE(host.load(ball(50.0)).empty());
    host.start();
    auto recorder = record::Recorder::start(host, path, {.name = "Slow push"});
    EXPECT_TRUE(static_cast<bool>(recorder));
    host.run(50);
    recorder.value()->mark("here");
    scene::Description softer = ball(50.0);
    softer.control.gains.kp_N_per_mm = Vec3(0.1, 0.1, 0.1);
    EXPECT_TRUE(host.edit(softer).empty());
    host.run(250);
    EXPECT_TRUE(recorder.value()->stop().empty());
  }
  ~Session() { std::filesystem::remove(path); }
  std::string path;
  std::vector<arm::Sample> given;
};

TEST(Recorded, HoldsEachSampleToTheBitAndRepeatsTheLastWhereThereWasNone) {
  Session session;
  std::vector<double> shares;
  std::int64_t seen = 0;
  LoadWatch watch;
  watch.progress = [&](double share) { shares.push_back(share); };
  watch.row = [&](std::int64_t row, const servo::TickRecord& record) {
    EXPECT_EQ(row, seen++);
    EXPECT_EQ(record.tick, row + 1);
  };
  const auto loaded = loadRecorded(session.path, watch);
  ASSERT_TRUE(static_cast<bool>(loaded)) << loaded.problems().front().sentence;
  const Recorded& recorded = *loaded.value();
  EXPECT_EQ(recorded.name, "Slow push");
  EXPECT_EQ(recorded.rate_hz, 1000);
  ASSERT_EQ(recorded.rows.size(), 300U);
  EXPECT_EQ(seen, 300);
  ASSERT_FALSE(shares.empty());
  EXPECT_EQ(shares.back(), 1.0);
  for (std::size_t row = 0; row < recorded.rows.size(); ++row) {
    const bool missing = (row >= 99 && row <= 103) || row == 200;
    const std::size_t from = !missing ? row : row == 200 ? 199 : 98;
    ASSERT_EQ(std::memcmp(&recorded.rows[row].q_rad, &session.given[from].q_rad, sizeof(arm::JointAngles)), 0) << row;
    EXPECT_EQ(recorded.rows[row].buttons, row + 1);
  }
  EXPECT_TRUE(recorded.rows[0].begins_anew) << "Start was pressed there";
  EXPECT_FALSE(recorded.rows[1].begins_anew);
  EXPECT_TRUE(recorded.rows[200].begins_anew) << "a fault";
}

TEST(Recorded, MarksFaultsAndScenesStandAtTheirRows) {
  Session session;
  const auto loaded = loadRecorded(session.path);
  ASSERT_TRUE(static_cast<bool>(loaded));
  const Recorded& recorded = *loaded.value();
  ASSERT_EQ(recorded.marks.size(), 2U);
  EXPECT_EQ(recorded.marks[0].label, "here");
  EXPECT_FALSE(recorded.marks[0].is_fault);
  EXPECT_EQ(recorded.marks[0].row, 49);
  EXPECT_TRUE(recorded.marks[1].is_fault);
  EXPECT_EQ(recorded.marks[1].row, 200);
  EXPECT_FALSE(recorded.marks[1].label.empty());
  ASSERT_EQ(recorded.scenes.size(), 2U);
  EXPECT_EQ(recorded.scenes[1].row, 50);
  EXPECT_EQ(recorded.sceneAt(49), &recorded.scenes[0]);
  EXPECT_EQ(recorded.sceneAt(50), &recorded.scenes[1]);
  EXPECT_EQ(recorded.scenes[1].scene.control.gains.kp_N_per_mm, Vec3(0.1, 0.1, 0.1));
}

TEST(Recorded, LoadingCanBeEndedAndWhatIsNoSessionIsSaid) {
  Session session;
  const std::atomic<bool> cancelled{true};
  LoadWatch watch;
  watch.cancelled = &cancelled;
  const auto ended = loadRecorded(session.path, watch);
  ASSERT_FALSE(static_cast<bool>(ended));
  EXPECT_NE(ended.problems().front().sentence.find("cancelled before"), std::string::npos);
  EXPECT_FALSE(static_cast<bool>(loadRecorded("/dev/null/nowhere/all.h5")));
}

}  // namespace
}  // namespace underact::device
