#include "app/gui/kit/push_button.h"

#include <QAction>
#include <QPushButton>
#include <QToolButton>

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

QToolButton* iconButton(const QString& name, QAction* does, const QString& spoken, QWidget* parent) {
  auto* made = new QToolButton(parent);
  made->setObjectName(name);
  made->setAccessibleName(spoken);
  made->setToolTip(does->toolTip());
  made->setAutoRaise(true);
  made->setFocusPolicy(Qt::StrongFocus);
  QObject::connect(made, &QToolButton::clicked, does, &QAction::trigger);
  return made;
}

}  // namespace underact::gui
