#pragma once
#include <QString>

#include "core/base/result.h"

class QWidget;

namespace underact::gui {

/// A box that says what was not done, and why; nothing keeps anybody from the arm meanwhile. name: of the object.
/// Problems of a file that is read line by line stand with their lines.
void showProblemsBox(const QString& name, const QString& title, const QString& what, const Problems& problems,
                     QWidget* window);

}  // namespace underact::gui
