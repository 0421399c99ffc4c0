#pragma once
#include <QString>
#include <functional>

class QWidget;

namespace underact::gui {

// Questions for a place, without waiting for the answer. name: of the dialog, "dialog.open".

/// A file that is there.
void askForFile(QWidget* window, const char* name, const QString& title, const QString& folder, const QString& filter,
                std::function<void(const QString& path)> chosen);
/// folder: where one looks first.
void askForFolder(QWidget* window, const char* name, const QString& title, const QString& folder,
                  std::function<void(const QString& path)> chosen);
/// A file to be written. proposal: its path; a name alone stands among the documents. Its suffix is added to a name
/// that is typed without one.
void askWhereToSave(QWidget* window, const char* name, const QString& title, const QString& proposal,
                    const QString& filter, std::function<void(const QString& path)> chosen);

}  // namespace underact::gui
