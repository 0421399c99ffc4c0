#include "app/gui/lessons/lesson_page.h"

#include <QAction>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/page_view.h"
#include "app/gui/kit/panel_scroll.h"
#include "app/gui/kit/tab_order.h"
#include "app/gui/kit/tight_layout.h"
#include "app/gui/lessons/check_row.h"
#include "app/gui/lessons/lesson_complete.h"
#include "app/gui/lessons/lesson_run.h"
#include "app/gui/lessons/lesson_words.h"

namespace underact::gui {
namespace {

constexpr const char* kButtons[] = {"lesson.back", "lesson.hint", "lesson.next", "lesson.leave", "lesson.report"};
constexpr int kFramesAShare = 10;
constexpr int kTextPercent = 45;                    // of the room, where text and questions ask for more than there is
constexpr const char* kSecondRow = "lesson.leave";  // the second row begins with it; the name field is between

}  // namespace

LessonPage::LessonPage(LessonRun& run, Actions& actions, QWidget* parent)
    : QWidget(parent),
      run_(run),
      actions_(actions),
      lesson_(messageLabel("panel.lessons.lesson", tr("Lesson"), "quiet", this)),
      title_(messageLabel("panel.lessons.step", tr("Step"), "section", this)),
      text_(new PageView(this)),
      checks_(makeChecks()),
      servo_(messageLabel("panel.lessons.servo", tr("Servo"), "amber", this)),
      name_(new QLineEdit(this)),
      note_(messageLabel("panel.lessons.note", tr("Report"), "quiet", this)) {
  nameWidget(text_, "panel.lessons.text", tr("Text of the step"));
  text_->setFrameShape(QFrame::NoFrame);
  nameWidget(name_, "panel.lessons.name", tr("Name in the report"));
  name_->setMaxLength(100);
  name_->setPlaceholderText(tr("Name in the report (optional)"));
  name_->setToolTip(tr("Written to the report only and saved nowhere else."));
  note_->hide();
  auto* const column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 12, 8);
  column->setSpacing(4);
  column->addWidget(lesson_);
  column->addWidget(title_);
  column->addWidget(text_);
  column->addWidget(scroll_ = panelScroll(makeContent(), this), 1);
  column->addWidget(servo_);
  addButtons(column, actions);
  column->addWidget(note_);
}

QWidget* LessonPage::makeContent() {
  auto* const content = new QWidget(this);
  auto* const column = tight<QVBoxLayout>(content, 8);
  column->addWidget(checks_);
  column->addWidget(complete_ = new LessonComplete(actions_, content));
  column->addStretch(1);
  return content;
}

QWidget* LessonPage::makeChecks() {
  auto* const content = new QWidget(this);
  auto* const column = tight<QVBoxLayout>(content, 4);
  column->setAlignment(Qt::AlignTop);
  return content;
}

void LessonPage::addButtons(QVBoxLayout* column, Actions& actions) {
  QHBoxLayout* row = nullptr;
  for (const char* const name : kButtons) {
    if (row == nullptr || QString(name) == kSecondRow) {
      if (row != nullptr) column->addWidget(name_);
      column->addLayout(row = new QHBoxLayout);
      row->setSpacing(8);
    }
    QAction* const action = actions.find(name);
    auto* const button = new QToolButton(this);
    button->setDefaultAction(action);
    nameWidget(button, QString("panel.%1").arg(name), action->text().remove('&'));
    button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setProperty("role", "choice");
    row->addWidget(button);
  }
}

void LessonPage::showStep() {
  hinted_ = false;
  frame_ = 0;
  note_->hide();
  for (CheckRow* const row : rows_) delete row;
  rows_.clear();
  if (!run_.isOn()) return;
  const std::vector<lesson::Check>& checks = run_.step().checks;
  for (std::size_t index = 0; index < checks.size(); ++index) {
    auto* const row = new CheckRow(checks[index], index + 1, checks_);
    connect(row, &CheckRow::answered, this, [this, index](double answer) { run_.answer(index, answer); });
    static_cast<QVBoxLayout*>(checks_->layout())->addWidget(row);
    row->show();
    rows_.push_back(row);
  }
  scroll_->verticalScrollBar()->setValue(0);
  orderTabs({this});  // otherwise Tab follows the order of creation
  showText();
  present();
}

