#include "app/gui/push_button.h"

#include <QPushButton>

namespace underact::gui {

QPushButton* pushButton(const QString& name, const QString& text, const QString& tip, QWidget* parent,
                        const QString& spoken) {
  auto* made = new QPushButton(text, parent);
  made->setObjectName(name);
  made->setAccessibleName(spoken.isEmpty() ? QString(text).remove('&') : spoken);
  made->setToolTip(tip);
  made->setAutoDefault(false);
  return made;
}

}  // namespace underact::gui
