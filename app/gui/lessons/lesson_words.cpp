#include "app/gui/lessons/lesson_words.h"

#include <underact/version.h>

#include <QDateTime>
#include <QFileInfo>
#include <QLocale>

#include "app/gui/kit/words.h"
#include "core/lesson/check_text.h"

namespace underact::gui {
namespace {

QString reportRow(const QString& head, const QString& cell) {
  return QString("<tr><th>%1</th><td>%2</td></tr>\n").arg(head.toHtmlEscaped(), cell.toHtmlEscaped());
}

QString stepText(const LessonRun& run, std::size_t step) {
  const lesson::Step& its = run.lesson().steps[step];
  QString text = QString("<h2>%1. %2</h2>\n<p><b>%3</b></p>\n")
                     .arg(step + 1)
                     .arg(QString::fromStdString(its.title).toHtmlEscaped(),
                          run.isSolved(step) ? tr("✓ Solved") : tr("○ Not solved"));
  const std::vector<lesson::CheckState>& states = run.states(step);
  if (states.empty() && run.isSolved(step) && !its.checks.empty())
    return text + "<p>" + tr("Solved earlier; no details were kept.").toHtmlEscaped() + "</p>\n";
  text += "<ul>\n";
  for (std::size_t index = 0; index < states.size(); ++index) {
    const std::string* const question = lesson::questionOf(its.checks[index]);
    const QString asked = question == nullptr ? QString() : QString::fromStdString(*question) + " ";
    text += QString("<li>%1</li>\n").arg((asked + checkText(its.checks[index], states[index])).toHtmlEscaped());
  }
  return text + "</ul>\n";
}

}  // namespace

QString checkText(const lesson::Check& check, const lesson::CheckState& state) {
  return (state.solved ? tr("✓ Solved: %1") : tr("○ Not yet: %1")).arg(sentenceText(describeCheck(check, state)));
}

QString lessonReport(const LessonRun& run, const QString& name, const QDateTime& when) {
  const QString title = QString::fromStdString(run.lesson().title);
  std::size_t solved = 0;
  for (std::size_t step = 0; step < run.lesson().steps.size(); ++step) solved += run.isSolved(step) ? 1 : 0;
  QString page = QString(
                     "<!DOCTYPE html>\n<html><head><meta charset=\"utf-8\"><title>%1</title>\n"
                     "<style>body{font-family:sans-serif;max-width:40em;margin:2em auto}"
                     "th{text-align:left;padding-right:1em}h2{font-size:1.1em}</style>\n%2</head><body>\n<h1>%1</h1>\n")
                     .arg(title.toHtmlEscaped(), QString::fromStdString(reportData(run.report(name, when))));
  page += "<table>\n";
  if (!name.isEmpty()) page += reportRow(tr("Name"), name);
  page += reportRow(tr("Date"), QLocale().toString(when, QLocale::LongFormat));
  page += reportRow(tr("Solved"), tr("%1 of %2 steps").arg(solved).arg(run.lesson().steps.size()));
  page += reportRow(tr("Program"), QString("Underact %1").arg(kVersion));
  page += "</table>\n";
  for (std::size_t step = 0; step < run.lesson().steps.size(); ++step) page += stepText(run, step);
  return page + "</body></html>\n";
}

QString reportFileName(const LessonRun& run, const QString& name) {
  const QString who = fileNameOf(name);
  return QFileInfo(run.path()).completeBaseName() + "-report" + (who.isEmpty() ? QString() : "-" + who) + ".html";
}

QString lessonMarkdown(const lesson::Lesson& lesson) {
  std::string page = "# " + lesson.title + "\n\n" + lesson.about + "\n";
  int number = 0;
  for (const lesson::Step& step : lesson.steps) {
    page += "\n## " + std::to_string(++number) + ". " + step.title + "\n\n" + step.text + "\n";
    for (const lesson::Check& check : step.checks) {
      const std::string* const question = lesson::questionOf(check);
      if (question == nullptr) continue;
      page += "\n**" + *question + "**";
      const auto* const choice = std::get_if<lesson::AskChoice>(&check.task);
      if (choice == nullptr) page += " \\_\\_\\_\\_\\_\\_\\_\\_";
      page += "\n\n";
      if (choice != nullptr) {
        for (const std::string& one : choice->choices) page += "☐ " + one + "  \n";  // a break of the line
      }
    }
  }
  return QString::fromStdString(page);
}

}  // namespace underact::gui
