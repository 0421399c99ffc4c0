#include "app/gui/kit/file_question.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QStandardPaths>
#include <utility>

namespace underact::gui {
namespace {

void askIn(QFileDialog* dialog, const char* name, std::function<void(const QString& path)> chosen) {
  dialog->setObjectName(name);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  QObject::connect(dialog, &QFileDialog::fileSelected, dialog, std::move(chosen));
  dialog->open();
}

}  // namespace

void askForFile(QWidget* window, const char* name, const QString& title, const QString& folder, const QString& filter,
                std::function<void(const QString& path)> chosen) {
  auto* dialog = new QFileDialog(window, title, folder, filter);
  dialog->setFileMode(QFileDialog::ExistingFile);
  askIn(dialog, name, std::move(chosen));
}

void askForFolder(QWidget* window, const char* name, const QString& title, const QString& folder,
                  std::function<void(const QString& path)> chosen) {
  auto* dialog = new QFileDialog(window, title, folder);
  dialog->setFileMode(QFileDialog::Directory);
  dialog->setOption(QFileDialog::ShowDirsOnly);
  askIn(dialog, name, std::move(chosen));
}

void askWhereToSave(QWidget* window, const char* name, const QString& title, const QString& proposal,
                    const QString& filter, std::function<void(const QString& path)> chosen) {
  const QFileInfo file(QDir(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)), proposal);
  auto* dialog = new QFileDialog(window, title, file.absolutePath(), filter);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(file.suffix());
  dialog->selectFile(file.fileName());
  askIn(dialog, name, std::move(chosen));
}

}  // namespace underact::gui
