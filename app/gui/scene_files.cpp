#include "app/gui/scene_files.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>

#include "app/gui/document.h"
#include "app/gui/problems_dialog.h"
#include "app/gui/scene_library.h"
#include "app/gui/words.h"

namespace underact::gui {
namespace {

QString filterText() {
  return QObject::tr("Scenes (*.json);;All files (*)");
}

// Where a tuned scene is offered to be kept: its own folder, but never the one that came with the program.
QString placeToSave(const Document& document) {
  const bool has_file = !document.path().isEmpty();
  const QFileInfo file(has_file ? document.path() : sceneFolder() + QObject::tr("/recorded.json"));
  const bool shipped = !has_file || file.absolutePath() == sceneFolder();
  const QString folder =
      shipped ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) : file.absolutePath();
  return QDir(folder).filePath(shipped ? file.completeBaseName() + "-tuned.json" : file.fileName());
}

}  // namespace

SceneFiles::SceneFiles(Document& document, RecentFiles& recent, QWidget* window)
    : QObject(window), document_(document), recent_(recent), window_(window), problems_(new ProblemsDialog(window)) {
  connect(problems_, &ProblemsDialog::openAnother, this, &SceneFiles::chooseAndOpen);
}

bool SceneFiles::open(const QString& path) {
  if (!settleEdits()) return false;
  const Problems problems = document_.open(path);
  if (!problems.empty()) {
    problems_->show(path, problems);
    return false;
  }
  problems_->hide();
  if (QFileInfo(document_.path()).absolutePath() != sceneFolder()) recent_.add(document_.path());
  return true;
}

void SceneFiles::chooseAndOpen() {
  auto* dialog = new QFileDialog(
      window_, tr("Open a scene"),
      QFileInfo(document_.path().isEmpty() ? sceneFolder() + "/." : document_.path()).absolutePath(), filterText());
  dialog->setObjectName("dialog.open");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) { open(path); });
  dialog->open();
}

bool SceneFiles::saveAs(const QString& path) {
  const Problems problems = document_.saveAs(path);
  if (problems.empty()) {
    recent_.add(document_.path());
    return true;
  }
  QMessageBox box(QMessageBox::Warning, tr("Scene not saved"), sentencesOf(problems), QMessageBox::Ok, window_);
  box.setObjectName("dialog.not_saved");
  box.exec();
  return false;
}

void SceneFiles::chooseAndSave() {
  auto* dialog = new QFileDialog(window_, tr("Save the tuned scene"), placeToSave(document_), filterText());
  dialog->setObjectName("dialog.save");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix("json");
  dialog->selectFile(QFileInfo(placeToSave(document_)).fileName());
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) { saveAs(path); });
  dialog->open();
}

bool SceneFiles::settleEdits() {
  if (!document_.modified()) return true;
  QMessageBox box(QMessageBox::Question, tr("Tuned gains"),
                  tr("The gains of “%1” were changed.").arg(QString::fromStdString(document_.scene().title)),
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window_);
  box.setObjectName("dialog.unsaved");
  box.setInformativeText(tr("Save them as a scene file, or discard them?"));
  box.setDefaultButton(QMessageBox::Save);
  switch (box.exec()) {
    case QMessageBox::Save:
      return saveBeforeLeaving();
    case QMessageBox::Discard:
      return true;
    default:
      return false;
  }
}

bool SceneFiles::saveBeforeLeaving() {
  const QString path =
      QFileDialog::getSaveFileName(window_, tr("Save the tuned scene"), placeToSave(document_), filterText());
  return !path.isEmpty() && saveAs(path);
}

}  // namespace underact::gui
