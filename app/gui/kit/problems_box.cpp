#include "app/gui/kit/problems_box.h"

#include <QMessageBox>

#include "app/gui/kit/words.h"

namespace underact::gui {

void showProblemsBox(const QString& name, const QString& title, const QString& what, const Problems& problems,
                     QWidget* window) {
  QStringList sentences;
  for (const Problem& problem : problems) {
    const QString sentence = sentenceText(problem.sentence);
    sentences << (problem.place.line > 0 ? QObject::tr("Line %1: %2").arg(problem.place.line).arg(sentence) : sentence);
  }
  auto* box = new QMessageBox(QMessageBox::Warning, title, what, QMessageBox::Ok, window);
  box->setObjectName(name);
  box->setInformativeText(sentences.join("\n"));
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setModal(false);
  box->show();
}

}  // namespace underact::gui
