#include "app/gui/kit/chooser.h"

#include <QWheelEvent>

namespace underact::gui {

void PanelChooser::wheelEvent(QWheelEvent* event) {
  if (hasFocus())
    QComboBox::wheelEvent(event);
  else
    event->ignore();
}

void nameChooser(QComboBox* box, const QString& spoken, const QString& tip) {
  box->setAccessibleName(spoken);
  box->setAccessibleDescription(tip.isEmpty() ? spoken : spoken + ". " + tip);
  box->setToolTip(tip);
}

QComboBox* chooser(const char* name, const QString& spoken, const QString& tip, QWidget* parent) {
  auto* box = new PanelChooser(parent);
  box->setObjectName(name);
  nameChooser(box, spoken, tip);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(12);
  box->setFocusPolicy(Qt::StrongFocus);
  return box;
}

}  // namespace underact::gui
