#pragma once
#include <QElapsedTimer>
#include <QObject>
#include <QSet>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <vector>

#include "app/gui/lessons/lesson_window_state.h"
#include "core/lesson/report.h"
#include "core/lesson/stage.h"

namespace underact::gui {

/// A lesson in progress: the current step, what its checks have seen, and which steps are solved.
class LessonRun : public QObject {
  Q_OBJECT
 public:
  LessonRun(const LessonParts& parts, Panel& panel);

  /// Starts a lesson at its first unsolved step, replacing the current one. why: set when it does not start.
  bool begin(const QString& path, QString& why);
  bool go(std::size_t step);
  /// Answers the question of a check with a number, or the number of a choice. false: there is no such question.
  bool answer(std::size_t check, double number);
  void leave();

  void add(const servo::TickRecord& tick);
  void poll(const servo::Snapshot& snapshot);

  bool isOn() const { return lesson_.has_value(); }
  const lesson::Lesson& lesson() const { return *lesson_; }
  const QString& path() const { return path_; }
  std::size_t at() const { return at_; }
  const lesson::Step& step() const { return lesson_->steps[at_]; }
  /// What the checks of a step have seen since the lesson started.
  const std::vector<lesson::CheckState>& states(std::size_t step) const { return states_[step]; }
  /// Whether a step was solved, now or earlier. A step without checks is solved at once.
  bool isSolved(std::size_t step) const { return solved_.contains(step); }
  bool isAllSolved() const { return static_cast<std::size_t>(solved_.size()) == lesson_->steps.size(); }
  /// Whether the current step asks a question, not answered yet, for one of these quantities.
  bool asksFor(std::initializer_list<std::string_view> quantity_keys) const;
  /// The places where the current step wants the tip, and which of them were reached.
  std::vector<lesson::TargetPlace> targets() const;
  /// What was done in the lesson since it began. name: of the student; empty: none.
  lesson::Report report(const QString& name, const QDateTime& when) const;
  bool isServoRunning() const { return servo_runs_; }

 signals:
  void changed();     // another step, another lesson, or none
  void progressed();  // after each frame and each answer
  void solved();      // the current step has just been solved
  void problems(const QString& path, const underact::Problems& problems);

 private:
  void settle();

  LessonParts parts_;
  LessonWindowState place_;
  std::optional<lesson::Lesson> lesson_;
  QString path_;
  std::size_t at_ = 0;
  std::vector<std::vector<lesson::CheckState>> states_;
  QSet<std::size_t> solved_;
  QElapsedTimer since_begin_;
  target::Robot robot_;  // of the last frame
  bool servo_runs_ = false;
  std::int64_t begins_ns_ = 0;  // of the step: ticks before it belong to the step before
};

}  // namespace underact::gui
