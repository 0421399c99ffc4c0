#include "app/gui/lessons/lesson_list.h"

#include <QAction>
#include <QLabel>
#include <QListWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/shipped.h"
#include "app/gui/lessons/lesson_library.h"
#include "app/gui/model/data_words.h"
#include "app/gui/model/scene_library.h"
#include "core/lesson/read.h"

namespace underact::gui {
namespace {

constexpr int kPath = Qt::UserRole;
constexpr int kAbout = Qt::UserRole + 1;

}  // namespace

LessonList::LessonList(RecentFiles& recent, Actions& actions, QWidget* parent)
    : QWidget(parent),
      recent_(recent),
      actions_(actions),
      shipped_(shippedLessons()),
      list_(new QListWidget(this)),
      about_(messageLabel("panel.lessons.about", tr("About the selected lesson"), "quiet", this)),
      note_(messageLabel("panel.lessons.why", tr("Why the lesson did not start"), "amber", this)) {
  nameWidget(list_, "panel.lessons.list", tr("Lessons"),
             tr("Enter or a click starts a lesson. Your scene and panels come back when you leave it."));
  list_->setFrameShape(QFrame::NoFrame);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setWordWrap(true);
  about_->setMinimumHeight(3 * fontMetrics().lineSpacing());
  about_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
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
  rebuild();
}

void LessonList::addHeading(const QString& text) {
  auto* const item = new QListWidgetItem(text, list_);
  item->setFlags(Qt::NoItemFlags);
  QFont font = list_->font();
  font.setBold(true);
  item->setFont(font);
}

void LessonList::addLesson(const lesson::Lesson& lesson) {
  const QString path = QString::fromStdString(lesson.file);
  const auto all = static_cast<int>(lesson.steps.size());
  const int solved = std::min(static_cast<int>(solvedSteps(path).size()), all);
  const QString title = QString::fromStdString(lesson.title);
  const QString mark = solved == all ? tr("✓ %1") : solved > 0 ? tr("○ %1 (%2 of %3)") : QString("%1");
  const QString text = solved == all || solved == 0 ? mark.arg(title) : mark.arg(title).arg(solved).arg(all);
  auto* const item = new QListWidgetItem(text, list_);
  item->setData(kPath, path);
  item->setData(kAbout, QString::fromStdString(lesson.about));
  item->setData(Qt::AccessibleTextRole, tr("%1, %2 of %3 steps solved").arg(title).arg(solved).arg(all));
}

void LessonList::rebuild() {
  const QListWidgetItem* const current = list_->currentItem();
  const QString kept = current == nullptr ? QString() : current->data(kPath).toString();
  list_->clear();
  std::string group;
  for (const lesson::Lesson& lesson : shipped_) {
    if (lesson.group != group) addHeading(QString::fromStdString(group = lesson.group));
    addLesson(lesson);
  }
  const QStringList recent = recent_.paths();
  if (!recent.isEmpty()) addHeading(tr("Recently opened"));
  for (const QString& path : recent) {
    const Result<lesson::Lesson> read = lesson::readLessonFile(path.toStdString());
    if (read) addLesson(translated(read.value()));
  }
  for (int row = 0; row < list_->count(); ++row) {
    if (!kept.isEmpty() && list_->item(row)->data(kPath).toString() == kept) list_->setCurrentRow(row);
  }
}

void LessonList::describe() {
  const QListWidgetItem* const item = list_->currentItem();
  about_->setText(item == nullptr ? QString() : item->data(kAbout).toString());
}

// Queued: opening the lesson rebuilds this list.
void LessonList::open(QListWidgetItem* item) {
  const QString path = item->data(kPath).toString();
  if (path.isEmpty()) return;
  QMetaObject::invokeMethod(
      this, [this, path] { actions_.perform("lesson.start", path); }, Qt::QueuedConnection);
}

void LessonList::setNote(const QString& text) {
  showMessage(note_, text);
}

}  // namespace underact::gui
