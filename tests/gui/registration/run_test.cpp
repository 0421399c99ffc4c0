#include <gtest/gtest.h>

#include "app/gui/registration/registration_run.h"
#include "core/registration/sheet.h"

namespace underact::gui::test {
namespace {

servo::TickRecord tickAt(std::int64_t ms, const Vec3& p_WT, bool pressed) {
  servo::TickRecord record;
  record.time_ns = 1'000'000 * ms;
  record.p_WT = p_WT;
  record.buttons = pressed ? 1U : 0U;
  record.input = servo::kHadSample;
  return record;
}

}  // namespace

TEST(RegistrationRun, ATipHeldStillTouchesItsMarkAndTheNextOneIsDue) {
  RegistrationRun run(nullptr);
  run.begin(registration::sheetPoints());
  run.add(tickAt(0, Vec3::Zero(), false));
  run.add(tickAt(1, Vec3::Zero(), true));
  EXPECT_EQ(run.told(), QString("Hold the tip still."));
  for (int ms = 2; ms < 3000 && run.touching().due() == 0; ++ms) run.add(tickAt(ms, Vec3::Zero(), true));
  EXPECT_EQ(run.touching().due(), 1U);
  EXPECT_EQ(run.told(), QString("Reference point 1 has been touched; the spread of the tip was 0.00 mm."));
}

TEST(RegistrationRun, ATipThatMovesIsToldAndTheMarkStaysDue) {
  RegistrationRun run(nullptr);
  run.begin(registration::sheetPoints());
  run.press();
  EXPECT_TRUE(run.touching().isHolding());
  EXPECT_EQ(run.told(), QString("Hold the tip still."));
  for (int ms = 0; ms < 1000 && run.touching().isHolding(); ++ms)
    run.add(tickAt(ms, Vec3(0.00001 * ms, 0.0, 0.0), false));  // 10 mm/s
  EXPECT_TRUE(run.told().startsWith("The tip moved by more than 1 mm")) << run.told().toStdString();
  EXPECT_TRUE(run.told().contains("reference point 1"));
  EXPECT_EQ(run.touching().due(), 0U);
}

TEST(RegistrationRun, ATickWithoutASampleIsNotHeardAndNothingIsAfterTheEnd) {
  RegistrationRun run(nullptr);
  run.begin(registration::sheetPoints());
  servo::TickRecord blind = tickAt(1, Vec3::Zero(), true);
  blind.input = 0;
  run.add(blind);
  EXPECT_FALSE(run.p_WT().has_value());
  run.add(tickAt(2, Vec3::UnitX(), false));
  EXPECT_EQ(run.p_WT(), Vec3(Vec3::UnitX()));
  run.end();
  EXPECT_FALSE(run.isOn());
  EXPECT_FALSE(run.p_WT().has_value());
}

}  // namespace underact::gui::test
