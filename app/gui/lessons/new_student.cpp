#include "app/gui/lessons/new_student.h"

#include <QDir>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>
#include <algorithm>
#include <utility>

#include "app/gui/kit/words.h"
#include "core/system/private_file.h"

namespace underact::gui {
namespace {

QDir reportFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) + "/Underact/reports";
}

}  // namespace

QString newReportFile(const QString& name) {
  const QFileInfo file(reportFolder().filePath(name));
  QString path = file.filePath();
  for (int another = 2; QFileInfo::exists(path) || QFileInfo(path).isSymLink(); ++another)
    path = reportFolder().filePath(QString("%1_%2.%3").arg(file.completeBaseName()).arg(another).arg(file.suffix()));
  return path;
}

void makeReportFolder() {
  static_cast<void>(system::makePrivateFolder(reportFolder().path().toStdString()));
}

bool isEmpty(const lesson::Report& report) {
  return std::none_of(report.steps.begin(), report.steps.end(),
                      [](const lesson::StepReport& step) { return step.solved || step.attempts > 0; });
}

void askForNewStudent(QWidget* window, const QString& report, std::function<void()> agreed) {
  auto* const box = new QMessageBox(QMessageBox::Question, tr("New student"), tr("Begin with a new student?"),
                                    QMessageBox::Cancel, window);
  box->setObjectName("dialog.new_student");
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setTextFormat(Qt::PlainText);
  QString more = tr("The name, the progress and the ticks of all lessons are cleared.");
  if (!report.isEmpty())
    more += "\n\n" + tr("Before that, the report of this lesson is saved as %1.").arg(QDir::toNativeSeparators(report));
  box->setInformativeText(more);
  box->button(QMessageBox::Cancel)->setObjectName("dialog.new_student.cancel");
  box->setEscapeButton(QMessageBox::Cancel);
  QPushButton* const begin = box->addButton(tr("&New student"), QMessageBox::AcceptRole);
  begin->setObjectName("dialog.new_student.begin");
  box->setDefaultButton(QMessageBox::Cancel);
  QObject::connect(begin, &QPushButton::clicked, box, std::move(agreed));
  box->open();
}

}  // namespace underact::gui
