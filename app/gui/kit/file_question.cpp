#include "app/gui/kit/file_question.h"

#include <QFileDialog>
#include <utility>

namespace underact::gui {

void askForFile(QWidget* window, const char* name, const QString& title, const QString& folder, const QString& filter,
                std::function<void(const QString& path)> chosen) {
  auto* dialog = new QFileDialog(window, title, folder, filter);
  dialog->setObjectName(name);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  QObject::connect(dialog, &QFileDialog::fileSelected, dialog, std::move(chosen));
  dialog->open();
}

}  // namespace underact::gui
