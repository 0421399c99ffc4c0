#include "app/gui/kit/painted.h"

#include "app/gui/kit/accessible_widgets.h"

namespace underact::gui {

Painted::Painted(const QString& name, const QString& spoken, const QString& tip, QWidget* parent) : QWidget(parent) {
  setAccessibleRole(this, QAccessible::Graphic);
  setObjectName(name);
  setAccessibleName(spoken);
  setToolTip(tip);
}

void Painted::setTheme(const Theme& theme) {
  theme_ = theme;
  update();
}

}  // namespace underact::gui
