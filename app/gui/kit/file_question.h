#pragma once
#include <QString>
#include <functional>

class QWidget;

namespace underact::gui {

// Ask for a file without blocking. name: of the dialog, "dialog.open".

/// An existing file.
void askForFile(QWidget* window, const char* name, const QString& title, const QString& folder, const QString& filter,
                std::function<void(const QString& path)> chosen);
/// folder: shown first.
void askForFolder(QWidget* window, const char* name, const QString& title, const QString& folder,
                  std::function<void(const QString& path)> chosen);
/// A file to write. proposal: its path; a bare name is in the documents folder. Its suffix is added to a name typed
/// without one.
void askWhereToSave(QWidget* window, const char* name, const QString& title, const QString& proposal,
                    const QString& filter, std::function<void(const QString& path)> chosen);

}  // namespace underact::gui
