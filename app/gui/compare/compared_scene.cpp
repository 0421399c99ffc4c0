#include "app/gui/compare/compared_scene.h"

#include <QCoreApplication>
#include <chrono>
#include <utility>

#include "core/scene/scene_arm.h"

namespace underact::gui {
namespace {

constexpr std::int64_t kBeforeJudged = 1000;  // ticks over which the time is averaged

std::int64_t periodOf(ServoFacts servo) {
  return 1'000'000'000 / servo.rateHz();
}

Problems refused(const char* sentence) {
  return {{QCoreApplication::translate("Beside", sentence).toStdString(), {}}};
}

const char* const kOtherArm =
    QT_TRANSLATE_NOOP("Beside", "The two scenes are for different arms and cannot be compared.");
const char* const kTooSlow = QT_TRANSLATE_NOOP("Beside",
                                               "The comparison has ended: each tick of the other scene takes too long. "
                                               "Choose a simpler scene or a lower servo rate.");

}  // namespace

Problems ComparedScene::setScene(const scene::Description& scene) {
  if (!scene::haveSameArm(scene, servo_.scene())) return refused(kOtherArm);
  Result<tick::TickProgram> program = servo_.programOf(scene);
  if (!program) return program.problems();
  rerun_.emplace(std::move(program).value(), periodOf(servo_));
  scene_ = scene;
  begins_ = true;
  ticks_ = 0;
  spent_s_ = 0.0;
  clearFigures();
  return {};
}

void ComparedScene::clearFigures() {
  felt_ = {};
  beside_ = {};
}

Problems ComparedScene::add(const servo::TickRecord& felt) {
  if (!rerun_) return {};
  if (std::exchange(revision_, felt.revision) != felt.revision) {
    clearFigures();
    if (!scene::haveSameArm(scene_, servo_.scene())) {
      end();
      return refused(kOtherArm);
    }
  }
  const auto begin = std::chrono::steady_clock::now();
  rerun_->setPeriod(periodOf(servo_));
  const tick::TickReport& report = rerun_->tick(felt, {}, std::exchange(begins_, false)).report;
  spent_s_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (felt.level >= 1.0 && report.level >= 1.0) {
    felt_.add(felt.error_m, felt.f_sent_T_W.norm());
    beside_.add(tick::errorOf(report), report.force.f_T_W().norm());
  }
  if (++ticks_ < kBeforeJudged) return {};
  const bool in_time = spent_s_ < most_of_a_period_ * static_cast<double>(ticks_) / servo_.rateHz();
  ticks_ = 0;
  spent_s_ = 0.0;
  if (in_time) return {};
  end();
  return refused(kTooSlow);
}

}  // namespace underact::gui
