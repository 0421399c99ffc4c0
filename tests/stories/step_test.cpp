#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QProcess>
#include <QPushButton>
#include <cmath>

#include "app/gui/step/step_plot.h"
#include "tests/stories/picture_difference.h"
#include "tests/stories/story.h"

namespace underact::gui::test {
namespace {

// Rows and columns of the table, from 1.
enum Row { kFinal = 1, kRise, kSettling, kPeak, kOvershoot, kOmega, kZeta, kError };
enum StepColumn { kModel = 1, kMeasured, kFitted };

struct StepLab : Story {
  explicit StepLab(const QString& scene = "01_point", const Beginning& beginning = {}) : Story(scene, beginning) {
    EXPECT_TRUE(perform("dock.step", true));
    settle();
  }
  QString cell(Row row, StepColumn column) {
    return find<QLabel>(QString("panel.step.table.%1.%2").arg(row).arg(column))->text();
  }
  double number(Row row, StepColumn column) {
    return QString(cell(row, column)).replace(QChar(0x2212), '-').toDouble();
  }
  QString text(const char* name) { return find<QLabel>(QString("panel.step.") + name)->text(); }
  const scene::Control& control() { return controlOf(window().document().scene(), 0); }
  void set(const QString& quantity, double value) { EXPECT_TRUE(perform("step.set", quantity, value)); }
};

QJsonObject labStepCommand(const QStringList& more) {
  QProcess program;
  program.start(UNDERACT_CLI, QStringList{"lab", "step", "--scene", shippedScene("01_point"), "--json"} + more);
  EXPECT_TRUE(program.waitForFinished(60000));
  EXPECT_EQ(program.exitCode(), 0);
  return QJsonDocument::fromJson(program.readAllStandardOutput()).object();
}

}  // namespace

TEST(StepStory, ItBeginsWithTheGainsOfTheScene) {
  StepLab story;
  EXPECT_EQ(story.find<QComboBox>("panel.step.law")->currentIndex(), 0);
  EXPECT_EQ(story.find<QDoubleSpinBox>("panel.step.kp.number")->value(), 0.5);
  EXPECT_NEAR(story.number(kOmega, kModel), std::sqrt(500.0 / 0.045), 0.05);
  EXPECT_EQ(story.cell(kSettling, kModel), "never");  // P and no damping at all
  EXPECT_EQ(story.number(kOvershoot, kModel), 100.0);
  EXPECT_TRUE(story.text("note").contains("oscillates for ever"));
  EXPECT_EQ(story.cell(kRise, kMeasured), "");
}

TEST(StepStory, DampingIsSeenInNumbersAndPoles) {
  StepLab story;
  ASSERT_TRUE(story.perform("step.law", "PD"));
  EXPECT_TRUE(story.find("panel.step.kd")->isVisible());
  EXPECT_FALSE(story.find("panel.step.ki")->isVisible());
  story.type(story.find("panel.step.kd.number"), "0.004");
  const double zeta = 4.0 / (2.0 * std::sqrt(500.0 * 0.045));
  EXPECT_NEAR(story.number(kZeta, kModel), zeta, 1e-4);
  EXPECT_NEAR(story.number(kOvershoot, kModel), 100.0 * std::exp(-M_PI * zeta / std::sqrt(1.0 - zeta * zeta)), 0.01);
  EXPECT_EQ(story.text("poles"), QString("Poles [rad/s]: ") + QChar(0x2212) + "44.44 ± 95.58i");
  ASSERT_TRUE(story.perform("step.law", "PID"));
  story.set("ki", 2.0);
  EXPECT_TRUE(story.text("poles").contains(","));  // a third one
}

TEST(StepStory, TheArmIsMeasuredAsTheCommandLineMeasuresIt) {
  StepLab story;
  ASSERT_TRUE(story.perform("step.law", "PD"));
  story.set("kd", 0.004);
  story.find<QCheckBox>("panel.step.limits")->setChecked(false);
  story.find<QDoubleSpinBox>("panel.step.size")->setValue(8.0);
  story.run(1);
  const std::uint64_t revision = story.host().revision();
  ASSERT_TRUE(story.perform("step.measure"));
  EXPECT_EQ(story.host().revision(), revision);  // on an arm of its own
  const QJsonObject wanted =
      labStepCommand({"--law", "PD", "--kd_N_s_per_mm", "0.004", "--no-limits", "--step_mm", "8"});
  EXPECT_NEAR(story.number(kRise, kMeasured), wanted["rise_10_90_s"].toDouble(), 1e-4);
  EXPECT_NEAR(story.number(kOvershoot, kMeasured), 100.0 * wanted["overshoot_fraction"].toDouble(), 0.01);
  EXPECT_NEAR(story.number(kError, kMeasured), wanted["steady_error_mm"].toDouble(), 1e-4);
  const QJsonObject fit = wanted["fit"].toObject();
  EXPECT_NEAR(story.number(kOmega, kFitted), fit["omega_n_rad_per_s"].toDouble(), 0.1);
  EXPECT_NEAR(story.number(kZeta, kFitted), fit["zeta"].toDouble(), 1e-4);
  EXPECT_GT(story.number(kZeta, kFitted), story.number(kZeta, kModel));  // friction damps, too
  story.savePicture("step_response");
  story.set("kp", 0.6);
  EXPECT_EQ(story.cell(kRise, kMeasured), "");  // it was measured with another stiffness
}

TEST(StepStory, AnArmThatWasMeasuredIsTheOneThatIsStepped) {
  const QString arm = temporaryFile("stepped.json", R"({"underact_arm_model": 1, "name": "heavy", "title": "Heavy",
    "provenance": {"device": "a bench", "date": "2026-11-22"},
    "mass_kg": 0.12, "friction_N": 0.05, "damping_N_s_per_m": 2.0})");
  StepLab story;
  ASSERT_TRUE(story.perform("step.measure"));
  EXPECT_NE(story.cell(kRise, kMeasured), "");
  ASSERT_TRUE(story.perform("arm.open", arm));
  EXPECT_EQ(story.cell(kRise, kMeasured), "") << "it was of another arm";
  EXPECT_EQ(story.find<QDoubleSpinBox>("panel.step.mass.number")->value(), 0.12);
  EXPECT_EQ(story.find<QDoubleSpinBox>("panel.step.damping.number")->value(), 2.0);
  story.find<QCheckBox>("panel.step.limits")->setChecked(false);
  ASSERT_TRUE(story.perform("step.measure"));
  EXPECT_TRUE(story.text("note").contains("“heavy”")) << story.text("note").toStdString();
  EXPECT_TRUE(story.text("note").contains("0.05 N")) << "its friction: " << story.text("note").toStdString();
  const QJsonObject wanted = labStepCommand({"--arm-model", arm, "--no-limits"});
  EXPECT_NEAR(story.number(kRise, kMeasured), wanted["rise_10_90_s"].toDouble(), 1e-4);
  EXPECT_NEAR(story.number(kOvershoot, kMeasured), 100.0 * wanted["overshoot_fraction"].toDouble(), 0.01);
  ASSERT_TRUE(story.perform("arm.vendor"));
  EXPECT_EQ(story.find<QDoubleSpinBox>("panel.step.mass.number")->value(), 0.045);
  EXPECT_EQ(story.find<QDoubleSpinBox>("panel.step.damping.number")->value(), 0.0);
}

