#include "app/gui/guide/notebook.h"

#include <QDesktopServices>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QMessageBox>
#include <QObject>
#include <QPushButton>
#include <QStandardPaths>
#include <QUrl>

#include "app/gui/kit/problems_dialog.h"
#include "app/gui/kit/shipped.h"

namespace underact::gui {
namespace {

/// A notebook of the user's own is opened where it is.
QString copyOf(const QString& original) {
  if (QFileInfo(original).absolutePath() != shippedFolder(system::Resource::Guide)) return original;
  const QDir documents(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation));
  return documents.filePath("Underact/notebooks/" + QFileInfo(original).fileName());
}

/// The copy may have been worked on: then it is that one.
bool makeCopy(const QString& original, const QString& copy) {
  if (QFileInfo::exists(copy)) return true;
  if (!QDir().mkpath(QFileInfo(copy).absolutePath()) || !QFile::copy(original, copy)) return false;
  QFile(copy).setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ReadGroup | QFile::ReadOther);
  return true;
}

void openNotebook(const QString& original, QWidget* parent) {
  const QString copy = copyOf(original);
  std::string reason;
  if (!makeCopy(original, copy))
    reason = QObject::tr("It cannot be copied to %1.").arg(QFileInfo(copy).absolutePath()).toStdString();
  else if (!QDesktopServices::openUrl(QUrl::fromLocalFile(copy)))
    reason = QObject::tr("This computer has no program for notebooks. Open %1 with Jupyter or VS Code.")
                 .arg(copy)
                 .toStdString();
  if (reason.empty()) return;
  showProblemsBox("dialog.notebook_problems", QObject::tr("Notebook"), QObject::tr("The notebook cannot be opened."),
                  {{reason, {}}}, parent);
}

}  // namespace

void askToOpenNotebook(const QString& original, QWidget* parent) {
  auto* box = new QMessageBox(QMessageBox::Question, QObject::tr("Notebook"),
                              QObject::tr("Another program opens this notebook, for example Jupyter or VS Code."),
                              QMessageBox::Cancel, parent);
  box->setObjectName("dialog.notebook");
  const bool is_own = copyOf(original) == original;
  if (!is_own)
    box->setInformativeText(
        QObject::tr("It opens a copy of your own, which keeps your changes:\n%1").arg(copyOf(original)));
  box->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  QPushButton* open =
      box->addButton(is_own ? QObject::tr("Open") : QObject::tr("Open my copy"), QMessageBox::AcceptRole);
  open->setObjectName("dialog.notebook.open");
  QObject::connect(open, &QPushButton::clicked, parent, [original, parent] { openNotebook(original, parent); });
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setModal(false);
  box->show();
}

}  // namespace underact::gui
