#include "app/gui/lessons/lessons_panel.h"

#include <QAccessible>
#include <QAction>
#include <QDateTime>
#include <QDir>
#include <QMenu>
#include <QPointer>
#include <QPushButton>
#include <QSaveFile>
#include <QSettings>
#include <QStackedWidget>
#include <QUrl>
#include <QVBoxLayout>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/file_question.h"
#include "app/gui/kit/page_print.h"
#include "app/gui/kit/page_view.h"
#include "app/gui/kit/problems_dialog.h"
#include "app/gui/kit/tight_layout.h"
#include "app/gui/kit/words.h"
#include "app/gui/lessons/class_results.h"
#include "app/gui/lessons/lesson_library.h"
#include "app/gui/lessons/lesson_list.h"
#include "app/gui/lessons/lesson_page.h"
#include "app/gui/lessons/lesson_run.h"
#include "app/gui/lessons/lesson_words.h"
#include "app/gui/lessons/new_student.h"
#include "app/gui/model/scene_library.h"

namespace underact::gui {
namespace {

constexpr const char* kRecent = "lessons/recent";

}  // namespace

LessonsPanel::LessonsPanel(const LessonParts& parts, QWidget* parent)
    : Panel(parent),
      parts_(parts),
      recent_(new RecentFiles(this)),
      run_(new LessonRun(parts, *this)),
      pages_(new QStackedWidget(this)) {
  recent_->set(QSettings().value(kRecent).toStringList());
  addActions();
  addStepActions();
  addClassActions();
  pages_->addWidget(list_ = new LessonList([this]() -> const std::vector<lesson::Lesson>& { return shipped(); },
                                           *recent_, parts_.actions, pages_));  // its button is an action's
  pages_->addWidget(page_ = new LessonPage(*run_, parts_.actions, pages_));
  auto* const column = tight<QVBoxLayout>(this);
  column->addWidget(pages_);
  connect(recent_, &RecentFiles::changed, this, [this] { QSettings().setValue(kRecent, recent_->paths()); });
  connect(run_, &LessonRun::changed, this, &LessonsPanel::showState);
  connect(run_, &LessonRun::progressed, page_, &LessonPage::present);
  connect(run_, &LessonRun::progressed, this, &LessonsPanel::presentStage);
  connect(run_, &LessonRun::solved, this, &LessonsPanel::saySolved);
  connect(run_, &LessonRun::problems, this, &LessonsPanel::showProblems);
  connect(&page_->text(), &PageView::asked, this, &LessonsPanel::follow);
  showState();
}

void LessonsPanel::addActions() {
  parts_.actions.add({"lesson.open", tr("&Open a lesson…"), {}, tr("Opens a lesson from a file.")},
                     [this](const QVariantList& path) {
                       if (!path.isEmpty()) return start(path.first().toString());
                       chooseLesson();
                       return true;
                     });
  parts_.actions.add(
      {"lesson.leave", tr("&Leave the lesson"), {}, tr("Restores the scene and the panels from before the lesson.")},
      [this](const QVariantList&) {
        const bool was_on = run_->isOn();
        run_->leave();
        return was_on;
      });
  parts_.actions.add({"lesson.report", tr("Save &report…"), QKeySequence("Ctrl+Shift+S"),
                      tr("Saves what you did and measured in the lesson as a web page.")},
                     [this](const QVariantList& path) {
                       if (!path.isEmpty()) return saveReport(path.first().toString());
                       chooseReport();
                       return true;
                     });
  parts_.actions
      .add({"lesson.all", tr("&All lessons"), QKeySequence("Shift+F8"), tr("Begins one of the lessons that ship.")},
           [this](const QVariantList&) {
             bringForward();
             return true;
           })
      ->setMenu(makeMenu());
  parts_.actions.add(
      {"lesson.after", tr("Ne&xt lesson"), QKeySequence("Ctrl+F8"), tr("Begins the lesson that comes after this one.")},
      [this](const QVariantList&) {
        const lesson::Lesson* const after = run_->isOn() ? lessonAfter(shipped(), run_->path()) : nullptr;
        return after != nullptr && start(QString::fromStdString(after->file));
      });
  parts_.actions.addCommand("lesson.start",
                            [this](const QVariantList& name) { return start(lessonPath(name.value(0).toString())); });
  parts_.actions.addChoices([this] {
    std::vector<Choice> lessons;
    for (const lesson::Lesson& one : shipped())
      lessons.push_back(
          {QString::fromStdString(one.title), tr("Lesson"), "lesson.start", QString::fromStdString(one.file)});
    return lessons;
  });
  parts_.actions.addCommand("lesson.answer", [this](const QVariantList& values) {  // number of the check, answer
    const int check = values.value(0).toInt();
    return values.size() == 2 && check > 0 && run_->answer(static_cast<std::size_t>(check - 1), values[1].toDouble());
  });
}

const std::vector<lesson::Lesson>& LessonsPanel::shipped() {
  if (!shipped_) shipped_ = shippedLessons();
  return *shipped_;
}

/// The lessons by number, with the first letter of none; filled once it is opened.
QMenu* LessonsPanel::makeMenu() {
  auto* const menu = new QMenu(tr("All lessons"), this);
  menu->setObjectName("menu.lessons.all");
  connect(menu, &QMenu::aboutToShow, this, [this, menu] {
    if (menu->isEmpty()) fillMenu(*menu);
  });
  return menu;
}

void LessonsPanel::fillMenu(QMenu& menu) {
  int number = 0;
  for (const lesson::Lesson& lesson : shipped()) {
    const QString title = menuText(QString::fromStdString(lesson.title));
    QAction* const action = menu.addAction(tr("%1. %2").arg(++number).arg(title));
    action->setStatusTip(QString::fromStdString(lesson.about));
    connect(action, &QAction::triggered, this,
            [this, path = QString::fromStdString(lesson.file)] { parts_.actions.perform("lesson.start", path); });
  }
}

void LessonsPanel::addStepActions() {
  parts_.actions.add({"lesson.next", tr("&Next"), QKeySequence("F8"), tr("Goes to the next step of the lesson.")},
                     [this](const QVariantList&) { return step(1); });
  parts_.actions.add({"lesson.back", tr("&Back"), QKeySequence("F7"), tr("Goes to the previous step of the lesson.")},
                     [this](const QVariantList&) { return step(-1); });
  parts_.actions.add({"lesson.hint", tr("&Hint"), {}, tr("Shows a hint for this step, below its text.")},
                     [this](const QVariantList&) {
                       const bool shown = page_->showHint();
                       enableActions();
                       return shown;
                     });
}

void LessonsPanel::addClassActions() {
  const auto paper = [this] {
    return PaperPage{QString::fromStdString(run_->lesson().title), lessonMarkdown(run_->lesson()),
                     QFileInfo(run_->path()).absolutePath()};
  };
  parts_.actions.add({"lesson.print", tr("&Print…"), {}, tr("Prints all steps of the lesson with their questions.")},
                     [this, paper](const QVariantList&) {
                       if (run_->isOn()) askToPrint(this, "lesson", paper());
                       return run_->isOn();
                     });
  parts_.actions.add(
      {"lesson.pdf", tr("Save as P&DF…"), {}, tr("Saves all steps of the lesson with their questions as PDF.")},
      [this, paper](const QVariantList&) {
        if (run_->isOn())
          askToSavePdf(this, "lesson", paper(), [this](const QString& path) {
            parts_.actions.perform("notice.tell", tr("Saved as %1.").arg(QFileInfo(path).fileName()), path);
          });
        return run_->isOn();
      });
  parts_.actions.add({"lesson.new_student",
                      tr("New st&udent…"),
                      {},
                      tr("Clears name, progress and ticks for the next student; the report is kept.")},
                     [this](const QVariantList&) {
                       askForNewStudent();
                       return true;
                     });
  parts_.actions.add(
      {"lesson.results", tr("&Class results…"), {}, tr("Makes one table of the reports in a folder, also for Moodle.")},
      [this](const QVariantList& folder) {
        showClassResults(window(), folder.value(0).toString());
        return true;
      });
}

/// But for what changes by itself.
lesson::Report LessonsPanel::doneSoFar() const {
  lesson::Report report = run_->report(page_->typedName(), {});
  report.minutes = 0.0;
  return report;
}

void LessonsPanel::askForNewStudent() {
  const bool is_kept = !run_->isOn() || isEmpty(doneSoFar()) || reportData(doneSoFar()) == saved_;
  const QString report = is_kept ? QString() : newReportFile(reportFileName(*run_, page_->typedName()));
  gui::askForNewStudent(this, report, [this, report] { beginStudent(report); });
}

/// The lesson begins again, as the next student does it, too. report: where it is saved first; empty: nowhere.
bool LessonsPanel::beginStudent(const QString& report) {
  if (!report.isEmpty()) makeReportFolder();
  if (!report.isEmpty() && !saveReport(report)) return false;  // nothing is lost
  forgetSolved();
  page_->clearName();
  saved_.clear();
  if (run_->isOn() && !start(run_->path())) run_->leave();
  list_->rebuild();
  return true;
}

bool LessonsPanel::start(const QString& path) {
  QString why;
  const bool begun = run_->begin(path, why);
  if (!begun) bringForward();  // to show the error
  list_->setNote(begun ? QString() : why);
  if (begun && QFileInfo(path).absolutePath() != lessonFolder()) recent_->add(QFileInfo(path).absoluteFilePath());
  return begun;
}

/// Made on demand: the window has its own for scenes, and its parts have the same object names.
void LessonsPanel::showProblems(const QString& path, const Problems& problems) {
  if (problems_ == nullptr) {
    problems_ = new ProblemsDialog(this);
    problems_->setAttribute(Qt::WA_DeleteOnClose);
    problems_->setWindowTitle(tr("Lesson not opened"));
    problems_->findChild<QPushButton*>("dialog.problems.another")->setAccessibleName(tr("Open another lesson file"));
    connect(problems_, &ProblemsDialog::openAnother, this, &LessonsPanel::chooseLesson);
  }
  problems_->show(path, problems);
}

bool LessonsPanel::step(int by) {
  const auto to = static_cast<std::ptrdiff_t>(run_->at()) + by;
  return run_->isOn() && to >= 0 && run_->go(static_cast<std::size_t>(to));
}

void LessonsPanel::showState() {
  if (run_->isOn()) {
    const bool begins = pages_->currentWidget() != page_;
    const QPointer<QWidget> focus = window()->focusWidget();
    const bool had_focus = page_->isAncestorOf(focus);
    page_->showStep();
    pages_->setCurrentWidget(page_);
    // What had it may be gone with the last step: Qt would go on to any other.
    if (!parts_.view.hasFocus() && (begins || (had_focus && window()->focusWidget() != focus)))
      page_->text().setFocus(Qt::OtherFocusReason);
  } else {
    const bool had_focus = page_->isAncestorOf(window()->focusWidget());
    list_->rebuild();
    pages_->setCurrentWidget(list_);
    if (had_focus) list_->setFocus();
  }
  enableActions();
  is_new_step_ = true;
  presentStage();
}

void LessonsPanel::enableActions() {
  const bool on = run_->isOn();
  const QWidget* const focus = window()->focusWidget();
  const bool had_focus = on && page_ != nullptr && page_->isAncestorOf(focus);
  for (const char* name : {"lesson.leave", "lesson.report", "lesson.print", "lesson.pdf"})
    parts_.actions.find(name)->setEnabled(on);
  parts_.actions.find("lesson.back")->setEnabled(on && run_->at() > 0);
  parts_.actions.find("lesson.next")->setEnabled(on && run_->at() + 1 < run_->lesson().steps.size());
  const lesson::Lesson* const after = on ? lessonAfter(shipped(), run_->path()) : nullptr;
  QAction* const next_lesson = parts_.actions.find("lesson.after");
  next_lesson->setEnabled(after != nullptr);
  next_lesson->setData(after != nullptr ? QString::fromStdString(after->title) : QString());  // for "Lesson complete"
  parts_.actions.find("lesson.hint")->setEnabled(page_ != nullptr && page_->hasHint());
  // The button that had it is grey now: Qt would go on to any other.
  if (had_focus && window()->focusWidget() != focus) page_->text().setFocus(Qt::OtherFocusReason);
}

/// Draws where the tip is to go, and leaves unsaid what a question asks for.
void LessonsPanel::presentStage() {
  Drawing drawing;
  const std::vector<lesson::TargetPlace> targets = run_->targets();
  for (std::size_t index = 0; index < targets.size(); ++index) {
    const bool reached = lesson::isReached(targets[index], run_->states(run_->at()));
    const QString name = targets.size() > 1 ? QString::number(index + 1) : tr("Target");
    drawing.targets.push_back(
        {reached ? tr("✓ %1").arg(name) : name, targets[index].p_WT, targets[index].within_m, reached});
  }
  std::vector<bool> reached;
  for (const DrawnTarget& target : drawing.targets) reached.push_back(target.reached);
  if (is_new_step_ || reached != reached_) parts_.view.draw("lessons", drawing);
  reached_ = std::move(reached);
  const bool hides = run_->asksFor({"solutions", "solutions_within"});
  if (is_new_step_ || hides != hides_counts_) parts_.actions.perform("kinematics.hide_counts", hides);
  hides_counts_ = hides;
  is_new_step_ = false;
}

void LessonsPanel::add(const servo::TickRecord& tick) {
  run_->add(tick);
}

void LessonsPanel::leave() {
  parts_.actions.perform("lesson.leave");
}

void LessonsPanel::present(const servo::Snapshot& snapshot) {
  run_->poll(snapshot);
}

/// Announces it to a screen reader at once.
void LessonsPanel::saySolved() {
  QAccessibleEvent alert(this, QAccessible::Alert);
  QAccessible::updateAccessibility(&alert);
}

void LessonsPanel::follow(const QUrl& link) {
  const QString to = link.path();
  if (link.scheme() == "scene") parts_.actions.perform("scene.open", QDir(sceneFolder()).filePath(to + ".json"));
  if (link.scheme() == "lesson") parts_.actions.perform("lesson.start", to);
  if (link.scheme() == "action") parts_.actions.perform(to);
  if (link.scheme() == "guide")
    parts_.actions.perform("help.guide", link.hasFragment() ? to + "#" + link.fragment() : to);
}

bool LessonsPanel::saveReport(const QString& path) {
  if (!run_->isOn() || path.isEmpty()) return false;
  const QByteArray page = lessonReport(*run_, page_->typedName(), QDateTime::currentDateTime()).toUtf8();
  QSaveFile file(path);  // the whole file or nothing
  const bool saved = file.open(QIODevice::WriteOnly) && file.write(page) == page.size() && file.commit();
  page_->setNote(saved ? tr("Saved as %1.").arg(QDir::toNativeSeparators(path))
                       : tr("Not saved: %1. Choose another folder.").arg(file.errorString()));
  if (saved) saved_ = reportData(doneSoFar());
  if (saved) parts_.actions.perform("notice.tell", tr("Report saved as %1.").arg(QFileInfo(path).fileName()), path);
  return saved;
}

void LessonsPanel::chooseReport() {
  const QString name = reportFileName(*run_, page_->typedName());
  askWhereToSave(this, "dialog.save_lesson_report", tr("Save the report"), name,
                 tr("Web pages (*.html);;All files (*)"), [this](const QString& path) { saveReport(path); });
}

void LessonsPanel::chooseLesson() {
  askForFile(this, "dialog.open_lesson", tr("Open a lesson"), lessonFolder(), tr("Lessons (*.json);;All files (*)"),
             [this](const QString& path) { start(path); });
}

}  // namespace underact::gui
