#pragma once
#include <QComboBox>
#include <QString>

namespace underact::gui {

/// On Linux Qt reports the selection to a screen reader instead of the name, so the description includes the name.
void nameChooser(QComboBox* box, const QString& spoken, const QString& tip);

/// Narrow enough for a panel.
QComboBox* chooser(const char* name, const QString& spoken, const QString& tip, QWidget* parent);

}  // namespace underact::gui
