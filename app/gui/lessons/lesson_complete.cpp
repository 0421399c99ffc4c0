#include "app/gui/lessons/lesson_complete.h"

#include <QAction>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/lessons/lesson_run.h"

namespace underact::gui {
namespace {

/// "2, 3", from 1.
QString openSteps(const LessonRun& run) {
  QStringList open;
  for (std::size_t step = 0; step < run.lesson().steps.size(); ++step) {
    if (!run.isSolved(step)) open << QString::number(step + 1);
  }
  return open.join(", ");
}

}  // namespace

LessonComplete::LessonComplete(Actions& actions, QWidget* parent)
    : QFrame(parent),
      actions_(actions),
      title_(messageLabel("panel.lessons.complete", tr("Lesson complete"), "running", this)),
      text_(messageLabel("panel.lessons.complete.text", tr("What comes next"), "", this)),
      next_(pushButton("panel.lessons.complete.next", tr("Next lesson"), tr("Begins the next lesson."), this)),
      step_(pushButton("panel.lessons.complete.step", tr("Next step"), tr("Goes to the next step."), this)) {
  setProperty("role", "card");
  auto* const column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 12, 12);
  column->setSpacing(8);
  for (QWidget* const one : {static_cast<QWidget*>(title_), static_cast<QWidget*>(text_), static_cast<QWidget*>(next_),
                             static_cast<QWidget*>(step_)})
    column->addWidget(one);
  connect(next_, &QPushButton::clicked, this, [this] { actions_.perform("lesson.after"); });
  connect(step_, &QPushButton::clicked, this, [this] { actions_.perform("lesson.next"); });
  hide();
}

void LessonComplete::present(const LessonRun& run) {
  const bool is_last = run.at() + 1 == run.lesson().steps.size();
  const bool is_complete = run.isAllSolved();
  const bool is_done = run.isSolved(run.at());
  const bool was_hidden = isHidden();
  setVisible(is_complete || is_done);
  if (isHidden()) return;
  title_->setVisible(is_complete || is_last);
  updateText(title_, is_complete ? tr("✓ Lesson complete") : tr("The last step is solved"));
  const QString next = actions_.find("lesson.after")->data().toString();  // empty: there is none
  const QString text = is_complete ? (next.isEmpty() ? tr("This was the last lesson. Your own comes next: see Writing "
                                                          "lessons in the guide.")
                                                     : tr("Next: %1").arg(next))
                       : is_last   ? tr("Still open: step %1.").arg(openSteps(run))
                                   : tr("This step is solved.");
  updateText(text_, text);
  next_->setVisible(is_complete && !next.isEmpty());
  step_->setVisible(!is_complete && !is_last);
  if (was_hidden && is_complete) title_->setAccessibleDescription(text);
}

}  // namespace underact::gui