TEST(StepStory, GainsGoToTheSceneInOneStepBack) {
  StepLab story("11_soft_and_stiff_axes");
  const scene::Gains own = story.control().gains;
  ASSERT_TRUE(story.perform("step.law", "PD"));
  story.set("kp", 0.3);
  story.set("kd", 0.002);
  EXPECT_FALSE(story.window().document().modified());  // the panel's own sliders are no edits
  story.click(story.find("panel.step.give"));
  EXPECT_EQ(story.control().law, scene::LawType::PD);
  EXPECT_EQ(story.control().gains.kp_N_per_mm, Vec3::Constant(0.3));
  EXPECT_EQ(story.control().gains.kd_N_s_per_mm, Vec3::Constant(0.002));
  ASSERT_TRUE(story.perform("edit.undo"));
  EXPECT_EQ(story.control().gains, own);
  EXPECT_FALSE(story.window().document().modified());
  story.click(story.find("panel.step.take"));
  EXPECT_EQ(story.find<QDoubleSpinBox>("panel.step.kp.number")->value(), own.kp_N_per_mm.x());
}

TEST(StepStory, NamesWhatCannotBeMeasured) {
  StepLab story("09_wall");
  EXPECT_FALSE(story.perform("step.measure"));
  EXPECT_TRUE(story.text("note").contains("wall"));
  ASSERT_TRUE(story.perform("step.law", "P"));
  story.set("mass", 0.0);
  EXPECT_TRUE(story.text("note").contains("neither mass nor damping"));
  EXPECT_EQ(story.cell(kFinal, kModel), "");
  EXPECT_FALSE(story.perform("step.set", "kp", -1.0));
  EXPECT_FALSE(story.perform("step.show", 6));
}

TEST(StepStory, TheThesissFiguresStandBesideEachOther) {
  StepLab story;
  auto* plot = story.find<StepPlot>("panel.step.plot");
  QImage last = plot->picture();
  for (int figure = 1; figure <= 5; ++figure) {
    ASSERT_TRUE(story.perform("step.show", figure));
    story.settle();
    const QImage now = plot->picture();
    EXPECT_GT(worstBlockDifference(now, last), 0.02) << figure;
    last = now;
    EXPECT_FALSE(story.find("panel.step.kp")->isVisible());
    story.savePicture(QString("step_b%1").arg(figure));
  }
  EXPECT_NEAR(story.number(kOvershoot, kModel), 38.0, 0.1);
  EXPECT_NEAR(story.number(kPeak, kModel), 3.2872, 1e-3);
  ASSERT_TRUE(story.perform("step.show", 4));
  EXPECT_NEAR(story.number(kRise, kModel), std::log(9.0), 1e-3);
  EXPECT_NEAR(story.number(kSettling, kModel), std::log(50.0), 1e-3);
}

TEST(StepStory, ItIsReadableInTheDarkToo) {
  StepLab story;
  ASSERT_TRUE(story.perform("view.theme.dark"));
  ASSERT_TRUE(story.perform("step.law", "PID"));
  story.set("kd", 0.003);
  story.set("ki", 3.0);
  ASSERT_TRUE(story.perform("step.measure"));
  story.settle();
  story.savePicture("step_dark");
}

}  // namespace underact::gui::test
