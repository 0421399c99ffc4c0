#include "app/gui/sessions/delete_question.h"

#include <QFileInfo>
#include <QPushButton>

namespace underact::gui {
namespace {

DeleteQuestion* makeQuestion(const char* name, const QString& title, const QString& text, const QString& more,
                             QWidget* window) {
  auto* box = new DeleteQuestion(QMessageBox::Question, title, text, QMessageBox::Cancel, window);
  box->setObjectName(name);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setInformativeText(more);
  box->setDefaultButton(QMessageBox::Cancel);
  box->setEscapeButton(QMessageBox::Cancel);
  box->button(QMessageBox::Cancel)->setObjectName(QString(name) + ".cancel");
  return box;
}

QPushButton* addAnswer(DeleteQuestion* box, const char* name, const QString& text, const QString& spoken,
                       QMessageBox::ButtonRole role) {
  QPushButton* button = box->addButton(text, role);
  button->setObjectName(box->objectName() + "." + name);
  button->setAccessibleName(spoken);
  return button;
}

}  // namespace

DeleteQuestion* askToDelete(const QString& title, const QString& path, QWidget* window) {
  DeleteQuestion* box = makeQuestion(
      "dialog.delete_session", DeleteQuestion::tr("Delete a session"),
      DeleteQuestion::tr("Move “%1” to the bin?").arg(title),
      DeleteQuestion::tr(
          "The file is %1. It stays in the bin until the bin is emptied: until then, anyone with access to the bin can "
          "read and restore it. If a person asks for their data to be erased, delete it permanently.")
          .arg(QFileInfo(path).fileName()),
      window);
  QPushButton* move = addAnswer(box, "move", DeleteQuestion::tr("&Move to the bin"),
                                DeleteQuestion::tr("Move to the bin"), QMessageBox::AcceptRole);
  QPushButton* remove =
      addAnswer(box, "remove", DeleteQuestion::tr("&Delete permanently…"),
                DeleteQuestion::tr("Delete permanently, after confirmation"), QMessageBox::DestructiveRole);
  QObject::connect(move, &QPushButton::clicked, box, &DeleteQuestion::binWanted);
  QObject::connect(remove, &QPushButton::clicked, box, &DeleteQuestion::removalWanted);
  box->open();
  return box;
}

DeleteQuestion* askToRemove(const QString& title, const QString& path, QWidget* window) {
  DeleteQuestion* box = makeQuestion("dialog.remove_session", DeleteQuestion::tr("Delete a session permanently"),
                                     DeleteQuestion::tr("Delete “%1” permanently?").arg(title),
                                     DeleteQuestion::tr("This cannot be undone: the file %1 does not go to the bin. "
                                                        "Exports, plots and backups of it are not removed.")
                                         .arg(QFileInfo(path).fileName()),
                                     window);
  QPushButton* remove = addAnswer(box, "remove", DeleteQuestion::tr("&Delete permanently"),
                                  DeleteQuestion::tr("Delete permanently"), QMessageBox::DestructiveRole);
  QObject::connect(remove, &QPushButton::clicked, box, &DeleteQuestion::removalWanted);
  box->open();
  return box;
}

}  // namespace underact::gui
