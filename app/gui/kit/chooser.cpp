#include "app/gui/kit/chooser.h"

#include "app/gui/kit/focus_wheel.h"

namespace underact::gui {

void nameChooser(QComboBox* box, const QString& spoken, const QString& tip) {
  box->setAccessibleName(spoken);
  box->setAccessibleDescription(tip.isEmpty() ? spoken : spoken + ". " + tip);
  box->setToolTip(tip);
}

QComboBox* chooser(const char* name, const QString& spoken, const QString& tip, QWidget* parent) {
  auto* box = new FocusWheel<QComboBox>(parent);
  box->setObjectName(name);
  nameChooser(box, spoken, tip);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(12);
  box->setFocusPolicy(Qt::StrongFocus);
  return box;
}

}  // namespace underact::gui
