#pragma once
#include <QString>
#include <functional>

#include "core/lesson/report.h"

class QWidget;

namespace underact::gui {

/// Where reports are kept that nobody saved elsewhere: a free name for one.
QString newReportFile(const QString& name);
/// Makes the folder of newReportFile(), which its owner alone may enter. Where it cannot be made, nothing can be saved.
void makeReportFolder();

/// Nothing was solved or answered.
bool isEmpty(const lesson::Report& report);

/// Asks whether the next student begins. report: where that of the last one is saved before; empty: it need not be.
void askForNewStudent(QWidget* window, const QString& report, std::function<void()> agreed);

}  // namespace underact::gui
