#include "app/gui/lessons/lesson_run.h"

#include <QDateTime>
#include <QFileInfo>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/gui/lessons/lesson_library.h"
#include "app/gui/model/data_words.h"
#include "app/gui/model/document.h"
#include "app/gui/model/player.h"
#include "core/arm/preset.h"
#include "core/lesson/read.h"
#include "core/scene/scene_arm.h"

namespace underact::gui {
namespace {

// Until the servo has taken up the scene and the arm its place; a tick from before would count for the wrong step.
constexpr std::int64_t kSettles_ns = 20'000'000;

}  // namespace

LessonRun::LessonRun(const LessonParts& parts, Panel& panel) : QObject(&panel), parts_(parts), place_(parts, panel) {}

bool LessonRun::begin(const QString& path, QString& why) {
  Result<lesson::Lesson> read = lesson::readLessonFile(path.toStdString());
  if (!read) {
    why = tr("“%1” contains errors; see the list.").arg(path);
    emit problems(path, read.problems());
    return false;
  }
  if (parts_.player.isOpen()) {
    why = tr("A session is being replayed. Close it, then start the lesson.");
    return false;
  }
  if (!isOn() && !place_.keep()) return false;  // the user cancelled
  lesson_ = translated(std::move(read).value());
  path_ = path;
  since_begin_.start();
  states_.assign(lesson_->steps.size(), {});
  solved_ = solvedSteps(path);
  std::size_t first = 0;
  while (first + 1 < lesson_->steps.size() && isSolved(first)) ++first;
  if (isAllSolved()) first = 0;  // start again from the first step
  if (go(first)) return true;
  leave();
  return false;
}

bool LessonRun::go(std::size_t step) {
  if (!isOn() || step >= lesson_->steps.size() || !place_.arrange(*lesson_, step)) return false;
  at_ = step;
  begins_ns_ = parts_.servo.snapshot().report.sample.time_ns + kSettles_ns;
  if (states_[at_].empty()) states_[at_].resize(lesson_->steps[at_].checks.size());
  settle();
  emit changed();
  return true;
}

void LessonRun::leave() {
  if (!isOn()) return;
  lesson_.reset();
  states_.clear();
  emit changed();
  place_.putBack();
}

bool LessonRun::answer(std::size_t check, double number) {
  if (!isOn() || check >= step().checks.size() || lesson::questionOf(step().checks[check]) == nullptr) return false;
  lesson::CheckState& state = states_[at_][check];
  state = lesson::afterAnswer(step().checks[check], std::move(state), number);
  settle();
  emit progressed();
  return true;
}

void LessonRun::add(const servo::TickRecord& tick) {
  if (!isOn() || !parts_.document.isOpen() || tick.time_ns < begins_ns_) return;
  const scene::Description& scene = parts_.document.scene();
  const lesson::Observation seen{tick, scene, scene::armOf(scene), robot_};
  std::vector<lesson::CheckState>& states = states_[at_];
  for (std::size_t index = 0; index < states.size(); ++index) {
    states[index] = lesson::afterTick(step().checks[index], std::move(states[index]), seen);
  }
}

void LessonRun::poll(const servo::Snapshot& snapshot) {
  if (!isOn()) return;
  servo_runs_ = snapshot.mode == servo::Mode::Running;
  robot_ = {};
  for (const tick::ConstraintReport& held : snapshot.report.held) {
    if (held.robot.joints == 0) continue;
    robot_ = held.robot;
    break;
  }
  settle();
  emit progressed();
}

bool LessonRun::asksFor(std::initializer_list<std::string_view> quantity_keys) const {
  return isOn() && !isSolved(at_) &&
         std::any_of(quantity_keys.begin(), quantity_keys.end(),
                     [this](std::string_view key) { return lesson::asksFor(step(), states_[at_], key); });
}

std::vector<lesson::TargetPlace> LessonRun::targets() const {
  if (!isOn() || !parts_.document.isOpen()) return {};
  return lesson::targetsOf(step(), scene::armOf(parts_.document.scene()));
}

lesson::Report LessonRun::report(const QString& name, const QDateTime& when) const {
  const double minutes = static_cast<double>(since_begin_.elapsed()) / 60e3;
  lesson::Report report{name.toStdString(),
                        QFileInfo(path_).completeBaseName().toStdString(),
                        lesson_->title,
                        when.toString(Qt::ISODate).toStdString(),
                        std::round(10.0 * minutes) / 10.0,
                        {}};
  for (std::size_t step = 0; step < lesson_->steps.size(); ++step)
    report.steps.push_back(lesson::reportOf(lesson_->steps[step], isSolved(step), states_[step]));
  return report;
}

/// Marks the current step as solved if all of its checks are.
void LessonRun::settle() {
  if (isSolved(at_) || !lesson::isSolved(states_[at_])) return;
  solved_.insert(at_);
  rememberSolved(path_, at_);
  emit solved();
}

}  // namespace underact::gui
