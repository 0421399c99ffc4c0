#pragma once
#include <QComboBox>
#include <QString>

namespace underact::gui {

/// On Linux Qt tells a screen reader what is chosen in place of the name: the description has to say the name too.
void nameChooser(QComboBox* box, const QString& spoken, const QString& tip);

/// As narrow as a panel needs it.
QComboBox* chooser(const char* name, const QString& spoken, const QString& tip, QWidget* parent);

}  // namespace underact::gui