/// Text and questions share the room by what is in them: neither is cut while the other has some to spare.
void LessonPage::shareRoom() {
  const int room = scroll_->geometry().bottom() - text_->geometry().top();
  const int text = text_->contentHeight();
  const QWidget& content = *scroll_->widget();
  const int below =
      layout()->spacing() + (content.hasHeightForWidth() ? content.heightForWidth(scroll_->viewport()->width())
                                                         : content.sizeHint().height());
  const int min = 5 * fontMetrics().lineSpacing();
  const int wanted = text + below <= room ? text : std::max({min, room - below, room * kTextPercent / 100});
  const int height = std::min({wanted, text, std::max(min, room - min)});
  // Without this the bar of a text that had less room before stays.
  text_->setVerticalScrollBarPolicy(height >= text ? Qt::ScrollBarAlwaysOff : Qt::ScrollBarAsNeeded);
  if (height != text_->height() || text_->minimumHeight() != height) text_->setFixedHeight(height);
}

void LessonPage::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  QMetaObject::invokeMethod(this, &LessonPage::shareRoom, Qt::QueuedConnection);  // the parts have their sizes by then
}

void LessonPage::showText() {
  QString text = QString::fromStdString(run_.step().text);
  if (hinted_) {
    const QString hint = QString::fromStdString(run_.step().hint);
    text += "\n\n" + tr("**Hint:**") + " " + hint + "\n";
  }
  text_->showPage(text, QFileInfo(run_.path()).absolutePath());
}

void LessonPage::showHead() {
  const std::size_t all = run_.lesson().steps.size();
  const QString where = tr("%1 – step %2 of %3");
  // All at once: a "%2" in the title is text.
  lesson_->setText(
      where.arg(QString::fromStdString(run_.lesson().title), QString::number(run_.at() + 1), QString::number(all)));
  const QString title = QString::fromStdString(run_.step().title);
  title_->setText(run_.isSolved(run_.at()) ? tr("✓ %1 (solved)").arg(title) : title);
}

/// Asks for Start when the servo is stopped and the step is about forces.
QString LessonPage::asksForStart() const {
  if (run_.isServoRunning() || run_.isSolved(run_.at())) return {};
  for (const lesson::Check& check : run_.step().checks) {
    const auto* const hold = std::get_if<lesson::Hold>(&check.task);
    const QString key = hold == nullptr ? QString() : hold->wanted.measure.quantity->key;
    if (key.endsWith("_N") || key == "torque_N_mm")
      return tr("The servo is stopped. Press Start (F5) to feel the force.");
  }
  return {};
}

void LessonPage::present() {
  if (!run_.isOn()) return;
  showHead();
  const std::vector<lesson::CheckState>& states = run_.states(run_.at());
  for (std::size_t index = 0; index < rows_.size() && index < states.size(); ++index) {
    rows_[index]->present(run_.step().checks[index], states[index]);
  }
  complete_->present(run_);
  const QString start = asksForStart();
  if (++frame_ % kFramesAShare == 1) shareRoom();
  servo_->setVisible(!start.isEmpty());
  servo_->setText(start);
}

bool LessonPage::hasHint() const {
  return run_.isOn() && !run_.step().hint.empty() && !hinted_;
}

bool LessonPage::showHint() {
  if (!hasHint()) return false;
  hinted_ = true;
  showText();
  shareRoom();
  text_->moveCursor(QTextCursor::End);
  text_->ensureCursorVisible();
  return true;
}

QString LessonPage::typedName() const {
  return name_->text().trimmed();
}

void LessonPage::clearName() {
  name_->clear();
}

void LessonPage::setNote(const QString& text) {
  showMessage(note_, text);
}

}  // namespace underact::gui
