#pragma once
#include <QString>
#include <functional>

class QWidget;

namespace underact::gui {

/// Asks for a file that is there, without waiting for the answer. name: of the dialog, "dialog.open".
void askForFile(QWidget* window, const char* name, const QString& title, const QString& folder, const QString& filter,
                std::function<void(const QString& path)> chosen);

}  // namespace underact::gui
