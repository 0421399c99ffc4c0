#include "app/gui/lessons/lesson_list.h"

#include <QAction>
#include <QLabel>
#include <QListWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <utility>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/shipped.h"
#include "app/gui/lessons/lesson_card.h"
#include "app/gui/lessons/lesson_library.h"
#include "app/gui/model/data_words.h"
#include "app/gui/model/scene_library.h"
#include "core/lesson/read.h"
#include "core/lesson/stage.h"

namespace underact::gui {
namespace {

/// The number of a card with this title, for screen readers.
QString spokenTitle(const QString& title, int number) {
  return number > 0 ? LessonList::tr("Lesson %1: %2").arg(number).arg(title) : title;
}

}  // namespace

LessonList::LessonList(Shipped shipped, RecentFiles& recent, Actions& actions, QWidget* parent)
    : QWidget(parent),
      recent_(recent),
      actions_(actions),
      shipped_(std::move(shipped)),
      list_(new QListWidget(this)),
      about_(messageLabel("panel.lessons.about", tr("About the selected lesson"), "quiet", this)),
      note_(messageLabel("panel.lessons.why", tr("Why the lesson did not start"), "amber", this)) {
  nameWidget(list_, "panel.lessons.list", tr("Lessons"),
             tr("Enter or a click starts a lesson. Your scene and panels come back when you leave it."));
  list_->setFrameShape(QFrame::NoFrame);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setWordWrap(true);
  list_->setItemDelegate(new LessonCard(list_));
  list_->setResizeMode(QListView::Adjust);
  list_->setSpacing(2);
  about_->setMinimumHeight(3 * fontMetrics().lineSpacing());
  about_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  about_->hide();
  note_->hide();
  auto* const open = new QToolButton(this);
  open->setDefaultAction(actions_.find("lesson.open"));
  nameWidget(open, "panel.lessons.open", tr("Open a lesson file"));
  open->setToolButtonStyle(Qt::ToolButtonTextOnly);
  open->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  open->setFocusPolicy(Qt::StrongFocus);
  auto* const column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 12, 8);
  column->setSpacing(8);
  column->addWidget(
      notFoundLabel(system::Resource::Lessons, "panel.lessons.missing", tr("Why there are no lessons"), this));
  column->addWidget(list_, 1);
  column->addWidget(about_);
  column->addWidget(note_);
  column->addWidget(open);
  connect(list_, &QListWidget::itemClicked, this, &LessonList::open);
  connect(list_, &QListWidget::itemActivated, this, &LessonList::open);
  connect(list_, &QListWidget::currentItemChanged, this, &LessonList::describe);
  connect(&recent_, &RecentFiles::changed, this, &LessonList::rebuild);
}

void LessonList::addHeading(const QString& text) {
  auto* const item = new QListWidgetItem(text, list_);
  item->setFlags(Qt::NoItemFlags);
  QFont font = list_->font();
  font.setBold(true);
  item->setFont(font);
}

void LessonList::addLesson(const lesson::Lesson& lesson, int number) {
  const QString path = QString::fromStdString(lesson.file);
  const auto all = static_cast<int>(lesson.steps.size());
  const int solved = std::min(static_cast<int>(solvedSteps(path).size()), all);
  const QString title = QString::fromStdString(lesson.title);
  const int minutes = qRound(lesson::minutesOf(lesson));
  auto* const item = new QListWidgetItem(title, list_);
  item->setData(LessonCard::Path, path);
  item->setData(LessonCard::About, QString::fromStdString(lesson.about));
  item->setData(LessonCard::Number, number);
  item->setData(LessonCard::Minutes, minutes);
  item->setData(LessonCard::Steps, all);
  item->setData(LessonCard::Solved, solved);
  const QString line = cardLine(minutes, all, solved);
  item->setToolTip(line);
  item->setData(Qt::AccessibleTextRole, tr("%1, %2").arg(spokenTitle(title, number), line));
}

void LessonList::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (is_stale_) rebuild();
}

void LessonList::rebuild() {
  is_stale_ = !isVisible();
  if (is_stale_) return;
  const QListWidgetItem* const current = list_->currentItem();
  const QString kept = current == nullptr ? QString() : current->data(LessonCard::Path).toString();
  list_->clear();
  std::string group;
  int number = 0;
  for (const lesson::Lesson& lesson : shipped_()) {
    if (lesson.group != group) addHeading(QString::fromStdString(group = lesson.group));
    addLesson(lesson, ++number);
  }
  const QStringList recent = recent_.paths();
  if (!recent.isEmpty()) addHeading(tr("Recently opened"));
  for (const QString& path : recent) {
    const Result<lesson::Lesson> read = lesson::readLessonFile(path.toStdString());
    if (read) addLesson(translated(read.value()), 0);
  }
  for (int row = 0; row < list_->count(); ++row) {
    if (!kept.isEmpty() && list_->item(row)->data(LessonCard::Path).toString() == kept) list_->setCurrentRow(row);
  }
}

void LessonList::describe() {
  const QListWidgetItem* const item = list_->currentItem();
  about_->setText(item == nullptr ? QString() : item->data(LessonCard::About).toString());
  about_->setVisible(!about_->text().isEmpty());  // without words its room is the list's
}

// Queued: opening the lesson rebuilds this list.
void LessonList::open(QListWidgetItem* item) {
  const QString path = item->data(LessonCard::Path).toString();
  if (path.isEmpty()) return;
  QMetaObject::invokeMethod(
      this, [this, path] { actions_.perform("lesson.start", path); }, Qt::QueuedConnection);
}

void LessonList::setNote(const QString& text) {
  showMessage(note_, text);
}

}  // namespace underact::gui
