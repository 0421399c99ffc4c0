#include "app/gui/calibration/calibration_run.h"

#include <gtest/gtest.h>

#include <QUndoStack>

#include "core/calibration/trial.h"
#include "core/scene/compile.h"
#include "tests/gui/desk.h"

namespace underact::gui {
FeatureRow calibrationFeature();
}

namespace underact::gui::test {
namespace {

/// Both beams are pressed in this trial, one after the other, as its servo would say.
void pressBoth(Desk& desk, CalibrationRun& session) {
  const auto beams = calibration::beamsOf(desk.scene()).value();
  servo::Snapshot snapshot;
  snapshot.mode = servo::Mode::Running;
  snapshot.revision = desk.host().revision();
  snapshot.report.held.resize(desk.scene().constraints.size());
  session.present(snapshot);  // nothing is bent: both are let go
  safety::Limits limits;
  limits.max_force_N = 1.0;
  safety::GateState gate;
  gate.level = 1.0;
  snapshot.report.force = safety::gate(limits, gate, {Vec3(0.2, 0.0, 0.0), true, false, {}}, 0.001).force;
  for (const std::size_t beam : beams) {
    snapshot.report.held[beam].acts = true;
    snapshot.report.held[beam].p_WP = Vec3(0.5, 0.5, 0.5);
  }
  session.present(snapshot);
}

}  // namespace

TEST(CalibrationRun, ASceneWithoutBeamsIsRefusedInASentence) {
  Desk desk(calibrationFeature());
  CalibrationRun session(desk.document(), desk.host(), nullptr);
  const Problems problems = session.begin({});
  ASSERT_FALSE(problems.empty());
  EXPECT_FALSE(problems.front().sentence.empty());
  EXPECT_EQ(session.state(), CalibrationRun::State::Idle);
}

TEST(CalibrationRun, NobodyIsAskedBeforeBothBeamsWerePressedAndEachTrialAnew) {
  Desk desk(calibrationFeature(), "23_two_beams");
  CalibrationRun session(desk.document(), desk.host(), nullptr);
  ASSERT_TRUE(session.begin({}).empty());
  EXPECT_TRUE(desk.document().isTryingOut());
  EXPECT_FALSE(session.answer(calibration::Beam::Left));
  pressBoth(desk, session);
  EXPECT_TRUE(session.mayAnswer());
  EXPECT_TRUE(session.answer(calibration::Beam::Left));
  EXPECT_FALSE(session.mayAnswer());
}

TEST(CalibrationRun, AnEditEndsItWithASentenceAndTheScenesOwnIsInEffect) {
  Desk desk(calibrationFeature(), "23_two_beams");
  CalibrationRun session(desk.document(), desk.host(), nullptr);
  ASSERT_TRUE(session.begin({}).empty());
  scene::Description edited = desk.scene();
  edited.title = "another";
  ASSERT_TRUE(desk.document().edit(edited, "title", desk.document().newGesture()).empty());
  EXPECT_EQ(session.state(), CalibrationRun::State::Idle);
  EXPECT_EQ(session.why(), QString("The scene was changed, so the measurement was cancelled."));
  EXPECT_FALSE(desk.document().isTryingOut());
}

}  // namespace underact::gui::test
