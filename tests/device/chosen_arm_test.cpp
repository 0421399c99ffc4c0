#include "device/chosen_arm.h"

#include <gtest/gtest.h>

#include <vector>

namespace underact::device {
namespace {

/// Counts its samples from its own beginning.
class CountingArm final : public servo::DevicePort {
 public:
  CountingArm(std::string title, int& alive) : title_(std::move(title)), alive_(alive) { ++alive_; }
  ~CountingArm() override { --alive_; }
  bool read(arm::Sample& sample) noexcept override {
    sample.time_ns = ++reads_ * 250'000;
    sample.epoch = epoch_;
    return answers_;
  }
  void write(const safety::GatedForce&) noexcept override {}
  void cut() noexcept override {}
  Problems reopen() override { return {{title_ + " was opened again.", {}}}; }
  void setRate(int rate_hz) override { rate_hz_ = rate_hz; }
  servo::DeviceInfo info() const override { return {title_, false, true, 0.25}; }

  std::int64_t reads_ = 0;
  std::uint32_t epoch_ = 0;
  bool answers_ = true;
  int rate_hz_ = 0;

 private:
  std::string title_;
  int& alive_;
};

struct ChosenRig {
  ChosenRig() {
    auto one = std::make_unique<CountingArm>("first", alive);
    first = one.get();
    chosen = std::make_unique<ChosenArm>(std::move(one));
  }
  CountingArm* choose() {
    auto other = std::make_unique<CountingArm>("other", alive);
    CountingArm* const raw = other.get();
    chosen->choose(std::move(other));
    return raw;
  }
  arm::Sample read() {
    arm::Sample sample;
    EXPECT_TRUE(chosen->read(sample));
    return sample;
  }
  int alive = 0;
  CountingArm* first;
  std::unique_ptr<ChosenArm> chosen;
};

}  // namespace

TEST(ChosenArm, HandsTheFirstArmThroughToTheBit) {
  ChosenRig rig;
  rig.first->epoch_ = 0;
  for (int read = 1; read <= 3; ++read) {
    EXPECT_EQ(rig.read().time_ns, read * 250'000);
  }
  EXPECT_EQ(rig.read().epoch, 0U);
  EXPECT_EQ(rig.chosen->reopen().front().sentence, "first was opened again.");
  EXPECT_TRUE(rig.chosen->isFirst());
}

TEST(ChosenArm, TakesTheOtherOneWithReopenAndClosesItWithTheNext) {
  ChosenRig rig;
  rig.read();
  rig.choose();
  EXPECT_EQ(rig.chosen->info().title, "first");
  EXPECT_FALSE(rig.chosen->isFirst());  // as it will be
  EXPECT_TRUE(rig.chosen->reopen().empty());
  EXPECT_EQ(rig.chosen->info().title, "other");
  EXPECT_EQ(rig.alive, 2);
  EXPECT_EQ(rig.chosen->reopen().front().sentence, "other was opened again.");
  rig.chosen->choose(nullptr);
  EXPECT_EQ(rig.alive, 2);
  EXPECT_TRUE(rig.chosen->reopen().empty());
  EXPECT_EQ(rig.alive, 1);
  EXPECT_EQ(rig.chosen->info().title, "first");
}

TEST(ChosenArm, ItsClockNeverRunsBackAndEachExchangeBeginsAnew) {
  ChosenRig rig;
  for (int read = 0; read < 1000; ++read) rig.read();
  std::int64_t last_ns = rig.read().time_ns;
  std::uint32_t epoch = 0;
  for (int exchange = 0; exchange < 4; ++exchange) {
    if (exchange % 2 == 0)
      rig.choose();
    else
      rig.chosen->choose(nullptr);
    ASSERT_TRUE(rig.chosen->reopen().empty());
    const arm::Sample sample = rig.read();
    EXPECT_EQ(sample.time_ns, last_ns + 1'000'000);
    EXPECT_EQ(sample.epoch, ++epoch);
    EXPECT_EQ(rig.read().time_ns, sample.time_ns + 250'000);
    last_ns = sample.time_ns + 250'000;
  }
}

TEST(ChosenArm, PassesOnWhereTheArmItselfBeginsAnewAndWhatItDoesNotSay) {
  ChosenRig rig;
  CountingArm* const other = rig.choose();
  ASSERT_TRUE(rig.chosen->reopen().empty());
  EXPECT_EQ(rig.read().epoch, 1U);
  other->epoch_ = 7;
  EXPECT_EQ(rig.read().epoch, 2U);
  EXPECT_EQ(rig.read().epoch, 2U);
  other->answers_ = false;
  arm::Sample sample;
  EXPECT_FALSE(rig.chosen->read(sample));
  rig.chosen->setRate(4000);
  EXPECT_EQ(other->rate_hz_, 4000);
  EXPECT_EQ(rig.first->rate_hz_, 4000);  // it may come back
}

}  // namespace underact::device
